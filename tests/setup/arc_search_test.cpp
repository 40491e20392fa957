// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/arc_search.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "direction_sets.h"
#include "endmill/core/error.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"
#include "teapot.h"

namespace endmill {
namespace {

using test::degree;
using test::direction;
using test::up;

void make_accessible(VisibilityMap& map, std::size_t facet, std::size_t cell)
{
    map.column(cell)[facet / 64] |= std::uint64_t{1} << (facet % 64);
}

// Least angle between a direction and sample points of an arc.
double distance_to(const DirectionArc& arc, const Vec3& v)
{
    constexpr int steps = 2000;
    double nearest = 10;
    for (int i = 0; i <= steps; ++i) {
        const double turn = arc.length * i / steps;
        const Vec3 point =
            std::cos(turn) * arc.begin + std::sin(turn) * arc.axis.cross(arc.begin);
        nearest = std::min(nearest, std::acos(std::clamp(v.dot(point), -1.0, 1.0)));
    }
    return nearest;
}

// On the circle x = 0 of the 1200 cells the teapot needs 77.99 degrees to both sides of
// z.
TEST(ArcSearch, MachinesTheTeapotAboutTheAxisFromSpoutToHandle)
{
    const std::vector<Vec3> centres = sphere_grid("hex:10").centres;
    const VisibilityMap map = part_visibility(test::teapot(), centres).map;
    const auto arc = shortest_arc(map, centres, Vec3::UnitX(), Angle::degrees(0));
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->length / degree, 155.98, 0.006);
    const std::vector<Vec3> axes{Vec3::UnitZ(), Vec3::UnitX()};
    const PoseSearchResult found = arc_search(map, centres, axes, {}, Angle::degrees(0));
    ASSERT_TRUE(found.feasible);
    EXPECT_EQ(found.status, SetupStatus::FourAxis);
    EXPECT_EQ(found.feasible->area, 0);
    EXPECT_NEAR(found.feasible->phi.to, arc->length / 2, 1e-12);
    EXPECT_NEAR(found.feasible->pose.tool_axis.z(), 1, 1e-9);
    EXPECT_NEAR(found.feasible->pose.r2_axis.y(), 1, 1e-9);
    EXPECT_FALSE(
        arc_search(map, centres, axes, {-1, 155.9 * degree - 1}, Angle::degrees(0))
            .feasible);
    EXPECT_TRUE(arc_search(map, centres, axes, {-1, 156 * degree - 1}, Angle::degrees(0))
                    .feasible);
}

// The bottoms of two long V-grooves along y, tilted by +-40 degrees, with a half angle of
// 15 degrees. Their cones are wedges of directions, so that the tool turns by 2 (40 - 15)
// degrees.
TEST(ArcSearch, TurnsFromGrooveToGroove)
{
    const std::vector<Vec3> centres = sphere_grid("ico:4").centres;
    VisibilityMap map{2, centres.size()};
    for (std::size_t cell = 0; cell < centres.size(); ++cell) {
        const double tilt = std::atan2(centres[cell].x(), centres[cell].z()) / degree;
        if (std::abs(tilt - 40) < 15)
            make_accessible(map, 0, cell);
        if (std::abs(tilt + 40) < 15)
            make_accessible(map, 1, cell);
    }
    const double cell_deg = 2.72;
    const auto arc = shortest_arc(map, centres, Vec3::UnitY(), Angle::degrees(cell_deg));
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->length / degree, 50, 2 * cell_deg);
}

