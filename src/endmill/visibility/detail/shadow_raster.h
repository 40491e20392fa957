// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/detail/border_walls.h"
#include "endmill/visibility/detail/box_heights.h"
#include "endmill/visibility/detail/facet_groups.h"
#include "endmill/visibility/detail/part_facets.h"
#include "endmill/visibility/detail/point_cells.h"
#include "endmill/visibility/detail/shadow_lanes.h"

namespace endmill {

/// Finds the facets of a part that are seen along a direction, for one direction after the
/// other.
///
/// 1. Facets cast shadows on the centroids in question. Both are projected along the
///    direction to single precision, and the centroids are sorted into cells
///    (PointCells).
/// 2. Each group of eight facets is tested against the centroids in its box
///    (ShadowLanes). Most answers are certain within the error bounds; `blocks_ray`
///    decides the others exactly.
///
/// Most facets need not cast their shadow. Part and BorderWalls bound a solid. A ray that
/// starts outside and ends far away enters this solid as often as it leaves it. It enters
/// through facets that face away from the viewer and leaves through facets that face him;
/// through walls it does both. So for such a ray
///
/// - it suffices to test the facets that face away, if the net number of walls that it
///   leaves through is 0, and
/// - no facet need be tested if that number is not 0: the ray has met a facet.
///
/// A facet is known to lie outside once a ray from it has met no facet and no wall; until
/// then, all facets are tested. All this holds for a part that overlaps itself, because
/// the solid counts how often it contains a point. A cluster of facets that lie outside is
/// seen if no box of a casting cluster rises above it (BoxHeights).
///
/// The raster keeps its memory between directions, so that each thread needs its own: 50
/// bytes for each facet in question, 16 for each point and 300 for each wall. Part, facets and groups must
/// outlive it.
class ShadowRaster {
public:
    /// \param part facets in mm. \param facets properties of the facets of `part`.
    /// \param groups of the facets of `part`. \param walls of `part`.
    ShadowRaster(const TriangleMesh& part, const PartFacets& facets,
                 const FacetGroups& groups, const BorderWalls& walls);

    /// Sets the bits of the facets with normal . direction > least whose ray from the
    /// centroid along `direction` meets no other facet, as defined by `blocks_ray`.
    /// \param direction unit to 1e-9. \param column all bits are 0.
    void mark_seen(const Vec3& direction, double least, std::span<std::uint64_t> column);

private:
    void choose_rows(const Vec3& direction);
    void find_facing(const Vec3& direction, double least);
    void find_boxes();
    void answer_clusters(std::span<std::uint64_t> column);
    void collect_points();
    void collect_group(std::size_t group);
    void project_corners();
    void cast_shadows(const Vec3& direction);
    bool may_cover_points(const ProjectedBox& box) const;
    void cast_group(std::span<const std::int32_t> places);
    void decide(const Vec3& direction);
    template <typename Visit>
    void for_each_uncovered(const Visit& visit) const;
    std::int32_t facet_at(std::int32_t place) const;
    void mark(std::size_t cluster, std::uint64_t facets,
              std::span<std::uint64_t> column) const;

    const TriangleMesh* part_;
    const PartFacets* facets_;
    const FacetGroups* groups_;
    BorderWalls walls_;
    bool is_closed_;   // part, walls and facets without area bound a solid
    Vec3 centre_;      // mm
    double scale_;     // projected length of 1 mm, so that coordinates are within [-1, 1]
    double accuracy_;  // error bound of projected coordinates
    Eigen::Matrix3d rows_ = Eigen::Matrix3d::Zero();  // scaled rotation of the projection
    std::vector<Eigen::Vector4f> corners_;  // projected points; the last entry is 0
    // Sets of facets: a word for each cluster.
    std::vector<std::uint64_t> asked_;    // in question
    std::vector<std::uint64_t> facing_;   // certainly face the viewer
    std::vector<std::uint64_t> casting_;  // cast their shadows now
    std::vector<std::uint64_t> walled_;   // rays may go through walls
    std::vector<std::uint64_t> outside_;  // known to lie outside
    std::vector<ProjectedBox> boxes_;     // around each cluster
    BoxHeights heights_;                  // of the casting clusters
    std::vector<NumberedPoint> points_;   // numbered by their places in the groups
    PointCells cells_;
    ShadowLanes shadows_;
    CoveredPoints covered_;
};

}  // namespace endmill
