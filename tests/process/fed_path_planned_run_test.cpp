// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/fed_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

using test::relative_error;
using Points = std::vector<Vec3>;

// docs/methods/ball-end-milling.md, section 11.
constexpr FeedAcceleration motion{.acceleration_mm_per_s2 = 1000,
                                  .corner_tolerance_mm = 0.01};

Points line(const std::vector<double>& at)
{
    Points points;
    for (const double x : at)
        points.emplace_back(x, 0, 0);
    return points;
}

double time(const Points& points, double feed)
{
    const std::vector<double> feeds(points.size() - 1, feed);
    return planned_run(points, feeds, motion).time_s;
}

TEST(PlannedFeed, FromRestToRestIsARampUpAndARampDown)
{
    EXPECT_NEAR(time(line({0, 10}), 100), 0.2, 1e-15);
    EXPECT_NEAR(time(line({0, 30}), 100), 0.4, 1e-15);
    EXPECT_NEAR(time(line({0, 2.5}), 100), 0.1, 1e-15);
    for (const double length : {0.001, 1.0, 9.9, 10.1, 500.0})
        EXPECT_NEAR(time(line({0, length}), 100),
                    length >= 10 ? length / 100 + 0.1 : 2 * std::sqrt(length / 1000),
                    1e-13);
}

TEST(PlannedFeed, OfALineDoesNotDependOnItsPieces)
{
    test::Random random{1};
    for (const double length : {2.5, 10.0, 30.0}) {
        std::vector<double> at{0, length};
        for (int k = 0; k < 40; ++k)
            at.push_back(random.uniform(0.001, length - 0.001));
        std::ranges::sort(at);
        EXPECT_NEAR(time(line(at), 100), time(line({0, length}), 100), 1e-13);
    }
}

TEST(PlannedFeed, RoundsARightAngleWithinTheTolerance)
{
    const Points points{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}};
    EXPECT_NEAR(corner_speed({10, 0, 0}, {0, 10, 0}, motion), 4.913464727, 1e-9);
    EXPECT_NEAR(time(points, 100), 0.390414492, 1e-9);
    // The circle that touches both moves and passes 0.01 mm from the corner.
    const double speed = corner_speed({10, 0, 0}, {0, 0, 10}, motion);
    const double radius = speed * speed / 1000;
    EXPECT_NEAR(std::sqrt(2) * radius - radius, 0.01, 1e-15);
}

TEST(PlannedFeed, RestsAtAReversal)
{
    EXPECT_EQ(corner_speed({1, 2, 3}, {-1, -2, -3}, motion), 0);
    EXPECT_NEAR(time(line({0, 10, 0}), 100), 0.4, 1e-14);
    EXPECT_TRUE(std::isinf(corner_speed({1, 2, 3}, {2, 4, 6}, motion)));
}

TEST(PlannedFeed, SlowsDownBeforeASlowerMove)
{
    const std::vector<double> feeds{100, 50};
    EXPECT_NEAR(planned_run(line({0, 10, 20}), feeds, motion).time_s, 0.3875, 1e-14);
    const std::vector<double> reversed{50, 100};
    EXPECT_NEAR(planned_run(line({0, 10, 20}), reversed, motion).time_s, 0.3875, 1e-14);
}

TEST(PlannedFeed, FollowsAPolygonAsTheCircleInIt)
{
    const double radius = 20;
    for (const int corners : {200, 1000}) {
        const double turn = 2 * std::numbers::pi / corners;
        const Vec3 before{std::cos(turn / 2), -std::sin(turn / 2), 0};
        const Vec3 after{std::cos(turn / 2), std::sin(turn / 2), 0};
        const double side = 2 * radius * std::sin(turn / 2);
        EXPECT_LT(relative_error(corner_speed(side * before, side * after, motion),
                                 std::sqrt(1000 * radius * std::cos(turn / 2))),
                  1e-12);
    }
}

// A random polyline with feeds of its segments.
struct Course {
    Points points;
    std::vector<double> feeds;
};

