// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "endmill/cutter/engagement.h"
#include "endmill/path/tool_path.h"
#include "endmill/simulation/removal.h"

namespace endmill {

/// What each move took, as a CSV file with a row a point and the columns `point` (from 0
/// in the whole path), `length_mm` of the move that leads to it (0 for the first),
/// `removed_mm3` and `rate_mm3_per_min`. The rate is empty without a feed, for a rapid,
/// which does not go at it, and for a move without length.
/// \throws DomainError unless there is a volume for each point, conditions for none or
///         for all, and every number is finite.
std::string removal_csv(const Removal& removal, const ToolPath& path);

/// The engaged part of the cutter on each move, as a CSV file with a row for each interval
/// of each ring and the columns `point` (from 0 in the whole path), `latitude_deg`,
/// `radius_mm`, `above_tip_mm`, `from_deg` and `to_deg`, as in `Engagement`. Angles are
/// rounded to 1e-9 degrees. Handed out in pieces of a few MiB at most: the rows of a long
/// path need not fit the memory.
class EngagementCsv {
public:
    /// Takes the next piece of the file.
    using Sink = std::function<void(std::string_view piece)>;

    /// \param sink takes the pieces in order; the first begins with the header.
    explicit EngagementCsv(Sink sink);

    /// Adds the rows of the move to point `number`; none if nothing is engaged.
    /// \throws DomainError if a number is not finite.
    void add(std::size_t number, const Engagement& engagement);

    /// Hands out what is left, after the last move.
    void finish();

private:
    Sink sink_;
    std::string text_;  // not handed out yet
};

}  // namespace endmill
