// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/offset/section_curve.h"
#include "random.h"

namespace endmill {
namespace {

using Points = std::vector<SectionPoint>;

double distance(const SectionPoint& point, const SectionPoint& a, const SectionPoint& b)
{
    const SectionPoint along = b - a;
    const double length2 = along.squaredNorm();
    const double share =
        length2 > 0 ? std::clamp((point - a).dot(along) / length2, 0.0, 1.0) : 0;
    return (point - a - share * along).norm();
}

double distance(const SectionPoint& point, const Points& line)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
        least = std::min(least, distance(point, line[k], line[k + 1]));
    return least;
}

// The greatest distance of points of `of`, taken at many places of every segment, from `to`.
double greatest_distance(const Points& of, const Points& to)
{
    double greatest = 0;
    for (std::size_t k = 0; k + 1 < of.size(); ++k)
        for (double share = 0; share <= 1; share += 0.125)
            greatest =
                std::max(greatest, distance(of[k] + share * (of[k + 1] - of[k]), to));
    return greatest;
}

Points thin_points(const Points& points, double tolerance)
{
    Points left;
    for (const std::size_t number : thinned(points, tolerance))
        left.push_back(points[number]);
    return left;
}

TEST(Thinning, KeepsTheEndsAndCornersOfStraightRuns)
{
    Points points;
    for (int k = 0; k <= 100; ++k)
        points.emplace_back(0.1 * k, 2 + 0.05 * k);
    for (int k = 1; k <= 100; ++k)
        points.emplace_back(10 + 0.1 * k, 7 - 0.05 * k);
    EXPECT_EQ(thinned(points, 1e-6), (std::vector<std::size_t>{0, 100, 200}));
}

TEST(Thinning, KeepsEveryPointWithoutATolerance)
{
    const Points points{{0, 0}, {1, 0}, {2, 0}};
    EXPECT_EQ(thinned(points, 0), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(thinned(Points{}, 1), std::vector<std::size_t>{});
    EXPECT_EQ(thinned(Points{{1, 2}}, 1), std::vector<std::size_t>{0});
    EXPECT_EQ(thinned(Points{{1, 2}, {1, 2}}, 1), (std::vector<std::size_t>{0, 1}));
    EXPECT_THROW(thinned(points, -1), DomainError);
    EXPECT_THROW(thinned(points, std::numeric_limits<double>::infinity()), DomainError);
}

// Both polylines lie within the tolerance of each other. The distances are measured densely,
// without the cone.
TEST(Thinning, StaysWithinTheToleranceOnBothSides)
{
    test::Random random{7};
    for (int trial = 0; trial < 200; ++trial) {
        const double tolerance = random.log_uniform(1e-4, 0.3);
        Points points;
        double s = 0;
        double z = 0;
        const double roughness = random.log_uniform(1e-3, 1);
        for (int k = 0; k < 120; ++k) {
            points.emplace_back(s, z);
            s += random.uniform(0, 0.3) - (trial % 4 == 0 ? 0.1 : 0);
            z += roughness * random.uniform(-1, 1) + 0.1 * std::sin(0.1 * k);
        }
        const Points thin = thin_points(points, tolerance);
        EXPECT_EQ(thin.front(), points.front());
        EXPECT_EQ(thin.back(), points.back());
        EXPECT_LE(greatest_distance(points, thin), tolerance);
        EXPECT_LE(greatest_distance(thin, points), tolerance);
    }
}

// A chord of a circle of radius R departs from its arc by t if it spans 2 acos(1 - t / R).
// Greedy chords between samples cannot be longer than with a band on both sides, 2 t.
TEST(Thinning, TakesAboutAsFewChordsOfACircleAsPossible)
{
    const double radius = 20;
    const double tolerance = 1e-3;
    Points points;
    for (int k = 0; k <= 20000; ++k) {
        const double angle = std::acos(-1.0) * k / 20000;
        points.emplace_back(-radius * std::cos(angle), radius * std::sin(angle));
    }
    const double fewest = std::acos(-1.0) / (2 * std::acos(1 - tolerance / radius));
    const auto chords = static_cast<double>(thinned(points, tolerance).size()) - 1;
    EXPECT_GE(chords, fewest - 1);
    EXPECT_LE(chords, 1.05 * fewest + 1);
}

TEST(Thinning, KeepsTheTipOfASpike)
{
    // There and back on one line: the distance from the beginning falls behind the tip.
    const Points points{{0, 0}, {1e-9, 5}, {2e-9, 10}, {3e-9, 5}, {4e-9, 0}};
    EXPECT_EQ(thinned(points, 0.01), (std::vector<std::size_t>{0, 2, 4}));
}

}  // namespace
}  // namespace endmill
