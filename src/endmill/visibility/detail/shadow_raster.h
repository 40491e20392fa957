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

/// Finds for one direction after the other which facets lie in the shadow of others: seen
/// along the direction, the centroids in question are sorted into cells, and groups of facets
/// darken those that they cover and lie above. In single precision with bounds on every
/// error; what is within them is decided by `blocks_ray`.
///
/// Keeps room for its work, so that a thread has one of its own: 45 bytes a facet in question,
/// 16 a point. Part and groups must outlive it.
class ShadowRaster {
public:
    /// Sees the part `part`, of which `groups` are the facets.
    ShadowRaster(const TriangleMesh& part, const FacetGroups& groups);

    /// Clears the bits of those facets of which the ray from the centroid along `direction`
    /// meets another facet, as `blocks_ray` has it. \pre `direction` is unit to 1e-9.
    void clear_blocked(const Vec3& direction, std::span<std::uint64_t> column);

private:
    void look_along(const Vec3& direction);
    void gather(std::span<const std::uint64_t> column);
    void decide(const Vec3& direction);
    void clear_dark(std::span<std::uint64_t> column) const;

    const TriangleMesh* part_;
    const FacetGroups* groups_;
    Vec3 centre_;      // mm
    double scale_;     // seen coordinates a mm: within 1 of the centre
    double accuracy_;  // of seen coordinates
    Eigen::Matrix3d rows_ = Eigen::Matrix3d::Zero();  // of a direction, scaled
    std::vector<Eigen::Vector4f> corners_;  // seen along the direction, the last is 0
    std::vector<NumberedPoint> points_;
    PointCells cells_;
    Darkness darkness_;
};

}  // namespace endmill
