// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "endmill/accessibility/visibility_map.h"
#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// What keeps a tool from a facet.
enum class VisibilityKind {
    Local,  ///< the incidence on the facet alone, as in the cones of Woo et al.
    Global  ///< and the other facets, the paper's
};

/// What counts as visible, and who wants to know how far the work is.
struct VisibilityOptions {
    /// Largest angle between a tool axis and the facet's normal, excluded itself; above 0,
    /// at most 90 degrees.
    Angle incidence = Angle::degrees(90);
    VisibilityKind kind = VisibilityKind::Global;  ///< what blocks
    /// Called after each direction with the number of those done, by one thread at a time,
    /// whichever. What it throws ends the work.
    std::function<void(std::size_t done)> progress = {};
};

/// The visibility cones of a part's facets.
struct PartVisibility {
    VisibilityMap map;  ///< a column for each direction
    std::vector<std::size_t>
        dropped;  ///< facets without area: no cone, and nothing blocked
};

/// Which facets are visible along which directions: facet j along C if n_j . C > max(cos
/// omega, 1e-6) and, in the global kind, the ray from its centroid along C meets no other
/// facet. Facets are closed, touching an edge blocks, and they block from both sides.
/// Source: [KangSuh, section 2]; the rule where the paper says no more is ours.
///
/// Occlusion is exact for the doubles of points and directions, with centroids (a + b + c)
/// / 3 that are not rounded. The incidence is compared in doubles: n . C is off by 1e-15 at
/// most, times the square of the facet's longest side by its area.
///
/// Directions are dealt with on all threads, one column each; the answer does not depend on
/// their number. Memory beside the map: some 100 bytes a facet, and on each thread 100 more.
/// \param directions unit to 1e-9: from the part towards the spindle.
/// \throws DomainError if a direction is not, or the incidence outside its range.
/// \throws LimitError if the map does not fit into the memory.
PartVisibility part_visibility(const TriangleMesh& part, std::span<const Vec3> directions,
                               const VisibilityOptions& options = {});

/// The facets that no direction reaches, but for the dropped ones: while there is one, no
/// machine can make the part in one setup.
std::vector<std::size_t> empty_cones(const PartVisibility& visibility);

/// The share of the sphere that each facet's cone has, 0 … 1: the solid angles of its cells
/// by those of all.
/// \param solid_angles_sr of the cells. \throws DomainError unless there is one a cell.
std::vector<double> visible_fractions(const VisibilityMap& map,
                                      std::span<const double> solid_angles_sr);

}  // namespace endmill
