// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/detail/facet_groups.h"
#include "endmill/visibility/detail/point_cells.h"
#include "endmill/visibility/detail/shadow_lanes.h"

namespace endmill {

/// Finds the occluded facets of a part, for one direction after the other.
///
/// 1. Points and centroids are projected along the direction to single precision.
/// 2. The centroids in question are sorted into cells (PointCells).
/// 3. Each group of eight facets is tested against the centroids in its box
///    (ShadowLanes). Most answers are certain within the error bounds.
/// 4. `blocks_ray` decides the uncertain pairs exactly.
///
/// The raster keeps its memory between directions, so that each thread needs its own: 45
/// bytes for each facet in question and 16 for each point. Part and groups must outlive
/// it.
class ShadowRaster {
public:
    /// \param part facets in mm. \param groups of the facets of `part`.
    ShadowRaster(const TriangleMesh& part, const FacetGroups& groups);

    /// Clears the bits of the facets whose ray from the centroid along `direction` meets
    /// another facet, as defined by `blocks_ray`.
    /// \param direction unit to 1e-9. \param column a set bit marks a facet in question.
    void clear_blocked(const Vec3& direction, std::span<std::uint64_t> column);

private:
    void look_along(const Vec3& direction);
    void gather(std::span<const std::uint64_t> column);
    void decide(const Vec3& direction);
    void clear_covered(std::span<std::uint64_t> column) const;

    const TriangleMesh* part_;
    const FacetGroups* groups_;
    Vec3 centre_;      // mm
    double scale_;     // projected length of 1 mm, so that coordinates are within [-1, 1]
    double accuracy_;  // error bound of projected coordinates
    Eigen::Matrix3d rows_ = Eigen::Matrix3d::Zero();  // scaled rotation of the projection
    std::vector<Eigen::Vector4f> corners_;  // projected points; the last entry is 0
    std::vector<NumberedPoint> points_;
    PointCells cells_;
    CoveredPoints covered_;
};

}  // namespace endmill
