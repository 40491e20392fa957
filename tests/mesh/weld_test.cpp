// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/weld.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using test::Corners;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<double, 3> key(const Vec3& point)
{
    return {point.x(), point.y(), point.z()};
}

// Points on the x axis, as corners of triangles without area.
std::vector<Corners> soup_on_x(const std::vector<double>& x)
{
    std::vector<Corners> soup;
    for (std::size_t k = 0; k + 2 < x.size(); k += 3)
        soup.push_back({Vec3{x[k], 0, 0}, Vec3{x[k + 1], 0, 0}, Vec3{x[k + 2], 0, 0}});
    return soup;
}

TEST(Weld, RestoresAMeshFromItsSeparateTriangles)
{
    const TriangleMesh torus = test::torus_mesh(40, 17);
    const WeldedMesh welded = weld(test::soup_of(torus));
    EXPECT_EQ(welded.mesh.points().size(), torus.points().size());
    EXPECT_EQ(welded.welded_points, 3U * 2 * 40 * 17 - 40 * 17);
    EXPECT_EQ(welded.largest_move, 0);
    EXPECT_EQ(test::soup_of(welded.mesh), test::soup_of(torus));
}

TEST(Weld, FindsAsManyPointsAsASet)
{
    test::Random random{3};
    std::vector<Corners> soup(4000);
    std::set<std::array<double, 3>> different;
    for (Corners& corners : soup)
        for (Vec3& corner : corners) {
            corner = (test::random_point(random, 8)).array().round();
            different.insert(key(corner + Vec3::Zero()));
        }
    const WeldedMesh welded = weld(soup);
    EXPECT_EQ(welded.mesh.points().size(), different.size());
    EXPECT_EQ(test::soup_of(welded.mesh), soup);
}

TEST(Weld, NumbersPointsInOrderOfAppearance)
{
    const WeldedMesh welded = weld(soup_on_x({5, 3, 5, 4, 3, 9}));
    EXPECT_EQ(test::triangles_of(welded.mesh),
              (std::vector<Triangle>{{0, 1, 0}, {2, 1, 3}}));
    EXPECT_EQ(welded.mesh.points()[3], Vec3(9, 0, 0));
}

TEST(Weld, WeldsMinusZeroWithZeroButNoNeighbours)
{
    const double next = std::nextafter(1.0, 2.0);
    const WeldedMesh welded = weld(soup_on_x({0.0, -0.0, 1, 1, next, 5e-324}));
    EXPECT_EQ(test::triangles_of(welded.mesh),
              (std::vector<Triangle>{{0, 0, 1}, {1, 2, 3}}));
    EXPECT_FALSE(std::signbit(welded.mesh.points()[0].x()));
}

TEST(Weld, OfNothingIsEmpty)
{
    const std::vector<Corners> none;
    EXPECT_TRUE(weld(none).mesh.points().empty());
    EXPECT_TRUE(weld(none, 1).mesh.triangles().empty());
    EXPECT_EQ(weld(TriangleMesh{}, 1).welded_points, 0U);
}

TEST(Weld, OfAMeshCountsThePointsThatItLoses)
{
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 1, 1});
    const TriangleMesh beside = test::box_mesh({1, 0, 0}, {2, 1, 1});
    const WeldedMesh welded = weld(test::both(box, beside));
    EXPECT_EQ(welded.welded_points, 4U);
    EXPECT_EQ(test::soup_of(welded.mesh), test::soup_of(test::both(box, beside)));
}

TEST(WeldWithTolerance, JoinsChainsOfStepsNoLongerThanIt)
{
    // Powers of two make the distances exact: 1/8 is one step, 1/8 + 2^-50 is more.
    const double more = 0.125 + std::ldexp(1, -50);
    const WeldedMesh welded = weld(soup_on_x({0, 0.125, 0.25, 1, 1 + more, 4}), 0.125);
    EXPECT_EQ(test::triangles_of(welded.mesh),
              (std::vector<Triangle>{{0, 0, 0}, {1, 2, 3}}));
    EXPECT_EQ(welded.mesh.points()[0], Vec3(0, 0, 0));
    EXPECT_EQ(welded.welded_points, 2U);
    EXPECT_EQ(welded.largest_move, 0.25);
}

