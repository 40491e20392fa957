// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "endmill/offset/offset_mesh.h"

namespace endmill {

// Two measures of the folded part of an offset. The offset of a ball of radius R reverses
// its orientation where exactly one principal radius of curvature is concave and below R.
// There, and only there, its triangles face down. Both measures therefore agree in the
// limit of small cells.
// Source: [JangKimJeong, fig. 12].

/// Number of triangles whose normal points down: n_z < 0.
std::size_t folded_triangles(const TriangleMesh& mesh);

/// Number of contacts at which exactly one principal curvature is below -1 / R, that is
/// concave with a radius below that of the ball.
/// \param offset for a ball of radius R, without contacts on the boundary.
/// \param surfaces the part.
std::size_t too_concave_contacts(const OffsetMesh& offset,
                                 std::span<const Surface> surfaces);

}  // namespace endmill
