// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/gouge/detail/cutter_core.h"
#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

const std::array cutters{Cutter::ball(3), Cutter::flat(3), Cutter{3, 1}};

// z = (x^2 + y^2) / (2 p) + slope x over [-10, 10]^2.
Surface bowl(double p, double slope = 0)
{
    std::vector<Vec3> net;
    for (const double y : {-10.0, 0.0, 10.0})
        for (const double x : {-10.0, 0.0, 10.0}) {
            // The blossom of the squares: 100, -100, 100.
            const double squares = (x == 0 ? -100 : 100) + (y == 0 ? -100 : 100);
            net.emplace_back(x, y, squares / (2 * p) + slope * x);
        }
    return {{0, 1}, {0, 1}, {BezierPatch(2, 2, net)}};
}

TriangleMesh bowl_mesh(int cells, double p, double slope = 0)
{
    return test::grid_mesh(cells, cells, [&](double i, double j) {
        const double x = 20 * i / cells - 10;
        const double y = 20 * j / cells - 10;
        return Vec3{x, y, (x * x + y * y) / (2 * p) + slope * x};
    });
}

// On the axis at height h the nearest point is the bottom up to h = p; above, a circle of
// radius sqrt(2 p h - p^2).
TEST(LeastGap, OfABallInABowlIsItsCentresDistance)
{
    const double p = 4;
    const std::vector<Surface> surfaces{bowl(p)};
    for (const double h : {0.5, 2.0, 3.0, 4.0, 5.0, 8.0}) {
        const double distance = h <= p ? h : std::sqrt(2 * p * h - p * p);
        const std::vector<Vec3> places{{0, 0, h}};
        const LeastGap found = least_gap(surfaces, Cutter::ball(3), places).value();
        EXPECT_NEAR(found.gap, distance - 3, 2e-5) << h;
        EXPECT_NEAR((found.point - places[0]).norm() - 3, found.gap, 1e-12);
        const TriangleMesh mesh = bowl_mesh(200, p);
        const DropCutter drop_cutter{mesh, Cutter::ball(3)};
        EXPECT_NEAR(least_gap(drop_cutter, places)->gap, distance - 3, 2e-3) << h;
    }
}

// A tilted plane touches the circle of the corner; a gap d is measured along the normal.
// Inside a flat cutter the point counts that is equally far from bottom and side, beyond
// which the sharp edge is cut off: 0.6 and 0.8 times as far along the normal.
TEST(LeastGap, ToASlopeIsMeasuredAlongItsNormal)
{
    const double slope = 0.75;  // normal (-0.6, 0, 0.8)
    const std::vector<Surface> surfaces{bowl(1e12, slope)};
    const TriangleMesh mesh = bowl_mesh(4, 1e12, slope);
    for (const Cutter& cutter : cutters)
        for (const double gap : {1.0, 1e-3, 0.0, -0.05, -0.5}) {
            const double up =
                (cutter.flat_radius() * 0.6 + cutter.corner_radius() + gap) / 0.8;
            const std::vector<Vec3> places{{1, 2, slope + up}};
            const DropCutter drop_cutter{mesh, cutter};
            const double expected = cutter.is_flat() && gap < 0 ? gap / 1.4 : gap;
            EXPECT_NEAR(least_gap(surfaces, cutter, places)->gap, expected, 2e-5);
            EXPECT_NEAR(least_gap(drop_cutter, places)->gap, expected, 2e-5);
        }
}

// Second route: all triangles, one after the other.
TEST(LeastGap, ToAMeshIsThatToItsNearestTriangle)
{
    test::Random random{1};
    const TriangleMesh mesh = test::grid_mesh(12, 12, [&](double i, double j) {
        return Vec3{i, j, random.uniform(0, 3)};
    });
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        std::vector<Vec3> places;
        for (int k = 0; k < 40; ++k)
            places.emplace_back(random.uniform(-4, 16), random.uniform(-4, 16),
                                random.uniform(0, 9));
        double least_of_all = 1e9;
        for (const Vec3& place : places) {
            const CutterCore core{cutter, place};
            double least = 1e9;
            for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
                least =
                    std::min(least, triangle_gap(core, mesh.corners(k), 1e-9, 1e9).gap);
            EXPECT_NEAR(least_gap(drop_cutter, {&place, 1})->gap, least, 1.1e-5);
            least_of_all = std::min(least_of_all, least);
        }
        const LeastGap found = least_gap(drop_cutter, places).value();
        EXPECT_NEAR(found.gap, least_of_all, 1.1e-5);
        EXPECT_NEAR(CutterCore(cutter, places[found.place]).gap(found.point), found.gap,
                    1e-12);
    }
}

