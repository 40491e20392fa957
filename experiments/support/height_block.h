// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A block whose top has given heights, closed and oriented outwards.
struct HeightBlock {
    TriangleMesh mesh;                ///< mm; the triangles of the top come first
    std::vector<std::size_t> others;  ///< triangles of sides and bottom, ascending
};

/// Makes a block over the square of the half side `half`, mm, from the level `bottom`, mm,
/// with `steps` by `steps` squares of two triangles on its top.
/// \param height mm, of (x, y); above the bottom.
HeightBlock height_block(double half, double bottom, int steps,
                         const std::function<double(double x, double y)>& height);

}  // namespace endmill
