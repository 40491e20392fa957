// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/cutter/tool.h"
#include "endmill/deviation/deviation.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"
#include "endmill/stock/removal.h"
#include "endmill/stock/stock_history.h"
#include "endmill/verification/detail/earlier_gouge.h"
#include "endmill/verification/detail/finer_contacts.h"
#include "endmill/verification/part_collisions.h"

namespace endmill {

/// The box of the part, widened by the cutter's radius sideways, from 1 mm below the
/// lowest of part and tips to 1 mm above the part; without a part that of the tips, up to
/// the highest of them. Tips are those of moves that cut, both ends of cuts and links and
/// the lower end of plunges.
/// Source: spec of the removal, section 3.
/// \throws GeometryError if there is neither a part nor a tip.
Block default_block(const Part* part, const ToolPath& path, const Cutter& cutter);

/// What a path leaves of the default block on the part, as `measure_deviation` tells it.
/// \param options those of `measure_deviation`, but `stock`, which is the block.
Deviation deviation_in_block(const Part& part, const ToolPath& path, const Cutter& cutter,
                             DeviationOptions options);

/// What is to be judged. The part and the path must outlive it.
struct VerificationTask {
    const ToolPath* path;  ///< along +z
    Cutter cutter;
    std::vector<ToolCylinder> body = {};  ///< shank and holder
    const Part* part = nullptr;           ///< none: only the removal is reported
    Block block;  ///< the stock, if there is no other, and what it is within
    const HeightStock* stock = nullptr;     ///< an earlier rest, or a mesh
    const StockHistory* history = nullptr;  ///< of `stock`, if it is known
    double resolution = 0.1;                ///< pitch of stock and first rays, mm
    double max_memory_gib = 8;              ///< LimitError beyond it
    double extra_bytes_per_cell = 0;  ///< of the stock, that its rest will be turned into
    DeviationOptions deviation = {};  ///< `stock`, `pitch` and `most_cells` are set
};

/// What a path did to stock and part. Moves have the number of the point to which they
/// lead, as a sweep's number in `deviation`.
struct Verification {
    std::optional<Deviation> deviation;  ///< none without a part
    Removal removal;  ///< rapid cuts and collisions are those of `contacts`
    StockContacts contacts;
    PartCollisions part_collisions;  ///< none without a part
    /// Of the runs that made the stock, judged with the path; none if they are not known.
    std::optional<std::size_t> earlier_moves = {};
    EarlierGouge earlier_gouge;  ///< none where the stock's history is known
    HeightStock rest;
    Verdict verdict;
};

/// How the rest that `task` leaves came to be.
/// \return nothing if that is not known of the stock it begins with.
std::optional<StockHistory> history_of_rest(const VerificationTask& task);

/// Removes the material and measures what is left against the part.
///
/// A stock whose history is known is measured by that: what earlier runs have cleared is
/// judged with what the path clears, by the same rays and bounds, as if all were one path.
/// `deviation` does not tell earlier sweeps apart from one another: places that they made
/// have the number `earlier_sweep`. Of other stocks only heights are known: a gouge
/// in them counts as far as they tell for certain, and one that they leave possible, beyond
/// the tolerance, leaves the verdict `Undecided`.
///
/// A rapid that cuts, and
/// a shank or holder in the material or in the part, make the verdict `Gouged`; one that
/// may be in the part, for all that is known, leaves it `Undecided`.
/// Source: spec of the removal, section 3.
/// \throws GeometryError if the path cuts nothing over the part, whatever the resolution,
/// with the gap between them, or an axis is not +z; LimitError, with a resolution that fits, if the memory
/// would not do; DomainError for limits out of range.
Verification verify_path(const VerificationTask& task);

}  // namespace endmill
