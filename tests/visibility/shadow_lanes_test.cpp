// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/shadow_lanes.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"

namespace endmill {
namespace {

constexpr float accuracy = 0x1p-25F;

Eigen::Vector3f random_place(test::Random& random)
{
    const auto next = [&] { return static_cast<float>(random.uniform(-0.5, 0.5)); };
    return {next(), next(), next()};
}

// Distance of a point inside a triangle's outline, and its depth below the triangle along
// z, in doubles. Negative outside or above.
double insideness(const std::array<Eigen::Vector3f, 3>& corners,
                  const Eigen::Vector3f& point)
{
    std::array<Eigen::Vector3d, 3> at;
    for (int k = 0; k < 3; ++k)
        at[k] = (corners[k] - point).cast<double>();
    const Eigen::Vector3d normal = (at[1] - at[0]).cross(at[2] - at[0]);
    double least = at[0].dot(normal) / normal.z();
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d side = at[(k + 1) % 3] - at[k];
        const double turn = at[k].x() * side.y() - at[k].y() * side.x();
        least = std::min(least, turn * (normal.z() > 0 ? 1 : -1) / side.head<2>().norm());
    }
    return least;
}

TEST(ShadowLanes, CoverPointsInsideTheirOutlineAndBelowTheirPlane)
{
    test::Random random{8};
    std::vector<NumberedPoint> points;
    points.reserve(500);
    for (std::int32_t k = 0; k < 500; ++k)
        points.push_back({random_place(random), 100 + k});
    PointCells cells;
    cells.sort(points);
    ShadowLanes shadows;
    std::vector<std::array<Eigen::Vector3f, 3>> triangles;
    for (int lane = 0; lane < float_lanes; ++lane) {
        triangles.push_back(
            {random_place(random), random_place(random), random_place(random)});
        shadows.facet[lane] = lane;
        for (int k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis)
                shadows.corner[k][axis][lane] = triangles.back()[k][axis];
    }
    prepare_shadows(shadows, accuracy);
    CoveredPoints covered{std::vector<std::uint8_t>(cells.blocks().size(), 0), {}};
    mark_covered(shadows, cells, covered);
    int dark = 0;
    for (std::size_t place = 0; place < points.size(); ++place) {
        const NumberedPoint& point = points[cells.number_at(place) - 100];
        double most = -1;
        for (const auto& triangle : triangles)
            most = std::max(most, insideness(triangle, point.place));
        if (std::abs(most) > 1e-4) {
            EXPECT_EQ(covered.is_covered(place), most > 0);
        }
        dark += covered.is_covered(place) ? 1 : 0;
    }
    EXPECT_GT(dark, 50);
    EXPECT_LT(covered.uncertain.size(), 5U);
}

// The upright facet covers no area; a side of the flat facet passes above the point.
TEST(ShadowLanes, AreUncertainOnSidesAndForUprightFacets)
{
    const std::vector<NumberedPoint> points{{{0, 0, -0.5F}, 7}};
    PointCells cells;
    cells.sort(points);
    ShadowLanes shadows;
    shadows.facet = {3, 4, 7, 7, 7, 7, 7, 7};
    shadows.corner[0] = {{{-0.2F, -0.2F, -0.2F}, {}, {}}};
    shadows.corner[1] = {{{0.2F, 0.2F, 0.2F}, {}, {}}};
    shadows.corner[2] = {{{0.1F, 0.1F, 0.1F}, {0, 0.3F, 0.3F}, {0.4F, 0, 0}}};
    prepare_shadows(shadows, accuracy);
    CoveredPoints covered{{0}, {}};
    mark_covered(shadows, cells, covered);
    EXPECT_FALSE(covered.is_covered(0));
    ASSERT_EQ(covered.uncertain.size(), 2U);  // a facet does not cover its own point
    EXPECT_EQ(covered.uncertain[0].facet, 3);
    EXPECT_EQ(covered.uncertain[1].facet, 4);
    EXPECT_EQ(covered.uncertain[1].place, 0U);
}

}  // namespace
}  // namespace endmill