// The drop cutter leaves a cutter in contact, so that the gap is zero.
TEST(LeastGap, IsNoneWhereTheCutterRests)
{
    const TriangleMesh mesh = bowl_mesh(40, 5);
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        std::vector<Vec3> places;
        for (double x = -9; x <= 9; x += 0.37) {
            const double tip = drop_cutter.contact({x, 0.3 * x})->tip_z;
            places.emplace_back(x, 0.3 * x, tip + cutter.corner_radius());
        }
        const LeastGap found = least_gap(drop_cutter, places).value();
        EXPECT_NEAR(found.gap, 0, 1.1e-5);
        const std::vector<Surface> surfaces{bowl(5)};
        const double to_surface = least_gap(surfaces, cutter, places)->gap;
        EXPECT_GE(to_surface, -1e-5);  // the chords lie above the bowl
        EXPECT_LE(to_surface, 0.03);
    }
}

TEST(LeastGap, DoesNotDependOnThreads)
{
    const std::vector<Surface> surfaces{bowl(5)};
    const TriangleMesh mesh = bowl_mesh(40, 5);
    test::Random random{2};
    std::vector<Vec3> places;
    for (int k = 0; k < 200; ++k)
        places.emplace_back(random.uniform(-9, 9), random.uniform(-9, 9), 15);
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        set_thread_count(1);
        const LeastGap alone = least_gap(surfaces, cutter, places).value();
        const LeastGap alone_on_mesh = least_gap(drop_cutter, places).value();
        set_thread_count(4);
        const LeastGap together = least_gap(surfaces, cutter, places).value();
        const LeastGap together_on_mesh = least_gap(drop_cutter, places).value();
        EXPECT_EQ(alone.gap, together.gap);
        EXPECT_EQ(alone.place, together.place);
        EXPECT_EQ(alone.point, together.point);
        EXPECT_EQ(alone_on_mesh.gap, together_on_mesh.gap);
        EXPECT_EQ(alone_on_mesh.place, together_on_mesh.place);
    }
}

TEST(LeastGap, IsEmptyWithoutAPlaceOrAPart)
{
    const std::vector<Surface> surfaces{bowl(5)};
    EXPECT_FALSE(least_gap(surfaces, cutters[0], {}));
    EXPECT_THROW(least_gap({}, cutters[0], {}, {1e-6}), DomainError);
    const TriangleMesh empty;
    const DropCutter over_nothing{empty, cutters[0]};
    const std::vector<Vec3> places{{0, 0, 0}};
    EXPECT_FALSE(least_gap(over_nothing, places));
    EXPECT_THROW(least_gap(surfaces, cutters[0], places, {0}), DomainError);
    const std::vector<Vec3> nowhere{{0, 0, std::nan("")}};
    EXPECT_THROW(least_gap(surfaces, cutters[0], nowhere), DomainError);
}

// A right-angled valley: a ball on the axis at height h has the distance h / sqrt 2 from
// both walls. The bottom of a flat cutter is h - R above the walls at its rim.
TEST(ProfileGap, IsThatOfTheSegments)
{
    const std::vector<SectionCurve> valley{{{{-9, 9}, {0, 0}, {9, 9}}, false}};
    for (const double h : {1.0, 3.0, 5.0}) {
        const std::vector<SectionPoint> places{{0, 8}, {0, h}};
        const LeastGap ball = profile_gap(valley, Cutter::ball(2), places).value();
        EXPECT_NEAR(ball.gap, h / std::sqrt(2) - 2, 2e-5);
        EXPECT_EQ(ball.place, 1U);
    }
    const std::vector<SectionPoint> above{{0, 5}};
    const LeastGap flat = profile_gap(valley, Cutter::flat(2), above).value();
    EXPECT_NEAR(flat.gap, 3 / std::sqrt(2), 2e-5);
    EXPECT_FALSE(profile_gap(valley, Cutter::ball(2), std::vector<SectionPoint>{}));
    EXPECT_FALSE(profile_gap(std::vector<SectionCurve>{}, Cutter::ball(2), above));
}

