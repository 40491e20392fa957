// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/azimuth_window.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr double turn = 2 * std::numbers::pi;

/// A map of random bits: each cell belongs to random cones.
VisibilityMap random_map(std::size_t facets, std::size_t cells, std::mt19937& random)
{
    VisibilityMap map{facets, cells};
    std::bernoulli_distribution is_open{0.15};
    for (std::size_t cell = 0; cell < cells; ++cell)
        for (std::size_t facet = 0; facet < facets; ++facet)
            if (is_open(random))
                map.column(cell)[facet / 64] |= std::uint64_t{1} << facet % 64;
    return map;
}

/// The least window that begins at the end of an interval and meets an interval of every
/// cone, or infinity.
double naive_width(const ConeSet& cones, const AxisView& view, const LevelLimits& limits)
{
    const MissingWords<0> words{cones.words()};
    double best = 100;
    for (const SeenCell& first : view.swept) {
        if (first.level > limits.upto[first.side])
            continue;
        std::vector<std::pair<double, std::uint32_t>>
            after;  // begins of intervals, from the window's begin on
        for (const SeenCell& cell : view.swept) {
            if (cell.level > limits.upto[cell.side])
                continue;
            double begin = std::fmod(cell.begin - first.end + 2 * turn, turn);
            if (begin + (cell.end - cell.begin) >= turn - 1e-13)
                begin = 0;  // the window begins in this interval
            after.emplace_back(begin, cell.cell);
        }
        std::sort(after.begin(), after.end());
        std::vector<std::uint64_t> missing(cones.everything(),
                                           cones.everything() + cones.words());
        for (const auto& [begin, cell] : after) {
            words.meet(missing.data(), cones.missing(cell));
            if (words.complete(missing.data(), missing.data())) {
                best = std::min(best, begin);
                break;
            }
        }
    }
    return best;
}

class RandomWindows : public testing::TestWithParam<std::size_t> {};

TEST_P(RandomWindows, AgreeWithTryingAllWindows)
{
    std::mt19937 random{11};
    std::uniform_real_distribution<double> uniform{0, 1};
    for (int trial = 0; trial < 60; ++trial) {
        const ConeSet cones{random_map(GetParam(), 40, random)};
        const double length = trial % 2 == 0 ? 0 : 0.3 * uniform(random);
        AxisView view;
        for (std::uint32_t cell = 0; cell < cones.cells().size(); ++cell) {
            const double begin = turn * uniform(random);
            const auto side = std::uint8_t(cell % 2);
            view.swept.push_back({begin, begin + length, uniform(random), cell, side});
        }
        std::sort(view.swept.begin(), view.swept.end(),
                  [](const SeenCell& a, const SeenCell& b) { return a.begin < b.begin; });
        const LevelLimits limits{{0.9, 0.8}};
        const std::vector<SweptRange> all{{0, view.swept.size()}};
        WindowSweep sweep{cones};
        const double expected = naive_width(cones, view, limits);
        const auto window = sweep.least(view, all, limits, 10);
        ASSERT_EQ(window.has_value(), expected < 100);
        if (!window)
            continue;
        EXPECT_NEAR(window->width, expected, 1e-12);
        EXPECT_FALSE(sweep.least(view, all, limits, window->width));
        EXPECT_TRUE(sweep.least(view, all, limits, window->width + 1e-9));
    }
}

INSTANTIATE_TEST_SUITE_P(Cones, RandomWindows, testing::Values(5, 60, 100, 200, 300));

TEST(WindowSweep, CountsFreeCells)
{
    VisibilityMap map{2, 2};
    map.column(0)[0] = 1;
    map.column(1)[0] = 2;
    const ConeSet cones{map};
    AxisView view;
    view.free.push_back({0, 0, 0.2, 0, 0});
    view.swept.push_back({1.5, 1.5, 0.5, 1, 0});
    const std::vector<SweptRange> all{{0, 1}};
    WindowSweep sweep{cones};
    const auto window = sweep.least(view, all, {{1, 1}}, 7);
    ASSERT_TRUE(window);
    EXPECT_EQ(window->begin, 1.5);
    EXPECT_EQ(window->width, 0);
    EXPECT_FALSE(sweep.least(view, all, {{0.1, 1}}, 7));
    view.free.push_back({0, 0, 0.2, 1, 1});
    EXPECT_EQ(sweep.least(view, all, {{0.3, 1}}, 7)->width, 0);
}

}  // namespace
}  // namespace endmill
