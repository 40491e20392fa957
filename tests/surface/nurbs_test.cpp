// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/nurbs.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/largest_cutter.h"
#include "endmill/surface/tool_side.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using std::numbers::pi;

// N_{i,p}(t) directly by the recursion of Cox and de Boor.
double b_spline(const std::vector<double>& knots, int i, int p, double t)
{
    if (p == 0)
        return knots[i] <= t && t < knots[i + 1] ? 1 : 0;
    double value = 0;
    if (knots[i + p] > knots[i])
        value +=
            (t - knots[i]) / (knots[i + p] - knots[i]) * b_spline(knots, i, p - 1, t);
    if (knots[i + p + 1] > knots[i + 1])
        value += (knots[i + p + 1] - t) / (knots[i + p + 1] - knots[i + 1]) *
                 b_spline(knots, i + 1, p - 1, t);
    return value;
}

Vec3 by_definition(const Nurbs& nurbs, double u, double v)
{
    Vec3 sum = Vec3::Zero();
    double weight_sum = 0;
    for (int j = 0; j < nurbs.v.points(); ++j)
        for (int i = 0; i < nurbs.u.points(); ++i) {
            const int at = j * nurbs.u.points() + i;
            const double share = b_spline(nurbs.u.knots, i, nurbs.u.degree, u) *
                                 b_spline(nurbs.v.knots, j, nurbs.v.degree, v) *
                                 (nurbs.weights.empty() ? 1 : nurbs.weights[at]);
            sum += share * nurbs.control_points[at];
            weight_sum += share;
        }
    return sum / weight_sum;
}

Nurbs random_nurbs(SplineParameter u, SplineParameter v, bool rational)
{
    test::Random random{7};
    Nurbs nurbs{std::move(u), std::move(v), {}, {}};
    for (int j = 0; j < nurbs.v.points(); ++j)
        for (int i = 0; i < nurbs.u.points(); ++i) {
            const double z = random.uniform(-5, 5);
            nurbs.control_points.emplace_back(10 * i, 10 * j, z);
            if (rational)
                nurbs.weights.push_back(random.uniform(0.5, 2));
        }
    return nurbs;
}

TEST(Nurbs, IsTheSumOfItsBSplines)
{
    const SplineParameter parameters[] = {
        {3, {0, 0, 0, 0, 1, 2, 2, 3.5, 4, 4, 4, 4}},
        {2, {-1, -0.5, 0, 1, 1, 2, 3, 4}},  // not clamped
        {1, {0, 0, 1, 5, 5}},
        {5, {0, 0, 0, 0, 0, 0, 0.3, 0.3, 0.3, 1, 1, 1, 1, 1, 1}}};
    for (const auto& u : parameters)
        for (const auto& v : parameters)
            for (const bool rational : {false, true}) {
                const Nurbs nurbs = random_nurbs(u, v, rational);
                const Surface surface = nurbs_surface(nurbs);
                const auto [u_low, u_high] = surface.range(Parameter::U);
                const auto [v_low, v_high] = surface.range(Parameter::V);
                EXPECT_EQ(u_low, u.knots[u.degree]);
                EXPECT_EQ(u_high, u.knots[u.points()]);
                for (const double s : {0.0, 0.21, 0.5, 0.77, 0.999})
                    for (const double t : {0.0, 0.34, 0.9}) {
                        const double at_u = std::lerp(u_low, u_high, s);
                        const double at_v = std::lerp(v_low, v_high, t);
                        EXPECT_LT((surface.tangents(at_u, at_v).point -
                                   by_definition(nurbs, at_u, at_v))
                                      .norm(),
                                  1e-12);
                    }
            }
}

TEST(Nurbs, WithSimpleKnotsIsSmooth)
{
    const SplineParameter cubic{3, {0, 0, 0, 0, 1, 2, 3, 3, 3, 3}};
    const Surface surface = nurbs_surface(random_nurbs(cubic, cubic, false));
    for (const double u : {1.0, 2.0}) {
        const int number = surface.patch_number(Parameter::U, u);
        const SurfaceJet below = surface.jet_in_patch(number - 1, 0, u, 0.4);
        const SurfaceJet above = surface.jet_in_patch(number, 0, u, 0.4);
        EXPECT_LT((below.point - above.point).norm(), 1e-13);
        EXPECT_LT((below.du - above.du).norm(), 1e-12);
        EXPECT_LT((below.duu - above.duu).norm(), 1e-11);
    }
    EXPECT_EQ(continuity(surface).continuity, Continuity::G1);
}

TEST(Nurbs, HasAGapAtAKnotRepeatedOnceMoreThanTheDegree)
{
    const SplineParameter parted{2, {0, 0, 0, 1, 1, 1, 2, 2, 2}};
    const SplineParameter whole{2, {0, 0, 0, 1, 1, 1}};
    const Surface surface = nurbs_surface(random_nurbs(parted, whole, true));
    EXPECT_EQ(surface.patches(Parameter::U), 2);
    EXPECT_EQ(continuity(surface).continuity, Continuity::None);
}

