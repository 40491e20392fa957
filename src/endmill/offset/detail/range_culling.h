// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/offset/offset_mesh.h"

namespace endmill {

// Range culling: only an object whose range of t contains the position of a plane can
// cross it. The paper culls strips of the grid; the slicer of this library culls
// triangles. These functions count the pairs that remain in each case, for an offset of
// one surface without contacts on the boundary.
// Source: [JangKimJeong, fig. 9].

/// Number of pairs of a range and a plane t = c with low <= c < high.
std::size_t culled_pairs(std::span<const Interval> ranges,
                         std::span<const double> planes);

/// The range of t of each cell of the grid, in mm. A cell has two consecutive triangles.
std::vector<Interval> cell_ranges(const OffsetMesh& offset, const DriveFrame& frame);

/// The range of t in mm of each strip between neighbouring lines u = const.
/// \param offset of a surface with 0 <= u <= 1.
/// \param frame the coordinates of the feed.
/// \param grid_lines number of lines u = const, at least 2.
std::vector<Interval> strip_ranges(const OffsetMesh& offset, const DriveFrame& frame,
                                   int grid_lines);

}  // namespace endmill
