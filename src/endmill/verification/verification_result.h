// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/core/vec.h"
#include "endmill/deviation/deviation.h"
#include "endmill/stock/height_stock.h"
#include "endmill/stock/removal.h"

/// \file
/// The result of `verify_path`: deviation, removal, contacts of shank and holder
/// with stock and part, gouges of earlier runs, and the verdict on all of them.

namespace endmill {

/// Shank and holder may be this deep in the part, in mm, because a body that rests on the
/// part is that deep by rounding. A deeper contact is found with certainty, up to
/// `PartCollisions::bound_mm`.
inline constexpr double part_contact_slack = 0.001;

/// A bound up to this value, in mm, leaves no contact open: the slack, and the same again
/// for the distance between the part and the triangles that approximate it.
inline constexpr double closed_contact_bound = 2 * part_contact_slack;

/// The deepest contact of shank or holder with the part.
struct DeepestContact {
    Vec3 point;        ///< on the part, mm
    std::size_t move;  ///< number of the path point to which the move leads
};

/// Contacts of shank and holder with the part.
struct PartCollisions {
    /// Moves with a contact. The depth of a contact is the shortest way out of the
    /// cylinder, downwards or sideways.
    MoveCount moves = {};
    std::optional<DeepestContact> deepest = {};  ///< none without a contact
    double error_mm = 0;  ///< error bound of the greatest depth: it is no deeper by more
    double bound_mm = 0;  ///< no contact that was not found is deeper
};

/// Forbidden contacts with the stock.
struct StockContacts {
    MoveCount rapid_cuts = {};  ///< rapids that cut
    MoveCount collisions = {};  ///< moves on which shank or holder is in the stock
    /// Width in mm below which a cut or contact may have been missed: seen from above, it
    /// contains no circle of this diameter. 0 if no move can touch material that is still
    /// there.
    double width_mm = 0;
};

/// Gouge in a stock before the path, if only the heights of the stock are known.
struct EarlierGouge {
    double found_mm = 0;                ///< depth along the part's normal that is certain
    std::optional<Vec3> found_at = {};  ///< its place on the part, mm; none without depth
    /// No gouge is deeper than `found_mm` by more, except a gouge that is narrower than a
    /// cell.
    double bound_mm = 0;
};

/// The result of `verify_path`. A move has the number of the point to which it leads; so
/// has the sweep of a place in `deviation`.
struct Verification {
    std::optional<Deviation> deviation;  ///< none without a part
    Removal removal;         ///< its rapid cuts and collisions are those of `contacts`
    StockContacts contacts;  ///< with the stock, by rapids, shank and holder
    std::optional<PartCollisions> part_collisions;  ///< none without a part
    /// Number of moves of earlier runs that were measured with the path; none if the
    /// history of the stock is not known.
    std::optional<std::size_t> earlier_moves = {};
    /// None if the stock is a block, if its history is known, or if there is no part.
    std::optional<EarlierGouge> earlier_gouge = {};
    HeightStock rest;  ///< the stock after the path
    Verdict verdict;   ///< on all of it, see `verdict_with_contacts`
};

/// Returns the verdict on the deviation and all contacts of `found`, whose own verdict is
/// not read: gouged by a contact, undecided if a bound allows a contact or an earlier
/// gouge beyond the tolerance (unless the deviation is gouged), else the verdict on the
/// deviation. Without a deviation that one is clean.
/// Source: docs/mathematics/removal.md, section 3.
Verdict verdict_with_contacts(const Verification& found, const DeviationLimits& limits);

}  // namespace endmill
