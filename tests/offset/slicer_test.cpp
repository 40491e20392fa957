// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/slicer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "endmill/core/parallel.h"
#include "grid_mesh.h"
#include "random.h"

namespace endmill {
namespace {

DrivePlanes planes_at(std::vector<double> positions, double degrees = 0)
{
    return {DriveFrame{Angle::degrees(degrees)}, std::move(positions)};
}

// An uneven surface with folds: its points are displaced sideways.
TriangleMesh folded_ground(unsigned seed)
{
    test::Random random{seed};
    return test::grid_mesh(40, 30, [&](int i, int j) {
        const double off = random.uniform(-1.5, 1.5);
        return Vec3{i + off, j + random.uniform(-1.5, 1.5), 3 * std::sin(0.3 * i) + off};
    });
}

void expect_equal(const PlaneSection& one, const PlaneSection& other)
{
    ASSERT_EQ(one.curves.size(), other.curves.size());
    for (std::size_t k = 0; k < one.curves.size(); ++k) {
        EXPECT_EQ(one.curves[k].points, other.curves[k].points);
        EXPECT_EQ(one.curves[k].is_closed, other.curves[k].is_closed);
        EXPECT_EQ(one.edges[k], other.edges[k]);
    }
    ASSERT_EQ(one.part_range.has_value(), other.part_range.has_value());
    if (one.part_range) {
        EXPECT_EQ(one.part_range->low, other.part_range->low);
        EXPECT_EQ(one.part_range->high, other.part_range->high);
    }
    EXPECT_EQ(one.crossed_triangles, other.crossed_triangles);
}

// The section by each plane depends neither on the other planes nor on the number of
// threads.
TEST(Slice, OfAllPlanesIsThatOfEachAlone)
{
    for (const double degrees : {0.0, -15.0, 90.0, 233.0}) {
        const TriangleMesh mesh = folded_ground(7);
        DrivePlanes planes = planes_at({}, degrees);
        for (int k = -100; k < 100; ++k)
            planes.positions.push_back(0.43 * k);
        const auto sections = slice(mesh, planes, {.part_triangles = 1000});
        set_thread_count(1);
        const auto by_one_thread = slice(mesh, planes, {.part_triangles = 1000});
        set_thread_count(4);
        const auto by_four = slice(mesh, planes, {.part_triangles = 1000});
        for (std::size_t k = 0; k < planes.positions.size(); ++k) {
            expect_equal(sections[k], by_one_thread[k]);
            expect_equal(sections[k], by_four[k]);
            const auto alone = slice(mesh, {planes.frame, {planes.positions[k]}},
                                     {.part_triangles = 1000});
            expect_equal(sections[k], alone.front());
        }
    }
}

// The segments that a plain loop over all triangles finds, given by their edges.
using EdgePair = std::tuple<int, int, int, int>;
std::multiset<EdgePair> plain_segments(const TriangleMesh& mesh, const DriveFrame& frame,
                                       double position)
{
    std::multiset<EdgePair> segments;
    for (const Triangle& triangle : mesh.triangles()) {
        std::vector<std::pair<int, int>> edges;
        for (int k = 0; k < 3; ++k) {
            int below = triangle[k];
            int above = triangle[(k + 1) % 3];
            if (frame.across(mesh.points()[below]) > position)
                std::swap(below, above);
            if (frame.across(mesh.points()[below]) <= position &&
                frame.across(mesh.points()[above]) > position)
                edges.emplace_back(below, above);
        }
        if (edges.size() == 2) {
            std::ranges::sort(edges);
            segments.emplace(edges[0].first, edges[0].second, edges[1].first,
                             edges[1].second);
        }
    }
    return segments;
}

TEST(Slice, HasTheSegmentsOfASimpleSearch)
{
    const TriangleMesh mesh = folded_ground(3);
    const DrivePlanes planes = planes_at({-0.3, 4.1, 4.1, 7.7, 20, 28.4}, 20);
    const auto sections = slice(mesh, planes);
    for (std::size_t plane = 0; plane < sections.size(); ++plane) {
        std::multiset<EdgePair> segments;
        for (const auto& edges : sections[plane].edges)
            for (std::size_t k = 1; k < edges.size(); ++k) {
                std::array two{std::pair{edges[k - 1].below, edges[k - 1].above},
                               std::pair{edges[k].below, edges[k].above}};
                std::ranges::sort(two);
                segments.emplace(two[0].first, two[0].second, two[1].first,
                                 two[1].second);
            }
        const auto expected = plain_segments(mesh, planes.frame, planes.positions[plane]);
        EXPECT_EQ(segments, expected);
        EXPECT_EQ(sections[plane].crossed_triangles, expected.size());
    }
}

// Points lie on the plane and on their edges.
TEST(Slice, PointsLieOnTheirEdgesAndOnThePlane)
{
    const TriangleMesh mesh = folded_ground(5);
    const DrivePlanes planes = planes_at({3.2, 11.7}, -15);
    const auto sections = slice(mesh, planes);
    for (std::size_t plane = 0; plane < 2; ++plane)
        for (std::size_t k = 0; k < sections[plane].curves.size(); ++k) {
            const auto& points = sections[plane].curves[k].points;
            ASSERT_EQ(points.size(), sections[plane].edges[k].size());
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Vec3 at = planes.frame.point(points[i].x(), planes.positions[plane],
                                                   points[i].y());
                const Vec3& a = mesh.points()[sections[plane].edges[k][i].below];
                const Vec3& b = mesh.points()[sections[plane].edges[k][i].above];
                EXPECT_NEAR((at - a).norm() + (at - b).norm(), (a - b).norm(), 1e-12);
            }
        }
}

// A torus cut beside its middle: four arcs, or two closed curves, or one.
TEST(Slice, OfATorusIsClosedCurvesFromTheirSmallestPoint)
{
    const TriangleMesh torus = test::torus_mesh(10, 60, 40);
    const auto sections = slice(torus, planes_at({-15.5, -12, -5 - 1e-9, 0, 3, 9, 14.9}));
    const std::vector<std::size_t> counts{0, 1, 1, 2, 2, 1, 1};
    for (std::size_t plane = 0; plane < sections.size(); ++plane) {
        EXPECT_EQ(sections[plane].curves.size(), counts[plane]) << plane;
        double last = -INFINITY;
        for (const SectionCurve& curve : sections[plane].curves) {
            EXPECT_TRUE(curve.is_closed);
            EXPECT_EQ(curve.points.front(), curve.points.back());
            for (const SectionPoint& point : curve.points)
                EXPECT_GE(point.x(), curve.points.front().x());
            EXPECT_GE(curve.points.front().x(), last);
            last = curve.points.front().x();
            // The outside is on the left, so that the curve runs clockwise around the
            // material.
            double area = 0;
            for (std::size_t k = 1; k < curve.points.size(); ++k)
                area += curve.points[k - 1].x() * curve.points[k].y() -
                        curve.points[k].x() * curve.points[k - 1].y();
            EXPECT_LT(area, 0);
        }
    }
}

// Planes through rows of vertices, which count as below: no gaps, and no point twice.
TEST(Slice, ThroughVerticesHasThemToTheBit)
{
    const TriangleMesh mesh = test::grid_mesh(5, 5, [](int i, int j) {
        return Vec3{0.1 * i, 0.1 * j, 0.7 * i * j};
    });
    const auto sections = slice(mesh, planes_at({0.0, 0.1 * 2, 0.1 * 4}));
    for (const int row : {0, 2}) {
        const auto& curves = sections[row / 2].curves;
        ASSERT_EQ(curves.size(), 1U);
        ASSERT_EQ(curves[0].points.size(), 5U);
        for (int i = 0; i < 5; ++i)
            EXPECT_EQ(curves[0].points[i], SectionPoint(0.1 * i, 0.7 * i * row));
    }
    EXPECT_TRUE(sections[2].curves.empty());
}

TEST(Slice, OpenCurvesRunTowardsLargerS)
{
    const TriangleMesh mesh = folded_ground(9);
    for (const double degrees : {0.0, 70.0, 180.0, 300.0})
        for (const auto& section :
             slice(mesh, planes_at({-20, -10, -3, 3, 10, 20}, degrees))) {
            double last = -INFINITY;
            for (const SectionCurve& curve : section.curves) {
                EXPECT_LE(curve.points.front().x(), curve.points.back().x());
                double least = INFINITY;
                for (std::size_t k = 0; k < curve.points.size(); ++k) {
                    least = std::min(least, curve.points[k].x());
                    if (k > 0) {
                        EXPECT_NE(curve.points[k], curve.points[k - 1]);
                    }
                }
                EXPECT_GE(least, last);
                last = least;
            }
        }
}

TEST(Slice, GivesTheRangeOfTheFirstTriangles)
{
    const TriangleMesh mesh =
        test::grid_mesh(11, 3, [](int i, int j) { return Vec3(i, j, 0); });
    // The lower row of cells has 20 triangles; the last of its first 10 ends at s = 5.
    const auto sections = slice(mesh, planes_at({0.5, 1.5}), {.part_triangles = 10});
    ASSERT_TRUE(sections[0].part_range);
    EXPECT_EQ(sections[0].part_range->low, 0);
    EXPECT_EQ(sections[0].part_range->high, 5);
    EXPECT_FALSE(sections[1].part_range);
    EXPECT_EQ(slice(mesh, planes_at({0.5}))[0].part_range->high, 10);
}

// Three triangles at one edge, and two with opposite orientation: every segment occurs
// once, and the tracing ends.
TEST(Slice, EndsOnANonManifoldMesh)
{
    const std::vector<Vec3> points{
        {0, -1, 0}, {0, 1, 0}, {3, 0.5, 1}, {-3, 0.5, 1}, {0, 0.5, 4}};
    const TriangleMesh leaves{points, {{0, 2, 1}, {0, 1, 3}, {0, 4, 1}}};
    const TriangleMesh turned{points, {{0, 2, 1}, {0, 3, 1}}};
    const auto count = [](const PlaneSection& section) {
        std::size_t segments = 0;
        for (const auto& curve : section.curves)
            segments += curve.points.size() - 1;
        return segments;
    };
    EXPECT_EQ(count(slice(leaves, planes_at({0.0}))[0]), 3U);
    EXPECT_EQ(count(slice(turned, planes_at({0.0}))[0]), 2U);
    EXPECT_EQ(slice(turned, planes_at({0.0}))[0].curves.size(), 2U);
}

TEST(Slice, WithoutCrossingsIsEmpty)
{
    const TriangleMesh mesh = folded_ground(1);
    EXPECT_TRUE(slice(mesh, planes_at({})).empty());
    EXPECT_TRUE(slice(TriangleMesh{}, planes_at({0, 1}))[1].curves.empty());
    EXPECT_TRUE(slice(mesh, planes_at({1e6}))[0].curves.empty());
    EXPECT_EQ(slice(mesh, planes_at({1e6}))[0].crossed_triangles, 0U);
    // Triangles without extent, which are crossed but have no two different points.
    const TriangleMesh needle{{{0, -1, 0}, {0, 1, 0}, {0, 0, 0}}, {{0, 1, 2}}};
    EXPECT_TRUE(slice(needle, planes_at({0.0}))[0].curves.empty());
}

// More planes than fit into one batch.
TEST(Slice, SupportsAnyNumberOfPlanes)
{
    const TriangleMesh mesh =
        test::grid_mesh(2, 2, [](int i, int j) { return Vec3(i, j, i); });
    DrivePlanes planes = planes_at({});
    for (int k = 0; k < 70'000; ++k)
        planes.positions.push_back((k + 0.5) / 70'000);
    const auto sections = slice(mesh, planes);
    for (const std::size_t k : {0U, 65534U, 65535U, 65536U, 69999U}) {
        ASSERT_EQ(sections[k].curves.size(), 1U);
        EXPECT_EQ(sections[k].curves[0].points.front().x(), 0);
        EXPECT_EQ(sections[k].curves[0].points.back().x(), 1);
    }
}

// The offset of a trough along y that is inclined by 25 degrees, with radius 4 at its
// bottom, for a ball of radius 7. The branches of the section cross at z* = R^2 / (2 p) +
// p / (2 cos^2).
TEST(Slice, OfAnInclinedTroughCrossesWhereTheClosedFormSays)
{
    constexpr double p = 4;
    constexpr double R = 7;
    constexpr double incline = 25 * std::numbers::pi / 180;
    const double tangent = std::tan(incline);
    const double expected =
        R * R / (2 * p) + p / (2 * std::cos(incline) * std::cos(incline));
    EXPECT_NEAR(expected, 8.559885664108, 1e-12);
    for (const auto& row :
         {std::pair{51, 2e-2}, {101, 6e-3}, {201, 1.5e-3}, {401, 4e-4}, {801, 1.5e-4}}) {
        // clang 14 cannot capture structured bindings in a lambda
        const int n = row.first;
        const double bound = row.second;
        const auto trough = test::grid_mesh(n, n, [&](int i, int j) {
            const double x = -20 + 41.0 * i / (n - 1);
            const double y = -15 + 31.0 * j / (n - 1);
            return test::offset_of_graph({x, y, x * x / (2 * p) + y * tangent}, x / p,
                                         tangent, R);
        });
        const auto section = slice(trough, planes_at({0.0}))[0];
        ASSERT_EQ(section.curves.size(), 1U);
        double highest = -INFINITY;
        for (const SectionPoint& crossing : test::crossings(section.curves[0]))
            highest = std::max(highest, crossing.y());
        EXPECT_NEAR(highest, expected, bound) << n;
    }
}

class SliceOfABowl : public testing::Test {
protected:
    static constexpr double p = 4;
    static constexpr double R = 7;

    static PlaneSection section(int n, double position)
    {
        const auto bowl = test::grid_mesh(n, n, [&](int i, int j) {
            const double x = -20 + 40.7 * i / (n - 1);
            const double y = -20 + 40.9 * j / (n - 1);
            return test::offset_of_graph({x, y, (x * x + y * y) / (2 * p)}, x / p, y / p,
                                         R);
        });
        return slice(bowl, planes_at({position}))[0];
    }
};

// The fold of the offset of a pit is a closed curve.
TEST_F(SliceOfABowl, HasACrescentAsFarAsTheClosedFormSays)
{
    const double farthest = p * std::pow(std::pow(R / p, 2.0 / 3) - 1, 1.5);
    EXPECT_NEAR(farthest, 1.216, 5e-4);
    for (const double share : {0.2, 0.5, 0.9}) {
        const PlaneSection section = SliceOfABowl::section(101, share * farthest);
        ASSERT_EQ(section.curves.size(), 2U);
        EXPECT_FALSE(section.curves[0].is_closed);
        EXPECT_TRUE(section.curves[1].is_closed);
    }
    EXPECT_EQ(section(101, 1.05 * farthest).curves.size(), 1U);
}

TEST_F(SliceOfABowl, HasFalseFoldsOnACoarseGridOnly)
{
    EXPECT_EQ(test::runs_of_s(section(51, 0.25).curves[0]), 13);
    EXPECT_EQ(test::runs_of_s(section(101, 0.25).curves[0]), 1);
    EXPECT_EQ(test::runs_of_s(section(201, 0.25).curves[0]), 1);
}

}  // namespace
}  // namespace endmill