Course random_course(test::Random& random, int segments)
{
    Course course{{Vec3::Zero()}, {}};
    Vec3 heading{1, 0, 0};
    for (int k = 0; k < segments; ++k) {
        const double spread = random.log_uniform(0.01, 1);
        for (int c = 0; c < 3; ++c)
            heading[c] += spread * random.uniform(-1, 1);
        heading.normalize();
        course.points.push_back(course.points.back() +
                                random.log_uniform(0.01, 5) * heading);
        course.feeds.push_back(random.log_uniform(2, 150));
    }
    return course;
}

// The largest admissible speed at every vertex by its definition: from every bound on the
// path, the speed that acceleration can reach up to the vertex.
std::vector<double> speeds_by_definition(const Course& course)
{
    const std::size_t count = course.feeds.size();
    std::vector<double> at(count + 1, 0);
    std::vector<double> caps(count + 1, 0);
    for (std::size_t j = 0; j < count; ++j)
        at[j + 1] = at[j] + (course.points[j + 1] - course.points[j]).norm();
    for (std::size_t j = 1; j < count; ++j)
        caps[j] =
            std::min({course.feeds[j - 1], course.feeds[j],
                      corner_speed(course.points[j] - course.points[j - 1],
                                   course.points[j + 1] - course.points[j], motion)});
    std::vector<double> speeds(count + 1);
    for (std::size_t j = 0; j <= count; ++j) {
        double square = caps[j] * caps[j];
        for (std::size_t k = 0; k <= count; ++k)
            square =
                std::min(square, caps[k] * caps[k] + 2 * motion.acceleration_mm_per_s2 *
                                                         std::abs(at[j] - at[k]));
        speeds[j] = std::sqrt(square);
    }
    return speeds;
}

// Time of a segment by integration of dx/v over the fastest speed profile between its
// ends.
double time_by_quadrature(double length, double from, double to, double feed)
{
    const double a = motion.acceleration_mm_per_s2;
    constexpr int steps = 20000;
    double sum = 0;
    for (int k = 0; k < steps; ++k) {
        // The substitution is dense at both ends, where 1/v may be infinite.
        const double u = (k + 0.5) / steps;
        const double x = length * u * u * (3 - 2 * u);
        const double width = length * 6 * u * (1 - u) / steps;
        sum += width / std::min({feed, std::sqrt(from * from + 2 * a * x),
                                 std::sqrt(to * to + 2 * a * (length - x))});
    }
    return sum;
}

TEST(PlannedFeed, IsTheFastestByDefinition)
{
    test::Random random{17};
    for (int i = 0; i < 40; ++i) {
        const Course course = random_course(random, 60);
        const PlannedRun run = planned_run(course.points, course.feeds, motion);
        const std::vector<double> expected = speeds_by_definition(course);
        for (std::size_t j = 0; j < expected.size(); ++j)
            EXPECT_NEAR(run.vertex_speeds[j], expected[j], 1e-9);
        EXPECT_NEAR(
            run.time_s,
            std::accumulate(run.segment_times.begin(), run.segment_times.end(), 0.0),
            1e-12);
    }
}

TEST(PlannedFeed, TakesTheTimeOfItsSpeedProfile)
{
    test::Random random{23};
    const Course course = random_course(random, 30);
    const PlannedRun run = planned_run(course.points, course.feeds, motion);
    for (std::size_t j = 0; j < course.feeds.size(); ++j) {
        const double length = (course.points[j + 1] - course.points[j]).norm();
        EXPECT_LT(
            relative_error(time_by_quadrature(length, run.vertex_speeds[j],
                                              run.vertex_speeds[j + 1], course.feeds[j]),
                           run.segment_times[j]),
            1e-6);
    }
}

