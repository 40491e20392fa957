// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/sector_fit.h"

#include <algorithm>
#include <numbers>
#include <string>

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
using test::up;

PoseFitOptions options(SetupMode mode, const RotaryLimits& limits = {})
{
    return {RotaryFamily::CA, mode, limits};
}

double width_of(const FittedPose& fit)
{
    return (fit.theta.to - fit.theta.from) / degree;
}

double least_area(const std::vector<Vec3>& points, SetupMode mode)
{
    return square_degrees(sector_fit(up, points, options(mode)).least->area);
}

bool has_candidate(const std::vector<SectorCandidate>& found, double width, double larger,
                   double smaller)
{
    return std::any_of(found.begin(), found.end(), [&](const SectorCandidate& sector) {
        return std::abs(sector.width / degree - width) < 1e-7 &&
               std::abs(std::max(sector.polar, sector.opposite_polar) / degree - larger) <
                   1e-7 &&
               std::abs(std::min(sector.polar, sector.opposite_polar) / degree -
                        smaller) < 1e-7;
    });
}

// Tests whether a C,A machine in this pose reaches the direction v within these ranges,
// by one of the two solutions: (polar, azimuth from r2 x C) and (-polar, azimuth + 180
// degrees).
bool reaches(const FittedPose& fit, const Vec3& v)
{
    constexpr double slack = 1e-8;
    const Vec3& pole = fit.pose.tool_axis;
    const Vec3 zero = fit.pose.r2_axis.cross(pole);
    const double polar = std::acos(std::clamp(v.dot(pole), -1.0, 1.0));
    const double azimuth = std::atan2(v.dot(pole.cross(zero)), v.dot(zero));
    const auto holds = [&](const RotaryRange& range, double angle) {
        return range.from - slack <= angle && angle <= range.to + slack;
    };
    for (int turn = -2; turn <= 2; ++turn) {
        const double theta = azimuth + turn * std::numbers::pi;
        if (holds(fit.theta, theta) && holds(fit.phi, turn % 2 == 0 ? polar : -polar))
            return true;
    }
    return polar < slack;
}

TEST(SectorFit, TriesTheSectorsOfThePaper)
{
    const auto three = sector_candidates(up, directions({{0, 30}, {100, 40}, {200, 50}}),
                                         SetupMode::Paper);
    EXPECT_EQ(three.size(), 3U);
    EXPECT_TRUE(has_candidate(three, 160, 50, 40));
    EXPECT_TRUE(has_candidate(three, 100, 50, 40));
    EXPECT_TRUE(has_candidate(three, 100, 50, 30));
    const auto two =
        sector_candidates(up, directions({{10, 20}, {100, 35}}), SetupMode::Paper);
    EXPECT_TRUE(has_candidate(two, 90, 35, 0));
    EXPECT_TRUE(has_candidate(two, 90, 35, 20));
    const auto around = sector_candidates(up, directions({{350, 30}, {10, 20}, {30, 25}}),
                                          SetupMode::Paper);
    EXPECT_TRUE(has_candidate(around, 40, 30, 0));
}

TEST(SectorFit, FindsTheLeastOfThem)
{
    for (const SetupMode mode :
         {SetupMode::PaperLiteral, SetupMode::Paper, SetupMode::Corrected}) {
        EXPECT_NEAR(least_area(directions({{0, 30}, {100, 40}, {200, 50}}), mode), 8000,
                    1e-6);
        EXPECT_NEAR(least_area(directions({{10, 20}, {100, 35}}), mode), 3150, 1e-6);
        EXPECT_NEAR(least_area(directions({{350, 30}, {10, 20}, {30, 25}}), mode), 1200,
                    1e-6);
        EXPECT_NEAR(least_area(test::ring(4, 10), mode), 1800, 1e-6);
    }
}

TEST(SectorFit, IsAnArcForOneDirectionOrTwoOpposite)
{
    const PoseSearchResult one =
        sector_fit(up, directions({{77, 25}}), options(SetupMode::Paper));
    EXPECT_EQ(one.status, SetupStatus::FourAxis);
    EXPECT_EQ(one.least->area, 0);
    expect_range(one.least->phi, 0, 25);
    EXPECT_NEAR(one.least->pose.r2_axis.cross(up).dot(direction({77, 90})), 1, 1e-15);

    const PoseSearchResult two =
        sector_fit(up, directions({{10, 20}, {190, 35}}), options(SetupMode::Corrected));
    EXPECT_EQ(two.status, SetupStatus::FourAxis);
    EXPECT_EQ(two.least->area, 0);
    expect_range(two.least->phi, -20, 35);
    expect_range(two.least->theta, 0, 0);
}

