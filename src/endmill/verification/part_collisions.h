// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/tool.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/removal.h"
#include "endmill/surface/part.h"

namespace endmill {

/// mm: shank or holder may be so deep in the part, as one that rests on it is by rounding.
/// What is deeper is found for certain, but for `PartCollisions::bound_mm`.
inline constexpr double part_contact_slack = 0.001;

/// mm: a bound up to this leaves nothing open: the slack, and as much for what the part
/// strays from the triangles that stand for it.
inline constexpr double closed_contact_bound = 2 * part_contact_slack;

/// Where shank or holder is in the part.
struct PartCollisions {
    /// Moves, by the number of the point to which they lead; the depth is the least way
    /// out of the cylinder, down or sideways.
    MoveCount moves = {};
    std::optional<Vec3> deepest_at = {};           ///< on the part, mm
    std::optional<std::size_t> deepest_move = {};  ///< there
    double error_mm = 0;  ///< the deepest is no deeper than was found by more
    double bound_mm = 0;  ///< no contact that was not found is deeper
};

/// Whether a cylinder of the body reaches out of the cutter, which is open above: one that
/// does not touches no part that the cutter does not gouge.
bool reaches_out(const ToolCylinder& cylinder, const Cutter& cutter);

/// Moves `body`, open above, along `path` against the part itself: a surface by triangles
/// of a known distance from it, finer ones for the moves that the coarser leave open,
/// until this is below half the slack or there are too many triangles; a mesh by its own.
/// On every triangle the depth is a concave function of the place, whose tangents bound
/// it. The result is the same for every number of threads.
///
/// All moves count, rapids too, and the first point if the cutter has come down there.
/// What does not reach out of the cutter is left out.
/// \param path tips along +z. Throws like `path_sweeps`.
/// \param most_bytes for the triangles of a surface.
PartCollisions part_collisions(const Part& part, const ToolPath& path,
                               const Cutter& cutter, std::span<const ToolCylinder> body,
                               double most_bytes = 5e8);

}  // namespace endmill
