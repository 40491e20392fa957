// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_fit.h"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "direction_sets.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

using test::degree;
using test::degrees;
using test::direction;
using test::directions;
using test::expect_range;
using test::square_degrees;
using test::turned_to;
using test::up;

constexpr std::array all_modes{SetupMode::PaperLiteral, SetupMode::Paper,
                               SetupMode::Corrected};

PoseFitOptions options(SetupMode mode, const RotaryLimits& limits = {})
{
    return {RotaryFamily::AB, mode, limits};
}

double least_area(const std::vector<Vec3>& points, SetupMode mode)
{
    return square_degrees(rectangle_fit(up, points, options(mode)).least->area);
}

std::vector<Vec3> corners(const RotaryRange& alpha, const RotaryRange& beta)
{
    std::vector<Vec3> result;
    for (const double a : {alpha.from, alpha.to}) {
        for (const double b : {beta.from, beta.to})
            result.push_back(turned_to(a, b));
    }
    return result;
}

TEST(RectangleFit, IsTheRectangleOfItsCorners)
{
    for (const SetupMode mode : all_modes) {
        const PoseSearchResult found =
            rectangle_fit(up, corners({-20, 50}, {-15, 30}), options(mode));
        EXPECT_NEAR(square_degrees(found.least->area), 3150, 1e-6);
        EXPECT_NEAR(std::abs(found.least->pose.r1_axis.x()), 1, 1e-12);
        expect_range(found.least->phi, -20, 50);
        EXPECT_NEAR(std::max(found.least->theta.to, -found.least->theta.from),
                    30 * degree, 1e-9);
    }
}

TEST(RectangleFit, TakesBetaOverAllDirectionsUnlessLiteral)
{
    std::vector<Vec3> points = corners({-60, 60}, {-10, 40});
    points.push_back(turned_to(0, 50));
    EXPECT_NEAR(least_area(points, SetupMode::PaperLiteral), 6000, 1e-6);
    EXPECT_NEAR(least_area(points, SetupMode::Paper), 7200, 1e-6);
    EXPECT_NEAR(least_area(points, SetupMode::Corrected), 7200, 1e-6);
}

TEST(RectangleFit, HasTheToolAxisAtACorner)
{
    const std::vector<Vec3> points{turned_to(10, 0), turned_to(40, 20),
                                   turned_to(40, -10)};
    for (const SetupMode mode : all_modes) {
        const PoseSearchResult found = rectangle_fit(up, points, options(mode));
        EXPECT_NEAR(square_degrees(found.least->area), 1200, 1e-6);
        expect_range(found.least->phi, 0, 40);
        EXPECT_NEAR(least_area(directions({{0, 30}, {90, 40}}), mode), 1200, 1e-6);
    }
}

TEST(RectangleFit, IsAnArcForDirectionsOnOneGreatCircle)
{
    const std::vector<Vec3> points{turned_to(10, 0), turned_to(30, 0), turned_to(-20, 0)};
    for (const SetupMode mode : all_modes) {
        const PoseSearchResult found = rectangle_fit(up, points, options(mode));
        EXPECT_EQ(found.status, SetupStatus::FourAxis);
        EXPECT_EQ(found.least->area, 0);
        expect_range(found.least->phi, -20, 30);
        expect_range(found.least->theta, 0, 0);
    }
    EXPECT_EQ(rectangle_fit(up, {}, options(SetupMode::Paper)).status,
              SetupStatus::ThreeAxis);
}

struct Ring {
    int count;
    double polar;
};

class RectangleOfARing : public testing::TestWithParam<Ring> {};

TEST_P(RectangleOfARing, HasTheAreaOfTheClosedForm)
{
    const auto [count, polar] = GetParam();
    const double p = polar * degree;
    const auto wide = [&](double angle) {
        return std::atan(std::tan(p) * std::cos(angle * degree)) / degree;
    };
    const auto high = [&](double angle) {
        return std::asin(std::sin(p) * std::cos(angle * degree)) / degree;
    };
    const double n = count;
    double paper = 4 * wide(180 / n) * high(180 / n);
    double corrected = paper;
    if (count % 4 == 2) {
        paper = 4 * polar * wide(180 / n);
        corrected = 4 * polar * high(180 / n);
    } else if (count % 2 != 0) {
        paper = 2 * (polar + wide(180 / n)) * high(90 / n);
        corrected = 2 * wide(90 / n) * (polar + high(180 / n));
    }
    std::vector<Vec3> points = test::ring(count, polar);
    points.push_back(points.front());
    EXPECT_NEAR(least_area(points, SetupMode::Paper), paper, 1e-6 * paper);
    EXPECT_NEAR(least_area(points, SetupMode::Corrected), corrected, 1e-6 * corrected);
}

