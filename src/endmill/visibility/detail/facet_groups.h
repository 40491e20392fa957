// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/core/detail/lanes.h"
#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/detail/part_facets.h"
#include "endmill/visibility/detail/point_cells.h"

namespace endmill {

/// Up to eight facets close to each other, one for each lane of a SIMD register.
struct FacetGroup {
    int count;  ///< number of facets; further lanes repeat the last facet
    std::array<std::int32_t, float_lanes> facet;  ///< numbers of the facets
    /// [corner]: point numbers.
    std::array<std::array<std::int32_t, float_lanes>, 3> corner;
};

/// The unit normals of the facets of a group, rounded to floats; 0 in further lanes.
struct alignas(32) GroupNormals {
    std::array<float, float_lanes> x{};
    std::array<float, float_lanes> y{};
    std::array<float, float_lanes> z{};
};

/// The centroids of the facets of a group, mm; 0 in further lanes.
struct alignas(32) GroupCentroids {
    std::array<double, float_lanes> x{};
    std::array<double, float_lanes> y{};
    std::array<double, float_lanes> z{};
};

/// Up to eight groups that follow each other. Their facets are the bits of a word: bit k
/// stands for lane k % 8 of group k / 8.
struct FacetCluster {
    static constexpr int size = 64;  ///< largest number of facets

    std::uint64_t facets = 0;  ///< a bit for each facet
    /// The facets whose normal is known to 1e-7.
    std::uint64_t well_shaped = 0;
    Vec3 centre = Vec3::Zero();  ///< mm, of the box around the facets
    Vec3 half = Vec3::Zero();    ///< mm, half the sides of the box
};

/// The facets of a part that have an area, in groups that are close to each other in
/// space and in memory, whatever the order of the part's facets is.
struct FacetGroups {
    std::vector<Vec3> points;  ///< mm, points of the part in the order of their first use
    std::vector<FacetGroup> groups;
    std::vector<GroupNormals> normals;      ///< of each group
    std::vector<GroupCentroids> centroids;  ///< of each group
    std::vector<FacetCluster> clusters;
};

/// For each of three limits the facets of up to eight groups whose normal has a larger
/// scalar product with a direction, computed in floats; bits as in FacetCluster.
std::array<std::uint64_t, 3> facets_above(std::span<const GroupNormals> groups,
                                          const Eigen::Vector3f& direction,
                                          const std::array<float, 3>& limits);

/// The projected centroids of a group, computed in doubles and rounded.
/// \param rows scaled rotation of the projection. \param centre mm, is projected to 0.
PlaceLanes projected(const GroupCentroids& centroids, const Eigen::Matrix3d& rows,
                     const Vec3& centre);

/// Groups the facets of a part.
/// \param part facets in mm. \param facets properties of the facets of `part`.
FacetGroups facet_groups(const TriangleMesh& part, const PartFacets& facets);

}  // namespace endmill
