// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/part_charts.h"

#include <tuple>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "test_meshes.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(PartCharts, AreAllPatchesOfSurfacesWithNormalsUp)
{
    const Part part = std::vector<Surface>{test::plane(6, 4, {3, 2})};
    const PartCharts charts = part_charts(part);
    EXPECT_EQ(charts.count(), 6U);
    for (std::uint32_t k = 0; k < charts.count(); ++k) {
        const auto ray = charts.ray(k, charts.whole(k).centre());
        ASSERT_TRUE(ray);
        EXPECT_LT((ray->normal - Vec3::UnitZ()).norm(), 1e-15);
    }
}

TEST(PartCharts, OfAMeshLeaveOutUndersides)
{
    const Part part = test::box_mesh({0, 0, 0}, {2, 3, 4});
    const PartCharts charts = part_charts(part);
    EXPECT_EQ(charts.count(), 10U);  // two triangles for the top and for each wall
    for (std::uint32_t k = 0; k < charts.count(); ++k)
        EXPECT_GE(charts.ray(k, {0.3, 0.3})->normal.z(), 0);
}

TEST(PartCell, QuartersHaveItsAreaAndHalfItsReach)
{
    const Part surfaces = std::vector<Surface>{test::plane(6, 4)};
    const Part mesh = test::flat_mesh(1, 1);
    for (const Part* part : {&surfaces, &mesh}) {
        const PartCharts charts = part_charts(*part);
        const PartCell whole = charts.whole(0);
        const PartRay ray = *charts.ray(0, whole.centre());
        double area = 0;
        for (const PartCell& quarter : whole.quarters()) {
            area += quarter.area(ray);
            EXPECT_NEAR(quarter.reach(ray), whole.reach(ray) / 2, 1e-14);
        }
        EXPECT_NEAR(area, whole.area(ray), 1e-13);
    }
}

TEST(PartCharts, HaveTheOuterBorderOfASurface)
{
    const Part part = std::vector<Surface>{test::plane(6, 4, {3, 1})};
    const PartCharts charts = part_charts(part);
    // in the middle of the row; the border is above and below
    PartCell whole = charts.whole(1);
    EXPECT_TRUE(charts.touches_border(whole));
    PartCell inner = whole;
    for (Eigen::Vector2d& at : inner.at)
        at.y() = 0.5 + 0.5 * (at.y() - 0.5);
    EXPECT_FALSE(charts.touches_border(inner));
}

TEST(PartCharts, DoNotEndWhereSurfacesMeet)
{
    const Part part =
        std::vector<Surface>{test::graph(test::monomial(0, 0, 1), {{0, 6}, {0, 4}}),
                             test::graph(test::monomial(0, 0, 1), {{6, 9}, {0, 4}})};
    const PartCharts charts = part_charts(part);
    const auto at_side = [&](std::uint32_t chart, double u) {
        // A narrow cell at the middle of a side.
        return PartCell{chart,
                        4,
                        {Eigen::Vector2d{u, 0.4}, Eigen::Vector2d{0.5, 0.4},
                         Eigen::Vector2d{0.5, 0.6}, Eigen::Vector2d{u, 0.6}}};
    };
    for (const auto& [chart, u, ends] : {std::tuple{0U, 0.0, true},
                                         {0U, 1.0, false},
                                         {1U, 0.0, false},
                                         {1U, 1.0, true}}) {
        EXPECT_EQ(charts.touches_border(at_side(chart, u)), ends) << chart << " " << u;
        EXPECT_TRUE(charts.touches_side(at_side(chart, u)));
    }
    EXPECT_FALSE(charts.touches_side(at_side(0, 0.1)));
}

TEST(PartCharts, OfAMeshEndAtEdgesOfOneTriangle)
{
    const Part closed = test::box_mesh({0, 0, 0}, {2, 3, 4});
    const PartCharts of_closed = part_charts(closed);
    for (std::uint32_t k = 0; k < of_closed.count(); ++k) {
        EXPECT_FALSE(of_closed.touches_border(of_closed.whole(k)));
        EXPECT_TRUE(of_closed.touches_side(of_closed.whole(k)));
    }
    const Part open = test::flat_mesh(1, 1);  // two triangles that share the diagonal
    const PartCharts of_open = part_charts(open);
    for (std::uint32_t k = 0; k < of_open.count(); ++k) {
        EXPECT_TRUE(of_open.touches_border(of_open.whole(k)));
        int at_border = 0;
        for (const PartCell& quarter : of_open.whole(k).quarters())
            at_border += of_open.runs_along_border(quarter) ? 1 : 0;
        EXPECT_EQ(at_border, 3);  // all except the one in the middle
    }
}

TEST(PartCharts, HaveNoRayWhereThereIsNoNormal)
{
    // Both control rows at the border v = 0 are the same point: a pole.
    std::vector<Vec3> net;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            net.emplace_back(i * j, j, 0);
    const Part part = std::vector<Surface>{composite_bezier(1, 1, net)};
    const PartCharts charts = part_charts(part);
    EXPECT_FALSE(charts.ray(0, {0.5, 0}));
    EXPECT_TRUE(charts.ray(0, {0.5, 0.5}));
}

}  // namespace
}  // namespace endmill