INSTANTIATE_TEST_SUITE_P(OfEachKind, RectangleOfARing,
                         testing::Values(Ring{3, 30}, Ring{4, 10}, Ring{5, 20},
                                         Ring{6, 40}, Ring{7, 70}, Ring{10, 25},
                                         Ring{12, 15}));

TEST(RectangleFit, AgreesWithTheRingsOfTheTable)
{
    EXPECT_NEAR(least_area(test::ring(4, 10), SetupMode::Paper), 200.505460, 1e-5);
    EXPECT_NEAR(least_area(test::ring(12, 15), SetupMode::Corrected), 840.322218, 1e-5);
    EXPECT_NEAR(least_area(test::ring(5, 20), SetupMode::Paper), 1382.215474, 1e-5);
    EXPECT_NEAR(least_area(test::ring(5, 20), SetupMode::Corrected), 1377.159686, 1e-5);
}

// The least area with R1 at all multiples of 0.01 degrees.
double searched_area(const std::vector<Vec3>& points, double step_deg)
{
    double best = 1e9;
    for (double azimuth = 0; azimuth < 180; azimuth += step_deg) {
        const double c = std::cos(azimuth * degree);
        const double s = std::sin(azimuth * degree);
        double up_tangent = 0;
        double down_tangent = 0;
        double up_sine = 0;
        double down_sine = 0;
        for (const Vec3& v : points) {
            const double tangent = (v.x() * s - v.y() * c) / v.z();
            const double sine = v.x() * c + v.y() * s;
            up_tangent = std::max(up_tangent, tangent);
            down_tangent = std::min(down_tangent, tangent);
            up_sine = std::max(up_sine, sine);
            down_sine = std::min(down_sine, sine);
        }
        best = std::min(best, (std::atan(up_tangent) - std::atan(down_tangent)) *
                                  (std::asin(up_sine) - std::asin(down_sine)));
    }
    return square_degrees(best);
}

TEST(RectangleFit, IsTheLeastOfAllRectanglesIfCorrected)
{
    test::Random random{31};
    double excess = 0;
    double worst = 0;
    int literal_wrong = 0;
    int rectangles = 0;
    constexpr int sets = 1000;
    for (int i = 0; i < sets; ++i) {
        const std::vector<Vec3> points = test::random_directions(random);
        const double corrected = least_area(points, SetupMode::Corrected);
        const double searched = searched_area(points, 0.01);
        EXPECT_LE(corrected, searched * (1 + 1e-12));
        EXPECT_LE(searched, 1.002 * corrected);
        const double above = least_area(points, SetupMode::Paper) / corrected - 1;
        EXPECT_GE(above, -1e-7);
        excess += above / sets;
        worst = std::max(worst, above);
        const auto literal = rectangle_candidates(up, points, SetupMode::PaperLiteral);
        const auto paper = rectangle_candidates(up, points, SetupMode::Paper);
        ASSERT_EQ(literal.size(), paper.size());
        for (std::size_t k = 0; k < paper.size(); ++k) {
            ++rectangles;
            literal_wrong += literal[k].area() < paper[k].area() * (1 - 1e-9) ? 1 : 0;
        }
    }
    EXPECT_NEAR(excess, 0.08, 0.02);
    EXPECT_GT(worst, 1);
    EXPECT_NEAR(1.0 * literal_wrong / rectangles, 0.38, 0.04);
}

// The same with directions 90 degrees or more from the tool axis, from their angles.
TEST(RectangleFit, IsTheLeastOfAllRectanglesBeyondTheHemisphere)
{
    test::Random random{32};
    for (int i = 0; i < 150; ++i) {
        std::vector<Vec3> points;
        for (int k = 0; k < 2 + i % 9; ++k) {
            const double azimuth = random.uniform(0, 360);
            points.push_back(direction({azimuth, random.uniform(10, 100 + i % 70)}));
        }
        const double corrected = least_area(points, SetupMode::Corrected);
        double searched = 1e9;
        for (double azimuth = 0; azimuth < 180; azimuth += 0.1)
            searched = std::min(
                searched, rectangle_about(up, direction({azimuth, 90}), points).area());
        EXPECT_LE(corrected, square_degrees(searched) * (1 + 2e-7));
        const PoseSearchResult found =
            rectangle_fit(up, points, options(SetupMode::Corrected));
        // At alpha = 180 degrees rounding decides the sign, so that R1 is moved slightly.
        const double shift = 1e-8;
        const Vec3& r1 = found.least->pose.r1_axis;
        double beside = 1e9;
        for (const double turn : {-shift, 0.0, shift})
            beside = std::min(
                beside,
                rectangle_about(up, (r1 + turn * up.cross(r1)).normalized(), points)
                    .area());
        EXPECT_NEAR(square_degrees(beside), corrected, 1e-5 * corrected);
    }
}

