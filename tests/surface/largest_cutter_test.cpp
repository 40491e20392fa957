// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/largest_cutter.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/surface/curvature.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double stated = 1e-8;

// A channel along y: straight walls at x = -half_gap and x = half_gap down to z = 0,
// which then widen over `drop` mm to a bowl with a radius of about `half_bulge`. u runs
// down the left wall and up the right one, so that du x dv points into the channel.
Surface bottleneck(double half_gap, double half_bulge, double drop)
{
    const double depth = drop + 4 * half_bulge / 3;
    const std::vector<Eigen::Vector2d> left{
        {-half_gap, 30},      {-half_gap, 20},        {-half_gap, 10},
        {-half_gap, 0},       {-half_gap, -drop / 2}, {-half_bulge, -drop / 2},
        {-half_bulge, -drop}, {-half_bulge, -depth}};
    std::vector<Eigen::Vector2d> profile = left;
    for (std::size_t k = left.size(); k-- > 0;)
        profile.emplace_back(-left[k].x(), left[k].y());
    std::vector<Vec3> net;
    for (int row = 0; row < 4; ++row)
        for (const Eigen::Vector2d& point : profile)
            net.emplace_back(point.x(), 20 * row, point.y());
    return composite_bezier(5, 1, net, ToolSide::DuCrossDv);
}

std::vector<SurfaceJet> sampled_jets(const Surface& surface, int per_patch)
{
    std::vector<SurfaceJet> jets;
    const int columns = per_patch * surface.patches(Parameter::U);
    const int rows = per_patch * surface.patches(Parameter::V);
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column)
            jets.push_back(
                surface.jet(column / double(per_patch), row / double(per_patch)));
    return jets;
}

double radius_by_sampled_curvature(const Surface& surface, double side, int per_patch)
{
    double tightest = 0;
    for (const SurfaceJet& jet : sampled_jets(surface, per_patch))
        tightest =
            std::max(tightest, -principal_curvatures(fundamental_forms(jet, side)).least);
    return 1 / tightest;
}

// Over pairs of one patch that are at least an eighth of the patch apart.
double radius_by_sampled_pairs(const Surface& surface, double side, int samples)
{
    const std::vector<SurfaceJet> jets = sampled_jets(surface, samples);
    const auto column = [&](std::size_t k) { return int(k) % (samples + 1); };
    const auto row = [&](std::size_t k) { return int(k) / (samples + 1); };
    double least = 1e300;
    for (std::size_t p = 0; p < jets.size(); ++p) {
        const Vec3 normal = side * unit_normal({jets[p].point, jets[p].du, jets[p].dv});
        for (std::size_t q = 0; q < jets.size(); ++q) {
            if (8 * std::max(std::abs(column(p) - column(q)), std::abs(row(p) - row(q))) <
                samples)
                continue;
            const Vec3 chord = jets[q].point - jets[p].point;
            const double height = normal.dot(chord);
            if (height > 0)
                least = std::min(least, chord.squaredNorm() / (2 * height));
        }
    }
    return least;
}

TEST(LargestCutter, OfASaddleHasItsConstantAsRadiusAndStandsInTheMiddle)
{
    // Off the centre, so that the limiting place is no sample.
    const Surface surface =
        test::graph(test::monomial(2, 0, 1.0 / 64) + test::monomial(0, 2, -1.0 / 64),
                    {{-31, 47}, {-45, 36}}, {2, 1});
    for (const auto& limit :
         {largest_cutter(surface, 1), largest_cutter_by_curvature(surface, 1)}) {
        ASSERT_TRUE(limit);
        EXPECT_LT(test::relative_error(limit->radius_mm, 32), stated);
        EXPECT_LT(limit->point.norm(), 1e-2);
        EXPECT_LT((surface.jet(limit->at.u, limit->at.v).point - limit->point).norm(),
                  1e-12);
    }
}

TEST(LargestCutter, OfASaddleFromBelowIsTheSame)
{
    const Surface surface = test::saddle(32, 40);
    EXPECT_LT(test::relative_error(largest_cutter(surface, -1)->radius_mm, 32), stated);
}

TEST(LargestCutter, OfAParabolicTroughIsTheRadiusAtItsBottom)
{
    const Surface trough =
        test::graph(test::monomial(2, 0, 0.02), {{-33, 44}, {0, 50}}, {2, 1});
    const auto limit = largest_cutter(trough, 1);
    ASSERT_TRUE(limit);
    EXPECT_LT(test::relative_error(limit->radius_mm, 25), stated);
    EXPECT_NEAR(limit->point.x(), 0, 1e-2);
}

TEST(LargestCutter, OfHalfATroughStandsAtTheBorderNearestToTheBottom)
{
    const Surface half =
        test::graph(test::monomial(2, 0, 0.02), {{10, 44}, {0, 50}}, {1, 1});
    const auto limit = largest_cutter(half, 1);
    ASSERT_TRUE(limit);
    EXPECT_LT(test::relative_error(limit->radius_mm, 25 * std::pow(1 + 0.16, 1.5)),
              stated);
    EXPECT_EQ(limit->at.u, 0);
}