// The second route compares every pair and recolours whole clusters.
std::vector<int> clusters_by_pairs(const std::vector<Vec3>& points, double tolerance)
{
    std::vector<int> colours(points.size());
    std::iota(colours.begin(), colours.end(), 0);
    for (std::size_t a = 0; a < points.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            if ((points[a] - points[b]).norm() <= tolerance)
                std::ranges::replace(colours, int{colours[a]}, int{colours[b]});
    return colours;
}

TEST(WeldWithTolerance, JoinsTheSameAsTestingEveryPair)
{
    test::Random random{5};
    for (const double tolerance : {0.01, 0.1, 0.2, 0.3, 3.0}) {
        std::vector<Vec3> points(600);
        for (Vec3& point : points)
            point = test::random_point(random, 1) + Vec3{7, -3, 0};
        const std::vector<int> colours = clusters_by_pairs(points, tolerance);
        std::vector<Triangle> triangles(200);
        for (int k = 0; k < 200; ++k)
            triangles[k] = {3 * k, 3 * k + 1, 3 * k + 2};
        const WeldedMesh welded = weld(TriangleMesh{points, triangles}, tolerance);

        EXPECT_EQ(welded.mesh.points().size(),
                  std::set<int>(colours.begin(), colours.end()).size());
        const auto name = [&](std::size_t k) {
            return welded.mesh.triangles()[k / 3][k % 3];
        };
        for (std::size_t a = 0; a < points.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                EXPECT_EQ(name(a) == name(b), colours[a] == colours[b]);
    }
}

TEST(WeldWithTolerance, GivesTheSamePointsInEveryOrder)
{
    test::Random random{6};
    std::vector<Corners> soup(500);
    for (Corners& corners : soup)
        for (Vec3& corner : corners)
            corner = test::random_point(random, 1);
    const auto points_after = [&] {
        std::set<std::array<double, 3>> points;
        const WeldedMesh welded = weld(soup, 0.08);
        for (const Vec3& point : welded.mesh.points())
            points.insert(key(point));
        return std::pair{points, welded.largest_move};
    };
    const auto before = points_after();
    EXPECT_LT(before.first.size(), 1400U);
    std::ranges::shuffle(soup, random.engine());
    EXPECT_EQ(points_after(), before);
}

TEST(WeldWithTolerance, LeavesPointsFurtherApartThanIt)
{
    test::Random random{7};
    std::vector<Corners> soup = test::soup_of(test::torus_mesh(30, 20));
    for (Corners& corners : soup)
        for (Vec3& corner : corners)
            corner += test::random_point(random, 1e-7);
    const WeldedMesh welded = weld(soup, 1e-6);
    EXPECT_EQ(welded.mesh.points().size(), 600U);
    EXPECT_EQ(welded.mesh.triangles().size(), 1200U);
    EXPECT_GT(welded.largest_move, 0);
    EXPECT_LT(welded.largest_move, 4e-7);
}

TEST(Weld, RefusesInvalidPointsAndTolerances)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(weld(soup_on_x({0, nan, 1})), DomainError);
    EXPECT_THROW(weld(soup_on_x({0, infinity, 1}), 0.1), DomainError);
    const std::vector<Corners> soup = soup_on_x({0, 1000, 1});
    EXPECT_THROW(weld(soup, -1), DomainError);
    EXPECT_THROW(weld(soup, nan), DomainError);
    EXPECT_THROW(weld(soup, infinity), DomainError);
    EXPECT_THROW(weld(soup, 0.9e-9), DomainError);
    EXPECT_EQ(weld(soup, 1e-9).welded_points, 0U);
}

}  // namespace
}  // namespace endmill
