// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/arc_fitting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

ToolPath cuts(const std::vector<Vec3>& tips)
{
    ToolPath path;
    for (const Vec3& tip : tips)
        path.points.push_back({0,
                               static_cast<int>(path.points.size()),
                               Move::Cut,
                               0,
                               {tip, Vec3::UnitZ()}});
    return path;
}

// Points of a circle in a plane, at equal angles.
std::vector<Vec3> on_circle(ArcPlane plane, double radius, double from, double step,
                            int count)
{
    const PlaneAxes axes = plane_axes(plane);
    std::vector<Vec3> tips;
    for (int k = 0; k < count; ++k) {
        Vec3 tip{3, -2, 7};
        tip[axes.first] += radius * std::cos(from + k * step);
        tip[axes.second] += radius * std::sin(from + k * step);
        tips.push_back(tip);
    }
    return tips;
}

double distance_to_moves(const ToolPath& path, std::size_t first, std::size_t last,
                         const Vec3& place)
{
    double least = HUGE_VAL;
    for (std::size_t k = first + 1; k <= last; ++k) {
        const Vec3& from = path.points[k - 1].location.tip;
        const Vec3 along = path.points[k].location.tip - from;
        const double length = along.squaredNorm();
        const double part = length > 0 ? (place - from).dot(along) / length : 0;
        least =
            std::min(least, (from + std::clamp(part, 0.0, 1.0) * along - place).norm());
    }
    return least;
}

// The distance between arc and moves in both directions, by dense samples, less the error
// of the sampling. The arc is sampled by its definition: equal angles about the centre.
double sampled_distance(const ToolPath& path, std::size_t first, const FittedArc& fitted)
{
    const PlaneAxes axes = plane_axes(fitted.arc.plane);
    const auto angle = [&](const Vec3& place) {
        return std::atan2(place[axes.second] - fitted.arc.centre[axes.second],
                          place[axes.first] - fitted.arc.centre[axes.first]);
    };
    const double begin = angle(fitted.arc.start);
    double sweep = angle(fitted.arc.end) - begin;
    if (fitted.arc.clockwise && sweep > 0)
        sweep -= 2 * pi;
    if (!fitted.arc.clockwise && sweep < 0)
        sweep += 2 * pi;
    const double radius = arc_radii(fitted.arc).start;
    std::vector<Vec3> samples;
    double worst = 0;
    for (int k = 0; k <= 2000; ++k) {
        Vec3 place = fitted.arc.start;
        place[axes.first] =
            fitted.arc.centre[axes.first] + radius * std::cos(begin + sweep * k / 2000);
        place[axes.second] =
            fitted.arc.centre[axes.second] + radius * std::sin(begin + sweep * k / 2000);
        samples.push_back(place);
        worst = std::max(worst, distance_to_moves(path, first, fitted.last, place));
    }
    const ToolPath dense = cuts(samples);
    for (std::size_t k = first; k <= fitted.last; ++k)
        worst = std::max(worst, distance_to_moves(dense, 0, samples.size() - 1,
                                                  path.points[k].location.tip));
    return worst - radius * (1 - std::cos(sweep / 4000));
}

class ArcFittingIn : public testing::TestWithParam<ArcPlane> {};

// The sagitta of the chords is R (1 - cos(step / 2)).
TEST_P(ArcFittingIn, FindsCirclesOfEverySizeAndSense)
{
    for (const double radius : {0.5, 10.0, 300.0})
        for (const double step : {0.02, -0.02}) {
            const double sagitta = radius * (1 - std::cos(step / 2));
            const ToolPath path = cuts(on_circle(GetParam(), radius, 0.7, step, 101));
            const auto fitted = longest_arc(path, 0, path.points.size(),
                                            {.tolerance_mm = sagitta + 4e-4});
            ASSERT_TRUE(fitted) << radius;
            EXPECT_EQ(fitted->last, 100U);
            EXPECT_EQ(fitted->arc.clockwise, step < 0);
            EXPECT_EQ(fitted->arc.plane, GetParam());
            EXPECT_NEAR(arc_radii(fitted->arc).start, radius, 1e-3);
            EXPECT_LE(fitted->error_mm, sagitta + 4e-4);
            EXPECT_LE(sampled_distance(path, 0, *fitted), fitted->error_mm + 1e-6);
        }
}

TEST_P(ArcFittingIn, KeepsTheToleranceOfTheChordsToo)
{
    const double sagitta = 10 * (1 - std::cos(0.05));
    const ToolPath path = cuts(on_circle(GetParam(), 10, 0, 0.1, 20));
    EXPECT_TRUE(longest_arc(path, 0, 20, {.tolerance_mm = 1.1 * sagitta}));
    EXPECT_FALSE(longest_arc(path, 0, 20, {.tolerance_mm = 0.9 * sagitta}));
}

// A circle of 10 mm has 314 steps of 0.02; an arc may turn by at most 3.
TEST_P(ArcFittingIn, TurnsByLessThanHalfATurn)
{
    const ToolPath path = cuts(on_circle(GetParam(), 10, 0, 0.02, 315));
    for (const ArcForm form : {ArcForm::Centre, ArcForm::Radius}) {
        const auto fitted =
            longest_arc(path, 0, 315, {.tolerance_mm = 0.003, .form = form});
        ASSERT_TRUE(fitted);
        EXPECT_LE(fitted->last, 150U);
        EXPECT_GE(fitted->last, 100U);
        EXPECT_EQ(fitted->radius.has_value(), form == ArcForm::Radius);
        EXPECT_LE(sampled_distance(path, 0, *fitted), fitted->error_mm + 1e-6);
    }
}