TEST(LargestCutter, OfABowlIsTheRadiusAtItsPole)
{
    const Surface bowl =
        test::graph(test::monomial(2, 0, 1.0 / 30) + test::monomial(0, 2, 1.0 / 30),
                    {{-20, 13}, {-11, 20}});
    EXPECT_LT(test::relative_error(largest_cutter(bowl, 1)->radius_mm, 15), stated);
}

TEST(LargestCutter, ThereIsNoneOnPlanes)
{
    for (const Surface& plane : {test::plane(200, 120, {2, 1}),
                                 test::parallelogram({200, 10, 30}, {60, 120, -20}),
                                 test::parallelogram({1e3, 1, 0}, {0, 0.1, 0.01})}) {
        EXPECT_FALSE(largest_cutter(plane, 1));
        EXPECT_FALSE(largest_cutter_by_curvature(plane, 1));
    }
}

TEST(LargestCutter, ThereIsNoneOnADomeFromAbove)
{
    const Surface dome =
        test::graph(test::monomial(2, 0, -0.02) + test::monomial(0, 2, -0.01),
                    {{-30, 30}, {-30, 30}});
    EXPECT_FALSE(largest_cutter(dome, 1));
    EXPECT_TRUE(largest_cutter(dome, -1));
}

TEST(LargestCutter, ThereIsNoneOnAConvexPartOfManyPatches)
{
    const Surface dome =
        test::graph(test::monomial(2, 0, -0.002) + test::monomial(0, 2, -0.003),
                    {{-100, 100}, {-60, 60}}, {4, 4});
    EXPECT_FALSE(largest_cutter(dome, 1));
}

TEST(LargestCutter, ThereIsNoneOnAPoint)
{
    const Surface point = composite_bezier(1, 1, std::vector<Vec3>(16, Vec3{1, 2, 3}));
    EXPECT_FALSE(largest_cutter(point, 1));
    EXPECT_FALSE(curvature_range(point, 1));
}

TEST(LargestCutter, BetweenTwoWallsIsHalfTheirDistance)
{
    for (const double half_gap : {6.0, 8.0}) {
        const Surface channel = bottleneck(half_gap, 12, 60);
        const auto global = largest_cutter(channel, 1);
        const auto local = largest_cutter_by_curvature(channel, 1);
        ASSERT_TRUE(global && local);
        EXPECT_GT(local->radius_mm, 1.2 * half_gap) << "curvature alone does not see it";
        EXPECT_LT(test::relative_error(global->radius_mm, half_gap), stated);
        EXPECT_NEAR(std::abs(global->point.x()), half_gap, 1e-6);
    }
}

TEST(LargestCutter, BetweenTwoPlatesIsHalfTheirDistance)
{
    // Two parallel planes 10 mm apart that face each other, without curvature.
    std::vector<BezierPatch> plates;
    plates.push_back(test::parallelogram({50, 0, 0}, {0, 40, 0}).patch(0, 0));
    std::vector<Vec3> above;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            above.emplace_back(50 - 50 * i / 3.0, 40 * j / 3.0, 10);
    plates.emplace_back(above);
    const Surface surface{{0, 1, 2}, {0, 1}, plates, ToolSide::DuCrossDv};
    EXPECT_FALSE(largest_cutter_by_curvature(surface, 1));
    const auto limit = largest_cutter(surface, 1);
    ASSERT_TRUE(limit);
    EXPECT_LT(test::relative_error(limit->radius_mm, 5), stated);
}

// z = bend (x - middle)^2 / 2 over 40 mm, starting at `left`.
BezierPatch trough_patch(double bend, double middle, double left)
{
    const test::Polynomial height = test::monomial(2, 0, bend / 2) +
                                    test::monomial(1, 0, -bend * middle) +
                                    test::monomial(0, 0, bend * middle * middle / 2);
    return test::graph(height, {{left, left + 40}, {0, 40}}).patch(0, 0);
}

TEST(LargestCutter, OfTwoTroughsIsTheTighterOne)
{
    // Both troughs are wide. The bottom of the tighter one is between two of the 33
    // samples, that of the other one is a sample.
    const Surface surface{
        {0, 1, 2},
        {0, 1},
        {trough_patch(1 / 20.0, 0, -20), trough_patch(1 / 19.98, 100, 79.375)}};
    EXPECT_LT(
        test::relative_error(largest_cutter_by_curvature(surface, 1)->radius_mm, 19.98),
        stated);
    EXPECT_LT(test::relative_error(largest_cutter(surface, 1)->radius_mm, 19.98), stated);
}

