// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/tool_clearance.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The gap of a body to the triangles of a mesh, from many places of each triangle.
double sampled_gap(const TriangleMesh& mesh, const CuttingBody& body,
                   const ToolFrame& tool)
{
    constexpr int parts = 40;
    double least = infinity;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const auto [a, b, c] = mesh.corners(k);
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j) {
                const Vec3 place =
                    a + double(i) / parts * (b - a) + double(j) / parts * (c - a);
                least = std::min(least, body.distance(tool.seen(place)).value);
            }
    }
    return least;
}

TEST(ToolClearance, IsTheLeastDistanceOfSampledTriangles)
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> at{-6, 6};
    for (int trial = 0; trial < 60; ++trial) {
        std::vector<Vec3> points;
        std::vector<Triangle> triangles;
        for (int k = 0; k < 12; ++k) {
            const Vec3 corner{at(random), at(random), at(random)};
            for (int i = 0; i < 3; ++i)
                points.emplace_back(corner +
                                    0.2 * Vec3{at(random), at(random), at(random)});
            triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
        }
        const TriangleMesh mesh{points, triangles};
        const ToolClearance clearance{mesh};
        const Vec3 axis = Vec3{at(random), at(random), at(random)}.normalized();
        const ToolFrame tool = frame_at({Vec3{at(random), at(random), at(random)}, axis});
        for (const CuttingBody& body :
             {CuttingBody{Cutter::ball(2)}, CuttingBody{Cutter::flat(2)},
              CuttingBody{Cutter{2, 0.5}}, CuttingBody::of_cylinder({3, 2, 5})}) {
            const double sampled = sampled_gap(mesh, body, tool);
            const double gap = clearance.gap(body, tool, infinity);
            EXPECT_LE(gap, sampled + ToolClearance::accuracy);
            EXPECT_GE(gap, sampled - 0.05);  // half the distance of the samples
            EXPECT_TRUE(
                clearance.is_clear(body, tool, gap - 2 * ToolClearance::accuracy));
            EXPECT_FALSE(
                clearance.is_clear(body, tool, gap + 2 * ToolClearance::accuracy));
            EXPECT_EQ(clearance.gap(body, tool, gap - 0.01), infinity);
        }
    }
}

// The surface z = k (x^2 + y^2) / 2 over [-15, 15]^2, exact as a patch of degree 2.
std::vector<Surface> bowl(double k)
{
    std::vector<Vec3> net;
    for (const double j : {-1.0, 0.0, 1.0})
        for (const double i : {-1.0, 0.0, 1.0})
            net.emplace_back(15 * i, 15 * j,
                             k * 225 * ((i == 0 ? -1 : 1) + (j == 0 ? -1 : 1)) / 2);
    return {Surface{{0, 1}, {0, 1}, {BezierPatch{2, 2, net}}}};
}

// An upright flat cutter in a bowl touches along its rim: its tip is at the height of the rim,
// k R^2 / 2, for a gap of zero. An upright ball of the least radius of curvature touches at the
// bottom.
TEST(ToolClearance, OfSurfacesIsWithinTheChordTolerance)
{
    const double k = 0.04;
    const auto surfaces = bowl(k);
    const std::vector<double> sides{1};
    const double chord = 0.002;
    const ToolClearance clearance{surfaces, sides, chord};
    const auto gap = [&](const Cutter& cutter, double height) {
        return clearance.gap(CuttingBody{cutter},
                             frame_at({{0, 0, height}, Vec3::UnitZ()}), infinity);
    };
    EXPECT_NEAR(gap(Cutter::ball(5), 0), 0, chord + ToolClearance::accuracy);
    EXPECT_NEAR(gap(Cutter::ball(5), -0.3), -0.3, chord + ToolClearance::accuracy);
    EXPECT_NEAR(gap(Cutter::flat(5), k * 25 / 2), 0, chord + ToolClearance::accuracy);
    const CuttingBody flat{Cutter::flat(5)};
    const auto is_clear = [&](double height) {
        return clearance.is_clear(flat, frame_at({{0, 0, height}, Vec3::UnitZ()}), 0);
    };
    EXPECT_TRUE(is_clear(k * 25 / 2 + 2 * chord));
    EXPECT_FALSE(is_clear(k * 25 / 2 - 1e-3));
}

// By the front of a contact the answer is the same as without it, for all axes.
TEST(ToolClearance, FrontsGiveTheSameAnswers)
{
    for (const double k : {-0.03, 0.04, 0.15}) {
        const auto surfaces = bowl(k);
        const std::vector<double> sides{1};
        const ToolClearance clearance{surfaces, sides, 0.005};
        int clear = 0;
        int tests = 0;
        for (const double u : {0.0, 0.2, 0.5, 0.9}) {
            const SurfaceTangents at = surfaces.front().tangents(u, 0.4);
            const CutterContact contact{at.point, unit_normal(at)};
            const ToolClearance::Front front = clearance.front(contact, -0.01);
            for (const Cutter& cutter : {Cutter::ball(6), Cutter{6, 1}, Cutter::flat(6)})
                for (double lean = -40; lean <= 40; lean += 16) {
                    const Vec3 axis =
                        (contact.normal + std::tan(lean / 57) * at.du.normalized() +
                         0.2 * at.dv.normalized())
                            .normalized();
                    const CutterLocation location{
                        control_point(cutter, contact, ControlPoint::Tip, axis), axis};
                    const CuttingBody body{cutter};
                    const bool expected =
                        clearance.is_clear(body, frame_at(location), -0.01);
                    EXPECT_EQ(clearance.is_clear(body, frame_at(location), -0.01, front),
                              expected);
                    clear += expected ? 1 : 0;
                    ++tests;
                }
        }
        // on the dome every cutter fits, in the narrow bowl flat bottoms do not
        EXPECT_GT(clear, 0);
        if (k < 0) {
            EXPECT_EQ(clear, tests);
        } else if (k > 0.1) {
            EXPECT_LT(clear, tests);
        }
    }
}

// Beside a wall that is 10 mm high and 20 mm away a front rises by atan(1 / 2).
TEST(ToolClearance, FrontsRiseAsHighAsTheWallsAround)
{
    const TriangleMesh mesh{
        {{-5, -20, 0}, {5, -20, 0}, {5, 20, 0}, {-5, 20, 0}, {5, 20, 10}, {-5, 20, 10}},
        {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}}};
    const ToolClearance clearance{mesh};
    const CutterContact contact{{0, 0, 0}, Vec3::UnitZ()};
    const auto front = clearance.front(contact, -0.01);
    const double wall = std::atan(0.5);
    EXPECT_TRUE(clearance.rises_above(wall - 0.01, contact, front));
    // the bound is wide: balls around the triangles rise higher than the wall
    EXPECT_FALSE(clearance.rises_above(1.3, contact, front));
}

TEST(ToolClearance, HasNoGapBelowAnEndlessAxisInside)
{
    // a triangle that the upper part of an endless cutter crosses
    const TriangleMesh mesh{{{-50, -50, 70}, {50, -50, 70}, {0, 80, 70}}, {{0, 1, 2}}};
    const ToolClearance clearance{mesh};
    const ToolFrame tool = frame_at({Vec3::Zero(), Vec3::UnitZ()});
    EXPECT_NEAR(clearance.gap(CuttingBody{Cutter::ball(5)}, tool, infinity), -5, 1e-3);
    EXPECT_NEAR(clearance.gap(CuttingBody{Cutter::ball(5), 60}, tool, infinity), 10,
                1e-3);
}

}  // namespace
}  // namespace endmill
