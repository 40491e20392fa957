// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// How far a region is cut over its border.
struct RegionBorder {
    double width;  ///< mm, at least 0
    /// Whether a facet outside the region may be cut with it.
    std::function<bool(std::size_t facet)> may_cut;
};

/// The facets of a region, and a strip of about `border.width` mm over its border, on the facets
/// that may be cut and do not turn by more than half a radian at the edge. A facet that is
/// wider than the strip is divided.
/// \param part   neighbours share points.
/// \param facets of the region, ascending.
TriangleMesh region_mesh(const TriangleMesh& part, std::span<const std::size_t> facets,
                         const RegionBorder& border);

}  // namespace endmill
