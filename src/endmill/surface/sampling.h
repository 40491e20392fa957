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
    TriangleMesh mesh;  ///< counter-clockwise seen from the tool's side
    /// Unit normal of the surface at each point, on the tool's side.
    std::vector<Vec3> normals;
    /// Largest distance in mm of a point of the surface from the mesh.
    double max_chord_error_mm;
};

/// The default of the largest number of triangles of a sampling.
inline constexpr std::size_t most_sampled_triangles = 100'000'000;
/// The largest number that can be chosen.
inline constexpr std::size_t most_possible_triangles = 2'000'000'000;

/// The default chord tolerance in mm: a thousandth of the longest side of the bounding
/// box of `surfaces`, rounded down to one digit.
double default_chord_tolerance(std::span<const Surface> surfaces);

/// Samples `surfaces` so that no point of them is further than `chord_tolerance` from the
/// mesh. Each patch is divided into 2^a by 2^b cells. A bound on the second partial
/// derivatives determines the smallest number of cells. `max_chord_error_mm` is the error
/// bound that follows; except for rounding it is never below the true error.
///
/// The mesh is watertight within each surface. It is also watertight where surfaces meet,
/// or where a closed surface meets itself, if both sides have the same points at the same
/// shares of their parameter ranges. Patches with common control points satisfy this.
/// Points closer than 1e-9 of the largest diagonal are merged there. A gap at a border of
/// patches remains a gap.
///
/// Triangles at a pole that would have no area are left out. The normal at a pole is its
/// limit if all its triangles have the same, otherwise the mean of their normals. The
/// normal at a crease is that of the patch with the larger parameters.
///
/// \param surfaces of the part.
/// \param sides from tool_side_signs.
/// \param chord_tolerance in mm.
/// \param most_triangles limit on the size of the result.
/// \throws DomainError unless chord_tolerance is finite and positive and there is a side
///         for each surface.
/// \throws LimitError before the triangles are made, if there would be more than
///         `most_triangles`.
SampledSurface sampled(std::span<const Surface> surfaces, std::span<const double> sides,
                       double chord_tolerance,
                       std::size_t most_triangles = most_sampled_triangles);

/// Samples each of `surfaces` at `lines` by `lines` places, evenly over its ranges of u
/// and v, regardless of its patches. `max_chord_error_mm` is measured, not bounded: 4 by
/// 4 places of each cell are compared with the cell's two triangles at equal parameters.
/// \param surfaces of the part.
/// \param sides from tool_side_signs.
/// \param lines number of grid lines along each parameter.
/// \param most_triangles limit on the size of the result.
/// \throws DomainError unless lines >= 2 and there is a side for each surface.
/// \throws LimitError before the triangles are made, if there would be more than
///         `most_triangles`.
SampledSurface sampled_on_grid(std::span<const Surface> surfaces,
                               std::span<const double> sides, int lines,
                               std::size_t most_triangles = most_sampled_triangles);

}  // namespace endmill