TEST(SectorFit, NeedsNoRangeWithoutDirections)
{
    for (const std::vector<Vec3>& points :
         {std::vector<Vec3>{}, std::vector<Vec3>{up, up}}) {
        const PoseSearchResult found =
            sector_fit(up, points, options(SetupMode::Corrected));
        EXPECT_EQ(found.status, SetupStatus::ThreeAxis);
        EXPECT_EQ(found.feasible->area, 0);
    }
}

class SectorOfARing : public testing::TestWithParam<int> {};

TEST_P(SectorOfARing, HasTheWidthOfTheClosedForm)
{
    const int count = GetParam();
    for (const double polar : {15.0, 20.0, 75.0, 120.0}) {
        const PoseSearchResult found =
            sector_fit(up, test::ring(count, polar), options(SetupMode::Corrected));
        const double width = 180 - (count % 2 == 0 ? 360.0 : 180.0) / count;
        EXPECT_NEAR(square_degrees(found.least->area), 2 * polar * width, 1e-6);
        // Odd rings tie with one wide sector. Its ranges have the larger sum, except
        // close to the pole.
        if (count % 2 == 0 || polar <= width) {
            EXPECT_NEAR(width_of(*found.least), width, 1e-7);
        } else {
            EXPECT_NEAR(width_of(*found.least), 2 * width, 1e-7);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EvenAndOdd, SectorOfARing,
                         testing::Values(3, 4, 5, 6, 7, 12, 13));

TEST(SectorFit, FindsTheFeasibleAndTheLeastSeparately)
{
    const auto points = directions({{0, 60}, {20, 20}, {170, 25}});
    for (const SetupMode mode : {SetupMode::Paper, SetupMode::Corrected}) {
        const auto tried = sector_candidates(up, points, mode);
        EXPECT_TRUE(has_candidate(tried, 30, 60, 25));
        EXPECT_TRUE(has_candidate(tried, 160, 60, 25));
        EXPECT_TRUE(has_candidate(tried, 170, 60, 0));
        const PoseSearchResult found =
            sector_fit(up, points, options(mode, {degrees(-5, 65), {}}));
        EXPECT_NEAR(square_degrees(found.least->area), 2550, 1e-6);
        ASSERT_TRUE(found.feasible);
        EXPECT_NEAR(square_degrees(found.feasible->area), 10200, 1e-6);
        expect_range(found.feasible->phi, 0, 60);
        expect_range(found.feasible->theta, -85, 85);
    }
}

TEST(SectorFit, TurnsByMoreThanHalfOnlyIfCorrected)
{
    const RotaryLimits limits{degrees(0, 30), {}};
    const std::vector<Vec3> points = test::ring(3, 20);
    EXPECT_FALSE(sector_fit(up, points, options(SetupMode::Paper, limits)).feasible);
    const PoseSearchResult found =
        sector_fit(up, points, options(SetupMode::Corrected, limits));
    ASSERT_TRUE(found.feasible);
    EXPECT_NEAR(square_degrees(found.feasible->area), 4800, 1e-6);
    EXPECT_NEAR(width_of(*found.feasible), 240, 1e-7);
    expect_range(found.feasible->phi, 0, 20);
}

TEST(SectorFit, DividesTheAzimuthsInTheRatioOfTheLimits)
{
    const auto points = directions({{0, 30}, {90, 40}});
    const PoseSearchResult found = sector_fit(
        up, points, options(SetupMode::Paper, {degrees(-50, 50), degrees(-30, 150)}));
    expect_range(found.feasible->phi, 0, 40);
    expect_range(found.feasible->theta, -15, 75);
    const PoseSearchResult tilted_back = sector_fit(
        up, points, options(SetupMode::Paper, {degrees(-50, 5), degrees(0, 180)}));
    expect_range(tilted_back.feasible->phi, -40, 0);
    expect_range(tilted_back.feasible->theta, 0, 90);
    EXPECT_FALSE(sector_fit(up, points,
                            options(SetupMode::Paper, {degrees(-50, 5), degrees(0, 89)}))
                     .feasible);
    EXPECT_FALSE(sector_fit(up, points, options(SetupMode::Paper, {degrees(-39, 39), {}}))
                     .feasible);
}

// By the kinematics of the machine, the ranges reach every direction, for every mode,
// tool axis and limits.
TEST(SectorFit, ReachesAllDirections)
{
    test::Random random{21};
    for (int i = 0; i < 300; ++i) {
        const Vec3 axis = direction({random.uniform(0, 360), random.uniform(0, 180)});
        std::vector<Vec3> points(static_cast<std::size_t>(2 + i % 12));
        for (Vec3& v : points)
            v = direction({random.uniform(0, 360), random.uniform(0, 180)});
        const RotaryLimits limits{
            degrees(-random.uniform(0, 180), random.uniform(60, 180)),
            degrees(-random.uniform(0, 180), random.uniform(90, 180))};
        for (const SetupMode mode : {SetupMode::Paper, SetupMode::Corrected}) {
            const PoseSearchResult found =
                sector_fit(axis, points, options(mode, limits));
            for (const auto& fit : {found.least, found.feasible}) {
                if (!fit)
                    continue;
                for (const Vec3& v : points)
                    EXPECT_TRUE(reaches(*fit, v));
            }
            if (found.feasible) {
                EXPECT_GE(found.feasible->phi.from, limits.phi.from - 1e-9);
                EXPECT_LE(found.feasible->phi.to, limits.phi.to + 1e-9);
                EXPECT_GE(found.feasible->theta.from, limits.theta.from - 1e-9);
                EXPECT_LE(found.feasible->theta.to, limits.theta.to + 1e-9);
            }
        }
    }
}

// A search over all windows whose begin and width are multiples of half a degree.
double searched_area(const std::vector<test::AzimuthPolar>& points)
{
    double best = 1e9;
    for (int from = 0; from < 720; ++from) {
        for (int width = 0; width < 720; ++width) {
            double inside = 0;
            double outside = 0;
            bool is_covered = true;
            for (const test::AzimuthPolar& v : points) {
                const double on = std::fmod(v.azimuth - from / 2.0 + 720, 360);
                const bool is_opposite = std::fmod(on + 180, 360) <= width / 2.0;
                is_covered = is_covered && (on <= width / 2.0 || is_opposite);
                (on <= width / 2.0 ? inside : outside) =
                    std::max(on <= width / 2.0 ? inside : outside, v.polar);
            }
            if (is_covered)
                best = std::min(best, (inside + outside) * width / 2.0);
        }
    }
    return best;
}

TEST(SectorFit, IsTheLeastOfAllSectorsIfCorrected)
{
    test::Random random{22};
    for (int i = 0; i < 12; ++i) {
        std::vector<test::AzimuthPolar> points;
        for (int k = 0; k < 3 + i % 4; ++k) {
            const double azimuth = std::floor(random.uniform(0, 720)) / 2;
            points.push_back({azimuth, random.uniform(5, 150)});
        }
        EXPECT_NEAR(least_area(directions(points), SetupMode::Corrected),
                    searched_area(points), 1e-6);
    }
}

// Two directions on opposite sides are the ends of one sector of half a turn.
TEST(SectorFit, IsOneSectorOfHalfATurnIfThatIsLess)
{
    const auto points =
        directions({{0, 50}, {40, 60}, {80, 70}, {120, 60}, {160, 70}, {180, 50}});
    EXPECT_GT(least_area(points, SetupMode::Paper), 180 * 70 + 1);
    EXPECT_NEAR(least_area(points, SetupMode::Corrected), 180 * 70, 1e-6);
}

TEST(SectorFit, GivesADirectionOppositeToThePoleToTheLargerSector)
{
    auto points = directions({{0, 30}, {180, 40}});
    points.push_back(-up);
    const PoseSearchResult found = sector_fit(up, points, options(SetupMode::Corrected));
    expect_range(found.least->phi, -30, 180);
    EXPECT_EQ(found.least->area, 0);
}

TEST(SectorFit, MaySkipFitsBeyondItsBounds)
{
    const auto points = directions({{0, 30}, {100, 40}, {200, 50}});
    const double area = 8000 * degree * degree;
    const AreaBounds below{area * 0.999, area * 1.001};
    const PoseSearchResult found =
        sector_fit(up, points, options(SetupMode::Corrected), below);
    EXPECT_FALSE(found.least);
    EXPECT_TRUE(found.feasible);
}

TEST(SectorFit, NeedsItsFamilyAndValidLimits)
{
    EXPECT_THROW(sector_fit(up, {}, {RotaryFamily::AB, SetupMode::Paper, {}}),
                 DomainError);
    EXPECT_THROW(sector_fit(up, {}, options(SetupMode::Paper, {degrees(10, 20), {}})),
                 DomainError);
}

}  // namespace
}  // namespace endmill