TEST(RectangleFit, NeedsAnOpenHemisphereInThePapersModes)
{
    const auto points = directions({{0, 30}, {120, 95}, {240, 20}});
    for (const SetupMode mode : {SetupMode::PaperLiteral, SetupMode::Paper}) {
        const PoseSearchResult found = rectangle_fit(up, points, options(mode));
        EXPECT_EQ(found.status, SetupStatus::NoOpenHemisphere);
        EXPECT_EQ(found.poses_skipped, 1U);
        EXPECT_FALSE(found.least);
        EXPECT_FALSE(found.feasible);
    }
    EXPECT_NEAR(least_area(points, SetupMode::Corrected), 4602.510064, 1e-3);
    std::vector<Vec3> opposite = directions({{0, 30}, {120, 35}, {240, 20}});
    opposite.push_back(-up);
    EXPECT_FALSE(rectangle_fit(up, opposite, options(SetupMode::Paper)).least);
    EXPECT_GT(least_area(opposite, SetupMode::Corrected), 0);
    EXPECT_TRUE(rectangle_candidates(up, points, SetupMode::Corrected).empty());
}

TEST(RectangleFit, DoesNotMirrorARigidPart)
{
    const std::vector<Vec3> points = corners({-10, 40}, {-30, 15});
    const RotaryLimits mirrored{degrees(-15, 45), degrees(-20, 35)};
    const PoseSearchResult paper =
        rectangle_fit(up, points, options(SetupMode::Paper, mirrored));
    ASSERT_TRUE(paper.feasible);
    EXPECT_NEAR(square_degrees(paper.feasible->area), 2250, 1e-6);
    EXPECT_FALSE(paper.feasible->is_rigid);
    EXPECT_FALSE(
        rectangle_fit(up, points, options(SetupMode::Corrected, mirrored)).feasible);

    const RotaryLimits straight{degrees(-15, 45), degrees(-35, 20)};
    for (const SetupMode mode : all_modes) {
        const PoseSearchResult found = rectangle_fit(up, points, options(mode, straight));
        ASSERT_TRUE(found.feasible);
        EXPECT_NEAR(square_degrees(found.feasible->area), 2250, 1e-6);
        EXPECT_TRUE(found.feasible->is_rigid);
        expect_range(found.feasible->phi, -10, 40);
        expect_range(found.feasible->theta, -30, 15);
    }
}

// If B comes first, R2 = R1 x C, so that beta is mirrored.
TEST(RectangleFit, MirrorsBetaIfBComesFirst)
{
    const std::vector<Vec3> points = corners({-10, 40}, {-30, 15});
    PoseFitOptions b_first =
        options(SetupMode::Corrected, {degrees(-15, 45), degrees(-20, 35)});
    b_first.order = RotaryOrder::BFirst;
    const PoseSearchResult found = rectangle_fit(up, points, b_first);
    ASSERT_TRUE(found.feasible);
    expect_range(found.feasible->phi, -10, 40);
    expect_range(found.feasible->theta, -15, 30);
    const SetupPose& pose = found.feasible->pose;
    EXPECT_NEAR(pose.r2_axis.dot(pose.r1_axis.cross(pose.tool_axis)), 1, 1e-12);
    b_first.limits.theta = degrees(-35, 20);
    EXPECT_FALSE(rectangle_fit(up, points, b_first).feasible);
}

TEST(RectangleFit, TurnsThePartIfItDoesNotFitOtherwise)
{
    const std::vector<Vec3> points = corners({-10, 40}, {-30, 15});
    const PoseSearchResult found = rectangle_fit(
        up, points, options(SetupMode::Corrected, {degrees(-45, 15), degrees(-20, 35)}));
    ASSERT_TRUE(found.feasible);
    expect_range(found.feasible->phi, -40, 10);
    expect_range(found.feasible->theta, -15, 30);
}

TEST(RectangleFit, FindsTheBestWithADirectionAtALimit)
{
    const auto points = directions({{0, 30}, {120, 30}, {240, 30}});
    const RotaryLimits limits{degrees(-29.95, 29.95), degrees(-27, 27)};
    EXPECT_FALSE(rectangle_fit(up, points, options(SetupMode::Paper, limits)).feasible);
    const PoseSearchResult found =
        rectangle_fit(up, points, options(SetupMode::Corrected, limits));
    ASSERT_TRUE(found.feasible);
    EXPECT_NEAR(square_degrees(found.feasible->area), 2442.207378, 1e-5);
    const RotaryRange& phi = found.feasible->phi;
    EXPECT_NEAR(phi.to, 29.95 * degree, 1e-9);
    EXPECT_NEAR((phi.to - phi.from) / degree, 47.684975, 1e-6);
    EXPECT_NEAR((found.feasible->theta.to - found.feasible->theta.from) / degree,
                51.215449, 1e-6);
}