TEST(Nurbs, OfABezierNetIsTheCompositeSurface)
{
    const auto net = test::random_net(3, {2, 1}, 4);
    const Surface bezier = composite_bezier(2, 1, net);
    const Surface nurbs = nurbs_surface(
        {{3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}}, {3, {0, 0, 0, 0, 1, 1, 1, 1}}, net, {}});
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 16; ++k)
            EXPECT_EQ(nurbs.patch(i, 0).control_point(k % 4, k / 4),
                      bezier.patch(i, 0).control_point(k % 4, k / 4));
}

TEST(Nurbs, CylinderHasItsCurvatureAreaAndLargestBall)
{
    const Surface surface = nurbs_surface(test::cylinder(12, 30, 0.3, 2.8, 3));
    EXPECT_NEAR(area(surface), 12 * 30 * 2.5, 1e-9 * 900);
    const double outside = tool_side_sign(surface, Vec3::UnitZ());
    const auto range = curvature_range(surface, outside);
    ASSERT_TRUE(range);
    EXPECT_NEAR(range->greatest, 1 / 12.0, 1e-12);
    EXPECT_NEAR(range->least, 0, 1e-12);
    EXPECT_FALSE(largest_cutter(surface, outside));
    const auto inside = largest_cutter(surface, -outside);
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->radius_mm, 12, 12e-9);
}

TEST(Nurbs, SphereHasItsCurvatureAreaAndLargestBall)
{
    const Surface surface = nurbs_surface(test::torus(0, 8, {0, 1.5, 0.25, 1.25, 2}));
    const double expected = 64 * 1.5 * (std::sin(1.25) - std::sin(0.25));
    EXPECT_NEAR(area(surface), expected, 1e-9 * expected);
    const double outside = tool_side_sign(surface, Vec3::UnitZ());
    const auto range = curvature_range(surface, outside);
    ASSERT_TRUE(range);
    EXPECT_NEAR(range->greatest, 0.125, 1e-12);
    EXPECT_NEAR(range->least, 0.125, 1e-12);
    EXPECT_FALSE(largest_cutter(surface, outside));
    const auto inside = largest_cutter(surface, -outside);
    ASSERT_TRUE(inside);
    EXPECT_NEAR(inside->radius_mm, 8, 8e-9);
}

TEST(Nurbs, TorusHasItsCurvatureAreaAndLargestBall)
{
    constexpr double R = 30;
    constexpr double r = 10;
    // the upper part, with the normal towards the inside
    const Surface surface = nurbs_surface(test::torus(R, r, {0, 2, 0.4, 2.5, 2}));
    const double expected = r * 2 * (R * 2.1 + r * (std::sin(2.5) - std::sin(0.4)));
    EXPECT_NEAR(area(surface), expected, 1e-9 * expected);
    const double side = tool_side_sign(surface, Vec3::UnitZ());
    for (const double u : {0.0, 0.4, 1.3, 2.0})
        for (const double v : {0.1, 0.9, 1.6}) {
            const SurfaceJet jet = surface.jet(u, v);
            const double rho = std::hypot(jet.point.x(), jet.point.y());
            const auto k = principal_curvatures(fundamental_forms(jet, side));
            EXPECT_NEAR(k.greatest, 1 / r, 1e-12);
            EXPECT_NEAR(k.least, (rho - R) / (r * rho), 1e-12);
        }
    const auto limit = largest_cutter(surface, side);
    ASSERT_TRUE(limit);
    const double rho = R + r * std::cos(2.5);
    EXPECT_NEAR(limit->radius_mm, -r * rho / (rho - R), 1e-9 * 100);
}

TEST(Nurbs, LargestBallDoesNotDependOnTheScaleOfItsKnots)
{
    Nurbs trough = test::cylinder(12, 30, pi + 0.3, 2 * pi - 0.3, 2);
    const auto expected = largest_cutter(nurbs_surface(trough), 1);
    ASSERT_TRUE(expected);
    for (const double scale : {1e-40, 1e-6, 1e9, 1e40}) {
        Nurbs scaled = trough;
        for (SplineParameter* parameter : {&scaled.u, &scaled.v})
            for (double& knot : parameter->knots)
                knot *= scale;
        const auto found = largest_cutter(nurbs_surface(scaled), 1);
        ASSERT_TRUE(found) << scale;
        EXPECT_NEAR(found->radius_mm, expected->radius_mm, 1e-6) << scale;
    }
}