TEST(LargestCutter, ByCurvatureIsTheLimitOfDenseScans)
{
    for (unsigned seed = 0; seed < 3; ++seed) {
        const Surface surface = test::random_surface(seed, {2, 1}, 3);
        const double found = largest_cutter_by_curvature(surface, 1)->radius_mm;
        const double scanned = radius_by_sampled_curvature(surface, 1, 100);
        EXPECT_LE(found, scanned * (1 + 1e-12)) << seed;
        EXPECT_GT(found, 0.99 * scanned) << seed;
    }
}

TEST(LargestCutter, IsTheLimitOfScansOfAllPairs)
{
    for (unsigned seed = 10; seed < 13; ++seed) {
        const Surface surface = test::random_surface(seed, {1, 1}, 8);
        const double found = largest_cutter(surface, 1)->radius_mm;
        const double scanned = std::min(radius_by_sampled_pairs(surface, 1, 32),
                                        radius_by_sampled_curvature(surface, 1, 150));
        EXPECT_LE(found, scanned * (1 + 1e-9)) << seed;
        EXPECT_GT(found, 0.98 * scanned) << seed;
    }
}

TEST(LargestCutter, ScalesWithThePart)
{
    for (const double scale : {0x1p-20, 0x1p20}) {
        std::vector<Vec3> net = test::random_net(20, {1, 1}, 3);
        const auto limit = largest_cutter(composite_bezier(1, 1, net), 1);
        for (Vec3& point : net)
            point *= scale;
        const auto scaled = largest_cutter(composite_bezier(1, 1, net), 1);
        EXPECT_EQ(scaled->radius_mm, scale * limit->radius_mm);
        EXPECT_EQ(scaled->at.u, limit->at.u);
    }
}

TEST(CurvatureRange, OfATroughRunsFromItsBottomToFlat)
{
    const auto range = curvature_range(
        test::graph(test::monomial(2, 0, 0.02), {{-33, 44}, {0, 50}}, {2, 1}), 1);
    ASSERT_TRUE(range);
    EXPECT_LT(test::relative_error(range->least, -0.04), 1e-10);
    EXPECT_NEAR(range->greatest, 0, 1e-12);
}

TEST(CurvatureRange, OfABowlEndsAtItsPoleAndItsCorner)
{
    constexpr double c = 15;
    const auto range = curvature_range(
        test::graph(test::monomial(2, 0, 0.5 / c) + test::monomial(0, 2, 0.5 / c),
                    {{-20, 13}, {-11, 21}}, {2, 2}),
        1);
    ASSERT_TRUE(range);
    const double steep = 1 + (20 * 20 + 21 * 21) / (c * c);
    EXPECT_LT(test::relative_error(range->least, -1 / c), 1e-10);
    EXPECT_LT(test::relative_error(range->greatest, -1 / (c * std::pow(steep, 1.5))),
              1e-10);
}

TEST(CurvatureRange, ConsidersBothSidesOfABorder)
{
    // A plane, followed by a parabola with the same tangent: the curvature jumps at u =
    // 1.
    std::vector<BezierPatch> patches{
        test::graph(test::monomial(0, 0, 0), {{-20, 0}, {0, 9}}).patch(0, 0)};
    patches.push_back(
        test::graph(test::monomial(2, 0, -0.05), {{0, 20}, {0, 9}}).patch(0, 0));
    const auto range = curvature_range(Surface{{0, 1, 2}, {0, 1}, patches}, 1);
    ASSERT_TRUE(range);
    EXPECT_LT(test::relative_error(range->greatest, 0.1), 1e-10);
    EXPECT_NEAR(range->least, 0, 1e-15);
}

// (x, x y, bend x^2 / 2) + off for 0 <= x, y <= 1: a fan on a parabolic cylinder, whose
// edge x = 0 collapses to the point `off`.
Surface fan(double bend, const Vec3& off)
{
    return test::polynomial_surface(
        {test::monomial(1, 0, 1) + test::monomial(0, 0, off.x()),
         test::monomial(1, 1, 1) + test::monomial(0, 0, off.y()),
         test::monomial(2, 0, bend / 2) + test::monomial(0, 0, off.z())},
        {{0, 1}, {0, 1}});
}

TEST(CurvatureRange, SkipsAPole)
{
    for (const Vec3& off : {Vec3{0, 0, 0}, {7.3, 11.1, 0.7}, {-100.1, 3.7, 33.3}}) {
        const auto range = curvature_range(fan(0.5, off), 1);
        ASSERT_TRUE(range);
        EXPECT_NEAR(range->least, -0.5, 0.01) << off.transpose();
        EXPECT_NEAR(range->greatest, 0, 1e-5) << off.transpose();
    }
}

TEST(LargestCutter, OfAPartWithAPoleIsThatBesideThePole)
{
    for (const Vec3& off : {Vec3{0, 0, 0}, {7.3, 11.1, 0.7}}) {
        const auto limit = largest_cutter(fan(0.5, off), 1);
        ASSERT_TRUE(limit);
        EXPECT_NEAR(limit->radius_mm, 2, 0.02) << off.transpose();
    }
}

}  // namespace
}  // namespace endmill
