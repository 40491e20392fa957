// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A mesh whose points lie on a surface.
struct SampledSurface {
    TriangleMesh mesh;          ///< counter-clockwise seen from the tool's side
    std::vector<Vec3> normals;  ///< the surface's at each point, unit, on that side
    double max_chord_error_mm;  ///< from a point of the surface to the mesh
};

/// The most triangles that a sampling may have unless told otherwise, and the most of all.
inline constexpr std::size_t most_sampled_triangles = 100'000'000;
inline constexpr std::size_t most_possible_triangles = 2'000'000'000;

/// A chord tolerance in mm to begin with: a thousandth of the longest side of the box
/// around `surfaces`, rounded down to one digit.
double default_chord_tolerance(std::span<const Surface> surfaces);

/// Samples `surfaces` so that no point of them lies further than `chord_tolerance` from
/// the mesh: each patch by 2^a by 2^b cells, the fewest that a bound on its second
/// partials allows. `max_chord_error_mm` is that bound, never below the true error but
/// for rounding.
///
/// Watertight within each surface; also where surfaces meet, or a surface its own seam,
/// if their sides have the same points at the same shares of their length of parameter
/// (patches with common control points have); points nearer than 1e-9 of the largest
/// diagonal are made one there. Where a surface has a gap at a border of patches, so has
/// the mesh. Triangles at a pole that would have no area are left out; the normal there is
/// its limit if all triangles have the same, or else the mean of the triangles'. At a crease it is that of the patch
/// with the larger parameters.
///
/// \param chord_tolerance in mm.
/// \param sides           from tool_side_signs.
/// \throws DomainError unless 0 < chord_tolerance is finite and there is a side for each
/// surface.
/// \throws LimitError if there are more than `most_triangles`, before they are made.
SampledSurface sampled(std::span<const Surface> surfaces, std::span<const double> sides,
                       double chord_tolerance,
                       std::size_t most_triangles = most_sampled_triangles);

/// Samples each of `surfaces` at `lines` by `lines` places, evenly over its ranges of u
/// and v, whatever its patches. `max_chord_error_mm` is measured at 4 by 4 places a cell,
/// each against the cell's two triangles at equal parameters, and is not a bound.
/// \throws DomainError unless lines >= 2 and there is a side for each surface; LimitError
/// as above.
SampledSurface sampled_on_grid(std::span<const Surface> surfaces,
                               std::span<const double> sides, int lines,
                               std::size_t most_triangles = most_sampled_triangles);

}  // namespace endmill
