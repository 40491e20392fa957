// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/visibility.h"

/// \file
/// Assigns the facets of a part to the directions from which they are cut, for a machine that
/// turns the part between cuts (3+2 axes).

namespace endmill {

/// Options of `setup_regions`.
struct SetupRegionOptions {
    /// Radius R of the cutter in mm, above 0. A region smaller than (2R)^2 joins a neighbour.
    double cutter_radius = 5;
    /// Facets that are not cut, ascending. They hide others as all facets do.
    std::span<const std::size_t> skipped = {};
    /// Whether the cutter reaches a facet along a direction. If set, a direction that does so
    /// comes before all others that see the facet.
    std::function<bool(std::size_t facet, std::size_t direction)> reaches = {};
};

/// The direction from which each facet is cut.
struct SetupRegions {
    /// Number of the direction for each facet; nothing for a facet that is skipped, has no
    /// area, or is not seen.
    std::vector<std::optional<std::size_t>> direction_of;
    std::vector<std::size_t> uncovered;  ///< facets that no direction sees, ascending
    std::size_t joined_regions = 0;      ///< small regions that joined a neighbour
    VisibilityMap seen;                  ///< which facets each direction sees

    /// The facets of a direction, ascending.
    std::vector<std::size_t> facets_of(std::size_t direction) const;
};

/// Assigns each facet to the direction v with the largest n . v of those that see it. Of
/// products within 1e-9 the first direction counts, so that a plane is not torn apart. A
/// direction along which the cutter reaches the facet is preferred to one that only sees it.
///
/// A direction sees a facet if n . v > 1e-6 and the ray from its centroid along v meets no
/// other facet, as in `part_visibility`. Facets of one direction that are connected by edges
/// are a region. A region smaller than (2R)^2 joins the neighbour with the longest common
/// border of those whose direction sees all its facets, the smallest region first.
/// Source: docs/methods/five-axis-planning.md, section 6.
/// \param part       closed and oriented outwards; neighbours share points.
/// \param directions unit to 1e-9, at least one.
/// \throws DomainError unless the radius is above 0, the directions are unit vectors and the
///         skipped facets are facets of the part.
SetupRegions setup_regions(const TriangleMesh& part, std::span<const Vec3> directions,
                           const SetupRegionOptions& options);

}  // namespace endmill