TEST(PlannedFeed, KeepsItsBoundsAndIsNoFasterThanTheFeeds)
{
    test::Random random{29};
    for (int i = 0; i < 20; ++i) {
        const Course course = random_course(random, 200);
        const PlannedRun run = planned_run(course.points, course.feeds, motion);
        EXPECT_EQ(run.vertex_speeds.front(), 0);
        EXPECT_EQ(run.vertex_speeds.back(), 0);
        for (std::size_t j = 0; j < course.feeds.size(); ++j) {
            const double length = (course.points[j + 1] - course.points[j]).norm();
            const double v0 = run.vertex_speeds[j];
            const double v1 = run.vertex_speeds[j + 1];
            EXPECT_LE(std::max(v0, v1), course.feeds[j]);
            EXPECT_LE(std::abs(v1 * v1 - v0 * v0), 2000 * length * (1 + 1e-12));
            EXPECT_GE(run.segment_times[j], length / course.feeds[j] * (1 - 1e-14));
        }
    }
}

// The reversed path takes the same time.
TEST(PlannedFeed, IsTheSameBackwards)
{
    test::Random random{31};
    Course course = random_course(random, 100);
    const double forth = planned_run(course.points, course.feeds, motion).time_s;
    std::ranges::reverse(course.points);
    std::ranges::reverse(course.feeds);
    EXPECT_LT(
        relative_error(planned_run(course.points, course.feeds, motion).time_s, forth),
        1e-13);
}

TEST(PlannedFeed, RefusesDegeneratePaths)
{
    const std::vector<double> feed{100};
    const auto refused = [](const Points& points, const std::vector<double>& feeds) {
        EXPECT_THROW(planned_run(points, feeds, motion), DomainError);
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    refused({}, {});
    refused(line({0}), {});
    refused(line({0, 1}), {});
    refused(line({0, 1}), {1, 2});
    refused(line({1, 1}), feed);
    refused(line({0, nan}), feed);
    refused(line({0, 1}), {0});
    refused(line({0, 1}), {-1});
    refused(line({0, 1}), {nan});
    for (const double wrong : {0.0, -1.0, nan}) {
        EXPECT_THROW(planned_run(line({0, 1}), feed, {wrong, 0.01}), DomainError);
        EXPECT_THROW(planned_run(line({0, 1}), feed, {1000, wrong}), DomainError);
        EXPECT_THROW(corner_speed({1, 0, 0}, {1, 0, 0}, {wrong, 0.01}), DomainError);
    }
    EXPECT_THROW(corner_speed(Vec3::Zero(), {1, 0, 0}, motion), DomainError);
}

// A path of points on the x axis.
ToolPath path_of(const std::vector<double>& at, const std::vector<Move>& moves,
                 const std::vector<std::optional<double>>& feeds_mm_per_min)
{
    ToolPath path;
    for (std::size_t i = 0; i < at.size(); ++i) {
        path.points.push_back({.pass = 0,
                               .point = static_cast<int>(i),
                               .move = moves[i],
                               .location = {{at[i], 0, 0}, Vec3::UnitZ()},
                               .conditions = {feeds_mm_per_min[i]}});
    }
    return path;
}

TEST(PlannedTimes, RestAtEveryRapid)
{
    using enum Move;
    const ToolPath path =
        path_of({0, 5, 10, 10, 40, 45, 50}, {Plunge, Cut, Cut, Cut, Rapid, Cut, Link},
                {{}, 6000, 6000, 6000, {}, 6000, 6000});
    const std::vector<double> times = planned_times(path, motion);
    ASSERT_EQ(times.size(), 7U);
    EXPECT_NEAR(times[1] + times[2], 0.2, 1e-14);
    EXPECT_NEAR(times[5] + times[6], 0.2, 1e-14);
    for (const std::size_t still : {0, 3, 4})
        EXPECT_EQ(times[still], 0);
}

TEST(PlannedTimes, NeedAFeedForEachCut)
{
    using enum Move;
    EXPECT_THROW(planned_times(path_of({0, 1}, {Plunge, Cut}, {{}, {}}), motion),
                 DomainError);
    EXPECT_EQ(planned_times(path_of({0, 1}, {Plunge, Retract}, {{}, {}}), motion),
              (std::vector<double>{0, 0}));
    EXPECT_TRUE(planned_times({}, motion).empty());
}

}  // namespace
}  // namespace endmill
