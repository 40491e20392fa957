// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <variant>

#include "endmill/core/tolerance.h"
#include "endmill/core/vec.h"
#include "endmill/deviation/deviation.h"
#include "endmill/stock/dexel_stock.h"
#include "endmill/stock/height_stock.h"
#include "endmill/stock/removal.h"

/// \file
/// The result of `verify_path`: deviation, removal, contacts of shank and holder
/// with stock and part, gouges of earlier runs, and the verdict on all of them.

namespace endmill {

/// Largest bound, in mm, at which no contact is undecided: the slack for rounding, plus
/// the same for the distance between the part and the triangles that approximate it.
inline constexpr double closed_contact_bound = 2 * part_contact_slack;

/// The deepest contact of shank or holder with the part.
struct DeepestContact {
    Vec3 point;        ///< on the part, mm
    std::size_t move;  ///< number of the path point to which the move leads
};

/// Contacts of shank and holder with the part that are deeper than `part_contact_slack`.
struct PartCollisions {
    /// Moves with a contact. The depth of a contact is the shortest distance out of the
    /// cylinder, downwards or sideways.
    MoveCount moves = {};
    std::optional<DeepestContact> deepest = {};  ///< none without a contact
    /// The true greatest depth exceeds the reported one by at most this.
    double error_mm = 0;
    double bound_mm = 0;  ///< a missed contact is at most this deep
};

/// Whether the bound allows a contact that was not found and is deeper than rounding.
bool may_be_in_part(const PartCollisions& found);

/// Forbidden contacts with the stock.
struct StockContacts {
    MoveCount rapid_cuts = {};  ///< rapids that cut
    MoveCount collisions = {};  ///< moves on which shank or holder is in the stock
    /// A cut or contact may be missed if its footprint, seen from above, contains no
    /// circle of this diameter in mm. 0: none can be missed.
    double width_mm = 0;
    /// mm, greatest depth of a contact that is possible but not certain, on a ray of the
    /// stock. Not 0 with five axes only.
    double possible_mm = 0;
    /// Number of the point to which the first move with such a contact leads.
    std::optional<std::size_t> first_possible = {};
};

/// Largest depth in mm of a possible contact with the stock that is ignored. It covers the
/// layer of material whose removal by the move before is not certain.
inline constexpr double ignored_contact = 0.001;

/// Gouge in a stock before the path, if only the heights of the stock are known.
struct EarlierGouge {
    double found_mm = 0;                ///< depth along the part's normal that is certain
    std::optional<Vec3> found_at = {};  ///< its place on the part, mm; none without depth
    /// The true greatest depth exceeds `found_mm` by at most this. A gouge narrower than
    /// a cell is excepted.
    double bound_mm = 0;
};

/// What `verify_path` finds on the part. The sweep numbers of the places in `deviation`
/// are numbers of moves, as in `Verification`.
struct PartFindings {
    DeviationLimits limits;     ///< of the verdict
    Deviation deviation;        ///< of the stock after the path
    PartCollisions collisions;  ///< of shank and holder
    /// None if the stock before the path is a block, or if its history is known.
    std::optional<EarlierGouge> earlier_gouge = {};
};

/// Accuracy of a volume that was removed from dexels.
struct RemovedBounds {
    double bound;   ///< mm^3, error bound on the rays
    double spread;  ///< mm^3, difference of the three fields of rays
};

/// The result of `verify_path`. A move has the number of the point to which it leads.
struct Verification {
    std::optional<PartFindings> on_part = {};  ///< none without a part
    Removal removal;         ///< its rapid cuts and collisions are those of `contacts`
    StockContacts contacts;  ///< with the stock, by rapids, shank and holder
    /// Number of moves of earlier runs that were measured with the path; none if the
    /// history of the stock is not known.
    std::optional<std::size_t> earlier_moves = {};
    /// The stock after the path: heights with three axes, dexels with five.
    std::variant<HeightStock, DexelStock> rest;
    /// Error bound of the removed volume on the rays; none with three axes.
    std::optional<RemovedBounds> removed_bounds = {};
    Verdict verdict;  ///< of `verdict_with_contacts`

    /// The heights of the stock after the path. \pre three axes.
    const HeightStock& heights() const { return std::get<HeightStock>(rest); }
};

/// Returns the verdict on the deviation and all contacts. The first rule that applies
/// decides:
/// 1. `Gouged` if a rapid cuts, or shank or holder is in the stock or in the part; without
///    a part `Collides`.
/// 2. `Undecided` if a bound allows a rapid, shank or holder to be in the stock, shank or
///    holder to be in the part, or an earlier gouge beyond the tolerance, and the verdict on the deviation is not `Gouged`.
/// 3. Otherwise the verdict on the deviation; `NotJudged` without a part.
/// \param found its member `verdict` is not used.
/// Source: docs/methods/removal.md, section 3.
Verdict verdict_with_contacts(const Verification& found);

}  // namespace endmill