// Random cones. Each facet has a cell close to the arc, and no shorter arc that begins at
// a multiple of half a degree has this property.
TEST(ArcSearch, IsTheShortestArc)
{
    const std::vector<Vec3> centres = sphere_grid("hex:4").centres;
    test::Random random{71};
    int found = 0;
    for (int i = 0; i < 20; ++i) {
        VisibilityMap map{5, centres.size()};
        for (std::size_t facet = 0; facet < 5; ++facet) {
            for (int k = 0; k < 12; ++k)
                make_accessible(map, facet,
                                static_cast<std::size_t>(random.uniform(0, 191.99)));
        }
        const Vec3 axis = direction({random.uniform(0, 360), random.uniform(0, 180)});
        const double tolerance = 10 * degree;
        const auto arc = shortest_arc(map, centres, axis, Angle::radians(tolerance));
        if (!arc)
            continue;
        ++found;
        const auto reaches_all = [&](const DirectionArc& tried, double within) {
            for (std::size_t facet = 0; facet < 5; ++facet) {
                bool is_reached = false;
                for (std::size_t cell = 0; cell < centres.size() && !is_reached; ++cell)
                    is_reached = map.is_accessible(facet, cell) &&
                                 distance_to(tried, centres[cell]) <= within;
                if (!is_reached)
                    return false;
            }
            return true;
        };
        EXPECT_TRUE(reaches_all(*arc, tolerance + 0.003));
        for (int k = 0; k < 72; ++k) {
            DirectionArc shorter = *arc;
            shorter.begin = Eigen::AngleAxisd{5 * k * degree, axis} * arc->begin;
            shorter.length = std::max(0.0, arc->length - 0.02);
            if (arc->length > 0.02) {
                EXPECT_FALSE(reaches_all(shorter, tolerance));
            }
        }
    }
    EXPECT_GT(found, 10);
}

TEST(ArcSearch, NeedsNoArcIfOneDirectionSuffices)
{
    const std::vector<Vec3> centres = sphere_grid("hex:4").centres;
    VisibilityMap map{3, centres.size()};
    for (std::size_t facet = 0; facet < 3; ++facet)
        make_accessible(map, facet, 17);
    const Vec3 axis = centres[17].cross(up).normalized();
    const PoseSearchResult found =
        arc_search(map, centres, std::vector{axis}, {0, 0}, Angle::degrees(0));
    ASSERT_TRUE(found.feasible);
    EXPECT_EQ(found.status, SetupStatus::ThreeAxis);
    EXPECT_NEAR(found.feasible->pose.tool_axis.dot(centres[17]), 1, 1e-12);
    EXPECT_EQ(widest_direction(map).cell, 17U);
    EXPECT_EQ(widest_direction(map).facets, 3U);
}

TEST(ArcSearch, FindsNothingIfAFacetHasNoCellCloseToTheCircle)
{
    const std::vector<Vec3> centres{up, Vec3::UnitX()};
    VisibilityMap map{2, 2};
    make_accessible(map, 0, 0);
    EXPECT_TRUE(shortest_arc(map, centres, Vec3::UnitX(), Angle::degrees(1)));
    make_accessible(map, 1, 1);
    EXPECT_FALSE(shortest_arc(map, centres, Vec3::UnitX(), Angle::degrees(1)));
    const PoseSearchResult found =
        arc_search(map, centres, std::vector<Vec3>{Vec3::UnitX()}, {}, Angle::degrees(1));
    EXPECT_EQ(found.poses_skipped, 1U);
    EXPECT_FALSE(found.least);
}

// The best single direction of the teapot misses 114 of 288 facets.
TEST(ArcSearch, FindsTheDirectionThatReachesMost)
{
    const std::vector<Vec3> centres = sphere_grid("hex:10").centres;
    const VisibilityMap map = part_visibility(test::teapot(), centres).map;
    EXPECT_EQ(widest_direction(map).facets, 288U - 114U);
}

TEST(ArcSearch, NeedsAValidToleranceValidLimitsAndACentreForEachCell)
{
    const VisibilityMap map{1, 1};
    const std::vector<Vec3> centres{up};
    EXPECT_THROW(shortest_arc(map, centres, up, Angle::degrees(-1)), DomainError);
    EXPECT_THROW(shortest_arc(map, centres, up, Angle::degrees(46)), DomainError);
    EXPECT_THROW(shortest_arc(map, {}, up, Angle::degrees(1)), DomainError);
    EXPECT_THROW(arc_search(map, centres, centres, {1, 2}, Angle::degrees(1)),
                 DomainError);
    EXPECT_THROW(widest_direction(VisibilityMap{}), DomainError);
}

}  // namespace
}  // namespace endmill
