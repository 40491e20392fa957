// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/path/tool_path.h"
#include "endmill/stock/detail/tool_pieces.h"
#include "endmill/stock/stock_history.h"
#include "endmill/verification/detail/tool_runs.h"

namespace endmill {

/// The motions of all cutters along a path, and of all shanks and holders. They are
/// divided until each piece turns little, so that the bounding volumes are tight, and until
/// each piece sinks so little along its axis that the cutter has cleared the place before a
/// body that is not wider reaches it.
struct TurningMotions {
    std::vector<ToolPiece> cutters;  ///< in the order of cutting
    std::vector<ToolPiece> bodies;  ///< a piece of each body for each piece of its cutter
    /// The same of the necks: the cylinder of a cutter from its cutting length to the first
    /// cylinder of its shank or holder above, without end if there is none. A neck must not
    /// touch the stock. It is thinner by `neck_clearance`.
    std::vector<ToolPiece> necks;
};

/// Difference in mm between the radii of a cutter and of its neck, so that a neck that
/// slides along a wall cut before does not count as a contact.
inline constexpr double neck_clearance = 0.01;

/// Returns the motions along a path.
/// \param path whole, with the machine that interpolates it; it must outlive the motions.
/// \param runs of this path.
/// \throws GeometryError if the axes of two neighbouring points are opposite, or not unit
///         vectors.
TurningMotions motions_along(const ToolPath& path, std::span<const ToolRun> runs);

/// Returns the motions of the cutters of earlier runs, in the order of cutting.
/// \param history must outlive the motions.
/// \param point the number of a path point that all of them get, not negative.
/// \throws GeometryError as `motions_along`.
std::vector<ToolPiece> earlier_motions(const TurningHistory& history, std::int32_t point);

}  // namespace endmill
