// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/tool.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/part.h"
#include "endmill/verification/verification_result.h"

namespace endmill {

/// Whether a cylinder of the body reaches out of the cutter, which is open above. A
/// cylinder inside the cutter touches no part that the cutter does not gouge.
bool reaches_out(const ToolCylinder& cylinder, const Cutter& cutter);

/// Finds the contacts of `body`, open above, with the part along `path`.
///
/// A mesh is tested by its own triangles. A surface is approximated by triangles with a
/// known distance from it. Each pass uses finer triangles for the moves that the pass
/// before left undecided, until the distance is below half the slack or the triangles
/// exceed the memory. The depth is a concave function of the place on a triangle, so its
/// tangent planes bound it (paper/notes/body-contacts.md). The result is the same with
/// any number of threads.
///
/// All moves count, rapids too. The first point counts if the cutter comes down there.
/// Cylinders inside the cutter are ignored.
/// \param path tips along +z.
/// \param body cylinders of shank and holder, each with a positive diameter.
/// \param most_bytes memory for the triangles of a surface.
/// \throws GeometryError if the axis of a point is not +z.
PartCollisions part_collisions(const Part& part, const ToolPath& path,
                               const Cutter& cutter, std::span<const ToolCylinder> body,
                               double most_bytes = 5e8);

}  // namespace endmill