TEST(Nurbs, FlawsAreNamed)
{
    EXPECT_EQ(flaw({2, {0, 0, 0, 1, 1, 1}}), "");
    EXPECT_EQ(flaw({0, {0, 1}}), "the degree is not in 1 … 25");
    EXPECT_EQ(flaw({26, {0, 1}}), "the degree is not in 1 … 25");
    EXPECT_EQ(flaw({1, {0, 0, NAN, 1}}), "a knot is not finite");
    EXPECT_EQ(flaw({1, {0, 1, 0.5, 1}}), "the knots fall");
    EXPECT_EQ(flaw({2, {0, 0, 1, 1}}), "there are fewer than degree + 1 control points");
    EXPECT_EQ(flaw({1, {0, 0, 1, 1, 1, 2, 2}}),
              "a knot is repeated more than degree + 1 times");
    EXPECT_EQ(flaw({1, {0, 1, 1, 2}}),
              "the range between knot [degree] and knot [points] is empty");
    for (const double range : {1e-60, 1e60})
        EXPECT_EQ(
            flaw({1, {0, 0, range, range}}),
            "the range between knot [degree] and knot [points] is not within 1e-50 … "
            "1e50");
    EXPECT_EQ(flaw({1, {0, 0, 1e-13, 1, 1}}),
              "two knots lie closer than 1e-12 of the range");
    const SplineParameter line{1, {0, 0, 1, 1}};
    EXPECT_THROW(nurbs_surface({line, {1, {0, 1, 0, 1}}, {}, {}}), DomainError);
    EXPECT_THROW(nurbs_surface({line, line, std::vector<Vec3>(3, Vec3::Zero()), {}}),
                 DomainError);
    EXPECT_THROW(nurbs_surface({line, line, std::vector<Vec3>(4, Vec3::Zero()), {1, 1}}),
                 DomainError);
}

// The control points of all patches of both surfaces, and their parameters, are equal.
void expect_same(const Surface& one, const Surface& two, double error)
{
    for (const Parameter along : {Parameter::U, Parameter::V}) {
        ASSERT_EQ(one.patches(along), two.patches(along));
        const auto breaks = one.breaks(along);
        const auto others = two.breaks(along);
        EXPECT_EQ(std::vector(breaks.begin(), breaks.end()),
                  std::vector(others.begin(), others.end()));
    }
    for (int j = 0; j < one.patches(Parameter::V); ++j)
        for (int i = 0; i < one.patches(Parameter::U); ++i)
            for (int b = 0; b <= one.patch(i, j).degree(Parameter::V); ++b)
                for (int a = 0; a <= one.patch(i, j).degree(Parameter::U); ++a)
                    EXPECT_LE((one.patch(i, j).control_point(a, b) -
                               two.patch(i, j).control_point(a, b))
                                  .norm(),
                              error);
}

TEST(NurbsOf, GivesBackThePatchesOfANet)
{
    std::vector<Vec3> net;
    for (int j = 0; j < 7; ++j)
        for (int i = 0; i < 10; ++i)
            net.emplace_back(i, j / 3.0, std::sin(7.0 * i + 3.0 * j));
    const Surface surface = composite_bezier(3, 2, net, ToolSide::DvCrossDu);
    const Nurbs nurbs = nurbs_of(surface);
    EXPECT_EQ(nurbs.control_points.size(), 70U);  // shared ones stand once
    EXPECT_TRUE(nurbs.weights.empty());
    expect_same(nurbs_surface(nurbs, surface.tool_side()), surface, 0);
}

TEST(NurbsOf, KeepsAGapAndRationalPatches)
{
    const BezierPatch low{1, 1,
                          std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
    const BezierPatch high{1, 1,
                           std::vector<Vec3>{{1, 0, 2}, {2, 0, 2}, {1, 1, 2}, {2, 1, 2}}};
    const Surface apart{{0, 1, 3}, {0, 1}, {low, high}};
    expect_same(nurbs_surface(nurbs_of(apart)), apart, 0);

    const double w = std::sqrt(0.5);
    const Surface quarter = nurbs_surface({{2, {0, 0, 0, 0.3, 1, 1, 1}},
                                           {1, {0, 0, 1, 1}},
                                           {{20, 0, 0},
                                            {20, 0, 9},
                                            {9, 0, 20},
                                            {0, 0, 20},
                                            {20, 5, 0},
                                            {20, 5, 9},
                                            {9, 5, 20},
                                            {0, 5, 20}},
                                           {1, w, 0.8, 1, 1, w, 0.8, 1}});
    expect_same(nurbs_surface(nurbs_of(quarter)), quarter, 1e-14 * 20);
}

TEST(NurbsOf, RefusesPatchesOfDifferentDegrees)
{
    const BezierPatch line{1, 1,
                           std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}};
    const BezierPatch arc{
        2, 1,
        std::vector<Vec3>{
            {1, 0, 0}, {2, 0, 1}, {3, 0, 0}, {1, 1, 0}, {2, 1, 1}, {3, 1, 0}}};
    EXPECT_THROW(nurbs_of(Surface{{0, 1, 2}, {0, 1}, {line, arc}}), DomainError);
}

}  // namespace
}  // namespace endmill