// A floor and a wall meet at x = 0. A ball of radius 3 that touches the floor at x < 3 would be
// inside the wall, and one that touches the wall below z = 3 inside the floor.
TEST(Accessibility, EndsOneRadiusFromAnInnerCorner)
{
    const TriangleMesh mesh = test::both(test::box_mesh({0, -20, -5}, {20, 20, 0}),
                                         test::box_mesh({-10, -20, -5}, {0, 20, 20}));
    for (const Cutter& cutter : {Cutter::ball(3), Cutter{3, 1}, Cutter::flat(3)}) {
        const DropCutter drop_cutter{mesh, cutter};
        const double r = cutter.corner_radius();
        for (const double away : {0.1, 0.5, 0.9, 1.1, 2.0, 2.9, 3.1, 5.0}) {
            const CutterContact floor{{away, 1, 0}, Vec3::UnitZ()};
            const CutterContact wall{{0, 1, away}, Vec3::UnitX()};
            // A flat bottom reaches up to the corner radius to the wall.
            EXPECT_EQ(is_accessible(drop_cutter, floor, 1e-3), away > r)
                << away << ' ' << r;
            EXPECT_EQ(is_accessible(drop_cutter, wall, 1e-3), away > r)
                << away << ' ' << r;
        }
        EXPECT_TRUE(is_accessible(drop_cutter, {{10, 0, 0}, Vec3::UnitZ()}, 0.1));
        EXPECT_FALSE(is_accessible(drop_cutter, {{10, 0, -5}, -Vec3::UnitZ()}, 0.1));
    }
}

TriangleMesh slot_mesh(double width)
{
    return test::both(test::box_mesh({-width / 2, -20, -5}, {width / 2, 20, 0}),
                      test::both(test::box_mesh({-20, -20, -5}, {-width / 2, 20, 9}),
                                 test::box_mesh({width / 2, -20, -5}, {20, 20, 9})));
}

// A cutter that fits into a slot touches the floor up to the corner radius r from the walls,
// one that does not fit touches none of it.
TEST(Accessibility, OfTheFloorOfASlotEndsOneCornerRadiusFromTheWalls)
{
    for (const Cutter& cutter : {Cutter::flat(5), Cutter{5, 1}})
        for (const double width : {9.0, 9.8, 10.0, 10.1, 11.0, 16.0}) {
            const TriangleMesh mesh = slot_mesh(width);
            const DropCutter drop_cutter{mesh, cutter};
            const double r = cutter.corner_radius();
            for (const double away : {0.02, 0.4, 0.9, 1.1, 2.0, 3.3, 4.4})
                for (const double y : {-7.1, 0.0, 3.3}) {
                    const CutterContact floor{{away - width / 2, y, 0}, Vec3::UnitZ()};
                    EXPECT_EQ(is_accessible(drop_cutter, floor, 0.05),
                              width >= 10 && away > r)
                        << width << ' ' << away << ' ' << y << ' ' << r;
                }
        }
}

TEST(Accessibility, NeedsAPointAUnitNormalAndADistance)
{
    const TriangleMesh mesh = slot_mesh(12);
    const DropCutter drop_cutter{mesh, Cutter::flat(5)};
    const Vec3 up = Vec3::UnitZ();
    EXPECT_TRUE(is_accessible(drop_cutter, {{0, 0, 0}, up}, 0));
    for (const CutterContact& wrong :
         {CutterContact{{0, 0, std::nan("")}, up}, CutterContact{{0, 0, 0}, 2 * up},
          CutterContact{{0, 0, 0}, std::nan("") * up}})
        EXPECT_THROW(is_accessible(drop_cutter, wrong, 0.1), DomainError);
    for (const double wrong : {-0.1, std::nan("")})
        EXPECT_THROW(is_accessible(drop_cutter, {{0, 0, 0}, up}, wrong), DomainError);
}

// Lifting the cutter by the rise at its place makes it rest there.
TEST(GreatestRise, IsTheLiftThatARestingCutterNeeds)
{
    const TriangleMesh mesh = bowl_mesh(20, 4, 0.3);
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        const double r = cutter.corner_radius();
        test::Random random{3};
        std::vector<Vec3> places;
        for (int k = 0; k < 500; ++k) {
            const Eigen::Vector2d at{random.uniform(-9, 9), random.uniform(-9, 9)};
            const double rests = drop_cutter.contact(at)->tip_z + r;
            places.emplace_back(at.x(), at.y(), rests + random.uniform(0.1, 1));
        }
        EXPECT_GT(greatest_rise(drop_cutter, places)->gap, 0.1 - 1e-9);
        places[123].z() -= 3;
        const LeastGap found = greatest_rise(drop_cutter, places).value();
        EXPECT_EQ(found.place, 123U);
        // never less than the depth of the gouge
        EXPECT_LE(found.gap, least_gap(drop_cutter, places)->gap + 1e-9);
        EXPECT_FALSE(greatest_rise(drop_cutter, {}).has_value());
    }
}

}  // namespace
}  // namespace endmill