TEST_P(ArcFittingIn, EndsWhereTheCircleEnds)
{
    std::vector<Vec3> tips = on_circle(GetParam(), 10, 0, 0.02, 60);
    const PlaneAxes axes = plane_axes(GetParam());
    for (int k = 1; k <= 20; ++k) {  // a straight line, square to the circle
        tips.push_back(tips[59]);
        tips.back()[axes.first] += 0.2 * k * std::cos(0.02 * 59);
        tips.back()[axes.second] += 0.2 * k * std::sin(0.02 * 59);
    }
    const auto fitted = longest_arc(cuts(tips), 0, tips.size(), {.tolerance_mm = 0.001});
    ASSERT_TRUE(fitted);
    EXPECT_EQ(fitted->last, 59U);
}

// The last but one point is off the plane, and the last chord is the longest: the largest
// distance is within this chord, which ends in the plane.
TEST_P(ArcFittingIn, CountsTheDistanceFromThePlaneAtBothEndsOfAChord)
{
    for (const double off_plane : {0.004, 0.008, 0.0125}) {
        std::vector<Vec3> tips = on_circle(GetParam(), 10, 0, 0.04, 22);
        tips.back() = on_circle(GetParam(), 10, 0.9, 0, 1).front();
        tips[20][plane_axes(GetParam()).normal] += off_plane;
        const ToolPath path = cuts(tips);
        const auto fitted = longest_arc(path, 0, tips.size(), {.tolerance_mm = 0.018});
        ASSERT_TRUE(fitted);
        EXPECT_LE(fitted->error_mm, 0.018);
        EXPECT_LE(sampled_distance(path, 0, *fitted), fitted->error_mm + 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(Planes, ArcFittingIn,
                         testing::Values(ArcPlane::Xy, ArcPlane::Zx, ArcPlane::Yz));

TEST(ArcFitting, LeavesLinesCornersAndHelicesAlone)
{
    std::vector<Vec3> line;
    std::vector<Vec3> zigzag;
    std::vector<Vec3> back;
    std::vector<Vec3> helix = on_circle(ArcPlane::Xy, 10, 0, 0.02, 30);
    for (int k = 0; k < 30; ++k) {
        line.push_back({0.1 * k, 0.2 * k, 0});
        zigzag.push_back({0.1 * k, k % 2 == 0 ? 0 : 0.01, 0});
        back.push_back({k < 15 ? 0.1 * k : 3 - 0.1 * k, 0.001 * k * k, 0});
        helix[static_cast<std::size_t>(k)].z() = 0.01 * k;
    }
    for (const auto& tips : {line, zigzag, helix})
        EXPECT_FALSE(longest_arc(cuts(tips), 0, tips.size(), {.tolerance_mm = 0.002}));
    const auto fitted = longest_arc(cuts(back), 0, back.size(), {.tolerance_mm = 0.002});
    EXPECT_TRUE(!fitted || fitted->last < 16);
    const std::vector<Vec3> same(10, Vec3{1, 2, 3});
    EXPECT_FALSE(longest_arc(cuts(same), 0, same.size(), {.tolerance_mm = 1}));
    EXPECT_FALSE(longest_arc(cuts(line), 0, 3, {.tolerance_mm = 1}));
}

// Random smooth curves, coarse decimals and inches: whatever is fitted keeps its bound.
TEST(ArcFitting, BoundsTheDistanceOfWhateverItFits)
{
    test::Random random{5};
    int fitted_arcs = 0;
    for (int curve = 0; curve < 200; ++curve) {
        const double bend = random.uniform(-0.1, 0.1);
        const double change = random.uniform(-0.002, 0.002);
        const double step = random.uniform(0.05, 1);
        std::vector<Vec3> tips{{random.uniform(-50, 50), random.uniform(-50, 50), 1}};
        double heading = random.uniform(0, 2 * pi);
        for (int k = 0; k < 60; ++k) {
            heading += bend + change * k;
            tips.push_back(tips.back() +
                           step * Vec3{std::cos(heading), std::sin(heading), 0});
        }
        const ToolPath path = cuts(tips);
        const ArcFitting fitting{
            .tolerance_mm = random.uniform(0.001, 0.05),
            .form = curve % 2 == 0 ? ArcForm::Centre : ArcForm::Radius,
            .decimals = curve % 3 + 2,
            .unit_mm = curve % 5 == 0 ? 25.4 : 1};
        const auto fitted = longest_arc(path, 0, tips.size(), fitting);
        if (!fitted)
            continue;
        ++fitted_arcs;
        EXPECT_LE(fitted->error_mm, fitting.tolerance_mm);
        EXPECT_LE(sampled_distance(path, 0, *fitted), fitted->error_mm + 1e-6) << curve;
    }
    EXPECT_GT(fitted_arcs, 40);
}

}  // namespace
}  // namespace endmill