// Random limits, with and without directions beyond 90 degrees. The rectangle found fits,
// and no fitting rectangle of a search in steps of 0.01 degrees is better.
TEST(RectangleFit, IsTheLeastThatFitsIfCorrected)
{
    test::Random random{33};
    int decided_by_limits = 0;
    for (int i = 0; i < 200; ++i) {
        std::vector<Vec3> points = test::random_directions(random);
        points.resize(std::min<std::size_t>(points.size(), 6));
        if (i % 4 == 0)
            points.push_back(direction({random.uniform(0, 360), 110}));
        const PoseSearchResult free =
            rectangle_fit(up, points, options(SetupMode::Corrected));
        const auto near = [&](double angle) {
            return angle + random.uniform(-0.05, 0.3);
        };
        const RotaryLimits limits{
            {-std::max(0.0, near(-free.least->phi.from)), near(free.least->phi.to)},
            {-std::max(0.0, near(-free.least->theta.from)),
             std::max(0.0, near(free.least->theta.to))}};
        const PoseSearchResult found =
            rectangle_fit(up, points, options(SetupMode::Corrected, limits));
        if (found.feasible) {
            decided_by_limits += found.feasible->area > free.least->area * (1 + 1e-6);
            const RectangleCandidate measured{
                {}, found.feasible->phi, found.feasible->theta, RectangleOrigin::Search};
            EXPECT_TRUE(fits_rigidly(measured, limits));
        }
        double searched = 1e9;
        for (double azimuth = 0; azimuth < 180; azimuth += 0.05) {
            const auto tried = rectangle_about(up, direction({azimuth, 90}), points);
            if (fits_rigidly(tried, limits))
                searched = std::min(searched, tried.area());
        }
        if (searched < 1e9) {
            ASSERT_TRUE(found.feasible);
            EXPECT_LE(found.feasible->area, searched * (1 + 2e-7));
        }
    }
    EXPECT_GT(decided_by_limits, 10);
}

TEST(RectangleFit, IsTheSameForATurnedPart)
{
    test::Random random{34};
    for (int i = 0; i < 50; ++i) {
        const std::vector<Vec3> points = test::random_directions(random);
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd{random.uniform(0, 6),
                              direction({random.uniform(0, 360), random.uniform(0, 180)})}
                .toRotationMatrix();
        std::vector<Vec3> moved;
        moved.reserve(points.size());
        for (const Vec3& v : points)
            moved.push_back(turn * v);
        for (const SetupMode mode : all_modes) {
            const auto here = rectangle_fit(up, points, options(mode));
            const auto there =
                rectangle_fit((turn * up).normalized(), moved, options(mode));
            EXPECT_NEAR(there.least->area, here.least->area, 1e-9);
            EXPECT_NEAR(there.least->phi.to, here.least->phi.to, 1e-6);
            EXPECT_NEAR((turn * here.least->pose.r1_axis).dot(there.least->pose.r1_axis),
                        1, 1e-9);
        }
    }
}

TEST(RectangleFit, BoundsItsResultWithLessWork)
{
    const auto points = directions({{0, 30}, {120, 95}, {240, 20}});
    const PoseFitOptions asked = options(SetupMode::Corrected);
    const AreaBounds bounds = rectangle_bounds(up, points, asked);
    const double area = rectangle_fit(up, points, asked).least->area;
    EXPECT_GE(bounds.least, area);
    EXPECT_LE(bounds.least, 1.2 * area);
    EXPECT_TRUE(rectangle_fit(up, points, asked, bounds).least);
    EXPECT_FALSE(rectangle_fit(up, points, asked, {0.9 * area, 0.9 * area}).least);
    EXPECT_TRUE(std::isinf(rectangle_bounds(up, test::ring(5, 20), asked).least));
}

TEST(RectangleFit, NeedsItsFamilyAndValidLimits)
{
    EXPECT_THROW(rectangle_fit(up, {}, {RotaryFamily::CA, SetupMode::Paper, {}}),
                 DomainError);
    EXPECT_THROW(rectangle_fit(up, {}, options(SetupMode::Paper, {degrees(1, 2), {}})),
                 DomainError);
}

}  // namespace
}  // namespace endmill
