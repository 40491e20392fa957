// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/section_runs.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

// The points (i, z_i).
std::vector<SectionPoint> heights(std::initializer_list<double> z)
{
    std::vector<SectionPoint> points;
    for (const double height : z)
        points.emplace_back(static_cast<double>(points.size()), height);
    return points;
}

struct Expected {
    int first;
    int last;
    bool grows;
    friend bool operator==(const Expected&, const Expected&) = default;
};

std::vector<Expected> runs_of(const SectionChain& chain, RunAxis axis, double band,
                              int from = 0)
{
    std::vector<Expected> runs;
    RunReader reader{chain, axis, band, from};
    while (const auto run = reader.next())
        runs.push_back({run->first, run->last, run->grows});
    EXPECT_FALSE(reader.next());
    return runs;
}

std::vector<Expected> runs_of_heights(std::initializer_list<double> z)
{
    const auto points = heights(z);
    const SectionChain chain{points, 0};
    return runs_of(chain, RunAxis::Z, dead_band(points));
}

TEST(RunReader, DistinguishesRisingFromFalling)
{
    EXPECT_EQ(runs_of_heights({0, 1, 2, 1, 0, 5}),
              (std::vector<Expected>{{0, 2, true}, {2, 4, false}, {4, 5, true}}));
}

TEST(RunReader, JoinsLevelSegmentsToTheRunBefore)
{
    EXPECT_EQ(runs_of_heights({0, 0, 1, 1, 1 + 1e-12, 0, 0}),
              (std::vector<Expected>{{1, 4, true}, {4, 6, false}}));
    EXPECT_TRUE(runs_of_heights({3, 3, 3}).empty());
}

TEST(RunReader, GoesOnAtACrossing)
{
    const auto points = heights({4, 0, 1, 0, 4, 3, 5});
    SectionChain chain{points, 0};
    const std::int32_t at = chain.join(0, 4, {0, 3, {2, 2}}, "P4");
    EXPECT_EQ(runs_of(chain, RunAxis::Z, 0, at),
              (std::vector<Expected>{{at, 4, true}, {4, 5, false}, {5, 6, true}}));
}

// Compares with the definition of runs, segment by segment.
TEST(RunReader, AlternatesOnRandomChains)
{
    test::Random random{3};
    for (int k = 0; k < 200; ++k) {
        std::vector<SectionPoint> points;
        for (int i = 0; i < 30; ++i)
            points.emplace_back(std::floor(random.uniform(-2, 3)), i);
        const SectionChain chain{points, 0};
        int last = -1;
        bool grew = false;
        for (const Expected& run : runs_of(chain, RunAxis::S, dead_band(points))) {
            EXPECT_TRUE(last < 0 || (run.first == last && run.grows != grew));
            for (int i = run.first; i < run.last; ++i) {
                const double change = points[i + 1].x() - points[i].x();
                EXPECT_TRUE(run.grows ? change >= 0 : change <= 0);
            }
            last = run.last;
            grew = run.grows;
        }
    }
}

TEST(BackwardRuns, AreCountedInTheTrimmedCurves)
{
    const auto count = [](const std::vector<double>& s) {
        std::vector<TrimmedPoint> points;
        for (const double at : s)
            points.push_back({{at, 0}, {0, 0}, {0, 0}, TrimmedKind::Vertex});
        return backward_runs(points, 1e-3);
    };
    EXPECT_EQ(count({}), 0);
    EXPECT_EQ(count({0, 1, 1, 2}), 0);
    EXPECT_EQ(count({0, 2, 1.5, 1, 3, 2}), 2);
    EXPECT_EQ(count({2, 1}), 1);
    EXPECT_EQ(count({0, 2, 1, 1.0005, 0.5, 3}), 1);  // within the dead band
    EXPECT_EQ(count({0, 2, 1.9995, 3}), 0);
}

TEST(DeadBand, IsAShareOfTheLargerExtent)
{
    EXPECT_DOUBLE_EQ(dead_band(heights({0, 8})), 8e-10);
    EXPECT_DOUBLE_EQ(dead_band(heights({0, 1, 2, 1, 0, 1, 1})), 6e-10);
}

TEST(DeadBand, RefusesNonFiniteCoordinates)
{
    EXPECT_THROW(dead_band({}), DomainError);
    EXPECT_THROW(dead_band(heights({1})), DomainError);
    for (int bad = 0; bad < 9; ++bad) {
        auto points = heights({0, 1, 2, 1, 0, 1, 1, 3, 2});
        points[bad].y() = std::numeric_limits<double>::quiet_NaN();
        EXPECT_THROW(dead_band(points), DomainError);
        points[bad].y() = std::numeric_limits<double>::infinity();
        EXPECT_THROW(dead_band(points), DomainError);
    }
}

}  // namespace
}  // namespace endmill
