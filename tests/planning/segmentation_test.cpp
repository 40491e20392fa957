// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/segmentation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

using Point = Eigen::Vector2d;

const SegmentationOptions exact{.kept_candidates = 0};

// Feasible where all samples between lie within `tolerance` of the chord, on either side.
MoveTest within_band(const std::vector<Point>& curve, double tolerance)
{
    return [&curve, tolerance](std::size_t from, std::size_t to) {
        const Point chord = curve[to] - curve[from];
        for (std::size_t k = from + 1; k < to; ++k) {
            const Point d = curve[k] - curve[from];
            const double share = std::clamp(d.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
            if ((d - share * chord).norm() > tolerance)
                return false;
        }
        return true;
    };
}

// Two full waves: inflections at the ends and at three places between.
std::vector<Point> s_curve(std::size_t samples)
{
    std::vector<Point> curve;
    for (std::size_t k = 0; k < samples; ++k) {
        const double x = 4 * std::numbers::pi * double(k) / double(samples - 1);
        curve.push_back({x, std::sin(x)});
    }
    return curve;
}

// A sum of four waves of random height, length and phase.
std::vector<Point> random_curve(test::Random& random, std::size_t samples)
{
    std::vector<Point> curve;
    for (std::size_t k = 0; k < samples; ++k)
        curve.push_back({20 * double(k) / double(samples - 1), 0});
    for (int wave = 0; wave < 4; ++wave) {
        const double height = random.uniform(0.1, 1);
        const double frequency = random.uniform(0.2, 1.5);
        const double phase = random.uniform(0, 6.28);
        for (Point& point : curve)
            point.y() += height * std::sin(frequency * point.x() + phase);
    }
    return curve;
}

// The answers of `test` for all moves of an open pass, in a table.
MoveTest tabulated(const MoveTest& test, std::size_t samples)
{
    std::vector<std::vector<bool>> answers(samples, std::vector<bool>(samples));
    for (std::size_t from = 0; from < samples; ++from)
        for (std::size_t to = from + 1; to < samples; ++to)
            answers[from][to] = test(from, to);
    return
        [answers](std::size_t from, std::size_t to) { return bool(answers[from][to]); };
}

// A table of random answers, each yes with probability `share`.
MoveTest random_answers(test::Random& random, std::size_t samples, double share)
{
    std::vector<std::vector<bool>> answers(samples, std::vector<bool>(samples));
    for (auto& row : answers)
        for (std::size_t k = 0; k < samples; ++k)
            row[k] = random.uniform(0, 1) < share;
    return
        [answers](std::size_t from, std::size_t to) { return bool(answers[from][to]); };
}

// The least number of moves, and the least longest move with it; or no moves.
using Best = std::pair<std::size_t, std::size_t>;

// Tries all sequences of feasible moves to `end`, one by one.
struct Exhaustive {
    const MoveTest& test;
    std::size_t samples;  // their numbers are taken modulo this
    std::size_t end;
    Best best;

    void try_all(std::size_t at, Best so_far)
    {
        if (at == end) {
            best = std::min(best, so_far);
            return;
        }
        if (so_far.first == best.first)
            return;
        for (std::size_t to = at + 1; to <= end; ++to)
            if (to % samples != at % samples && test(at % samples, to % samples))
                try_all(to, {so_far.first + 1, std::max(so_far.second, to - at)});
    }
};

Best exhaustive(const MoveTest& test, std::size_t samples, PassShape shape)
{
    Best best{samples + 1, samples + 1};
    const bool is_open = shape == PassShape::Open;
    for (std::size_t start = 0; start < (is_open ? 1 : samples); ++start) {
        const std::size_t end = is_open ? samples - 1 : start + samples;
        Exhaustive search{test, samples, end, best};
        search.try_all(start, {0, 0});
        best = search.best;
    }
    return best;
}

// The number of moves if each one leads as far as any feasible move from its start.
std::size_t greedy_moves(const MoveTest& test, std::size_t samples)
{
    std::size_t moves = 0;
    for (std::size_t at = 0; at < samples - 1; ++moves) {
        std::size_t to = samples - 1;
        while (!test(at, to))
            --to;
        at = to;
    }
    return moves;
}

// Checks that the division consists of feasible moves, and that its counts are right.
void expect_consistent(const Segmentation& division, const MoveTest& test,
                       std::size_t samples, PassShape shape)
{
    const auto& vertices = division.vertices;
    ASSERT_FALSE(vertices.empty());
    EXPECT_TRUE(std::ranges::is_sorted(vertices));
    const bool is_open = shape == PassShape::Open;
    if (is_open) {
        EXPECT_EQ(vertices.front(), 0U);
        EXPECT_EQ(vertices.back(), samples - 1);
    }
    ASSERT_EQ(division.moves, vertices.size() - (is_open ? 1 : 0));
    std::size_t longest = 0;
    for (std::size_t k = 0; k < division.moves; ++k) {
        const std::size_t from = vertices[k];
        const std::size_t to = vertices[(k + 1) % vertices.size()];
        EXPECT_TRUE(test(from, to)) << from << " to " << to;
        longest = std::max(longest, (to + samples - from) % samples);
    }
    EXPECT_EQ(division.longest_move, longest);
}

TEST(Segmentation, OfAnSCurveIsTheExhaustiveOptimum)
{
    for (const std::size_t samples : {20, 41, 60}) {
        const std::vector<Point> curve = s_curve(samples);
        for (const double tolerance : {0.2, 0.3, 0.45, 0.6}) {
            const MoveTest test = tabulated(within_band(curve, tolerance), samples);
            const auto division = fewest_moves(samples, PassShape::Open, test, exact);
            ASSERT_TRUE(division);
            EXPECT_EQ((Best{division->moves, division->longest_move}),
                      exhaustive(test, samples, PassShape::Open))
                << samples << " samples, tolerance " << tolerance;
            EXPECT_TRUE(division->is_exact);
            expect_consistent(*division, test, samples, PassShape::Open);
        }
    }
}

TEST(Segmentation, IsNeverWorseThanGreedyAndSometimesBetter)
{
    test::Random random{20};
    int better = 0;
    for (int k = 0; k < 1000; ++k) {
        const std::size_t samples = 60;
        const std::vector<Point> curve = random_curve(random, samples);
        const MoveTest test = within_band(curve, random.uniform(0.02, 0.4));
        const std::size_t greedy = greedy_moves(test, samples);
        const auto best = fewest_moves(samples, PassShape::Open, test, exact);
        ASSERT_TRUE(best);
        expect_consistent(*best, test, samples, PassShape::Open);
        EXPECT_LE(best->moves, greedy);
        better += best->moves < greedy ? 1 : 0;
    }
    EXPECT_GT(better, 50);
}

TEST(Segmentation, QuickSearchIsNearlyOptimalForFewTests)
{
    test::Random random{22};
    std::size_t least_moves = 0;
    std::size_t moves = 0;
    int more_than_greedy = 0;
    for (int k = 0; k < 300; ++k) {
        const std::size_t samples = 200;  // about 17 a move
        const std::vector<Point> curve = random_curve(random, samples);
        const MoveTest test = within_band(curve, random.uniform(0.02, 0.4));
        const auto best = fewest_moves(samples, PassShape::Open, test, exact);
        const auto quick = fewest_moves(samples, PassShape::Open, test);
        ASSERT_TRUE(best && quick);
        expect_consistent(*quick, test, samples, PassShape::Open);
        EXPECT_FALSE(quick->is_exact);
        EXPECT_GE(quick->moves, best->moves);
        EXPECT_LE(quick->tested_moves, 13 * samples);
        least_moves += best->moves;
        moves += quick->moves;
        more_than_greedy += quick->moves > greedy_moves(test, samples) ? 1 : 0;
    }
    EXPECT_LT(double(moves), 1.02 * double(least_moves));
    EXPECT_LT(more_than_greedy, 30);
}

TEST(Segmentation, OfRandomAnswersIsTheExhaustiveOptimum)
{
    test::Random random{21};
    int none = 0;
    for (int k = 0; k < 400; ++k) {
        const std::size_t samples = 2 + k % 11;
        const MoveTest test = random_answers(random, samples, random.uniform(0.1, 0.7));
        for (const PassShape shape : {PassShape::Open, PassShape::Closed}) {
            const Best best = exhaustive(test, samples, shape);
            const auto division = fewest_moves(samples, shape, test, exact);
            ASSERT_EQ(division.has_value(), best.first <= samples);
            if (!division) {
                ++none;
                continue;
            }
            EXPECT_EQ((Best{division->moves, division->longest_move}), best);
            expect_consistent(*division, test, samples, shape);
        }
    }
    EXPECT_GT(none, 20);
    EXPECT_LT(none, 700);
}

// A circle in `samples` equal parts, and moves whose chord lies at most `tolerance`
// inside, measured at the samples that it passes.
MoveTest on_circle(double radius, std::size_t samples, double tolerance)
{
    return [=](std::size_t from, std::size_t to) {
        const std::size_t step = (to + samples - from) % samples;
        const double turn = 2 * std::numbers::pi / double(samples);
        const Point chord{std::cos(turn * double(step)) - 1,
                          std::sin(turn * double(step))};
        for (std::size_t k = 1; k < step; ++k) {
            const Point d{std::cos(turn * double(k)) - 1, std::sin(turn * double(k))};
            const double depth = d.x() * chord.y() - d.y() * chord.x();
            if (radius * depth / chord.norm() > tolerance)
                return false;
        }
        return true;
    };
}

// A chord of a circle with radius r of which no point lies deeper than d spans at most
// the angle 2 acos(1 - d / r).
TEST(Segmentation, OfACircleAroundACylinderHasTheClosedNumberOfMoves)
{
    constexpr double ball_radius = 7.5;
    for (const auto& [radius, tolerance, expected] :
         {std::tuple{20.0, 0.5, 17}, {20.0, 0.1, 37}, {5.0, 0.01, 79}, {2.0, 2.0, 5}}) {
        const double centres = radius + ball_radius;
        const double half_turn = std::acos(1 - tolerance / centres);
        const auto moves =
            static_cast<std::size_t>(std::ceil(std::numbers::pi / half_turn));
        ASSERT_EQ(moves, std::size_t(expected));
        for (const std::size_t samples : {9 * moves, 24 * moves}) {
            const MoveTest test = on_circle(centres, samples, tolerance);
            SegmentationOptions options = exact;
            options.widest_step = 40;
            const auto division = fewest_moves(samples, PassShape::Closed, test, options);
            ASSERT_TRUE(division);
            EXPECT_EQ(division->moves, moves);
            expect_consistent(*division, test, samples, PassShape::Closed);
            const auto quick = fewest_moves(samples, PassShape::Closed, test);
            ASSERT_TRUE(quick);
            EXPECT_EQ(quick->moves, moves);
            expect_consistent(*quick, test, samples, PassShape::Closed);
        }
    }
}

TEST(Segmentation, OfEqualNumbersOfMovesHasTheShortestLongestMove)
{
    const auto at_most_ten = [](std::size_t from, std::size_t to) {
        return to - from <= 10;
    };
    const auto division = fewest_moves(34, PassShape::Open, at_most_ten, exact);
    ASSERT_TRUE(division);
    EXPECT_EQ(division->moves, 4U) << "33 samples";
    EXPECT_EQ(division->longest_move, 9U) << "33 = 9 + 8 + 8 + 8";
}

TEST(Segmentation, TestsEachMoveAtMostOnceAndNoneAboveTheWidestStep)
{
    const std::vector<Point> curve = s_curve(300);
    const MoveTest band = within_band(curve, 0.05);
    for (const PassShape shape : {PassShape::Open, PassShape::Closed}) {
        std::set<std::pair<std::size_t, std::size_t>> asked;
        const MoveTest counted = [&](std::size_t from, std::size_t to) {
            EXPECT_NE(from, to);
            EXPECT_LE((to + 300 - from) % 300, 40U);
            EXPECT_TRUE(asked.insert({from, to}).second) << from << ' ' << to;
            return from < to ? band(from, to) : to == 0 || from == 299;
        };
        SegmentationOptions options = exact;
        options.widest_step = 40;
        const auto division = fewest_moves(300, shape, counted, options);
        ASSERT_TRUE(division);
        EXPECT_EQ(division->tested_moves, asked.size());
        EXPECT_LE(asked.size(), 300U * 40U);
    }
}

TEST(Segmentation, QuickSearchKeepsTheWidestStep)
{
    const SegmentationOptions options{.widest_step = 7};
    for (const PassShape shape : {PassShape::Open, PassShape::Closed}) {
        const MoveTest up_to_7 = [](std::size_t from, std::size_t to) {
            EXPECT_LE((to + 100 - from) % 100, 7U);
            return true;
        };
        const auto division = fewest_moves(100, shape, up_to_7, options);
        ASSERT_TRUE(division);
        EXPECT_EQ(division->moves, 15U) << "99 / 7 and 100 / 7, rounded up";
        EXPECT_EQ(division->longest_move, 7U);
    }
}

TEST(Segmentation, NeedsFewTestsOfADensePass)
{
    // 64 samples a move.
    constexpr std::size_t samples = 64 * 200 + 1;
    const auto within_64 = [](std::size_t from, std::size_t to) {
        return to - from <= 64;
    };
    const auto quick = fewest_moves(samples, PassShape::Open, within_64);
    ASSERT_TRUE(quick);
    EXPECT_EQ(quick->moves, 200U);
    EXPECT_LT(quick->tested_moves, 3 * samples);
}

TEST(Segmentation, OfPassesWithoutADivisionIsNone)
{
    const auto not_over_5 = [](std::size_t from, std::size_t to) {
        return to <= 5 || from > 5;
    };
    const auto never = [](std::size_t, std::size_t) { return false; };
    for (const std::size_t kept : {0, 1, 8})
        for (const PassShape shape : {PassShape::Open, PassShape::Closed}) {
            const SegmentationOptions options{.kept_candidates = kept};
            EXPECT_FALSE(fewest_moves(2, shape, never, options));
            EXPECT_FALSE(fewest_moves(30, shape, never, options));
            EXPECT_FALSE(fewest_moves(30, PassShape::Open, not_over_5, options));
        }
}

TEST(Segmentation, OfTwoSamplesIsOneMoveOrTwo)
{
    const auto always = [](std::size_t, std::size_t) { return true; };
    for (const std::size_t kept : {0, 1, 8}) {
        const SegmentationOptions options{.kept_candidates = kept};
        EXPECT_EQ(fewest_moves(2, PassShape::Open, always, options)->moves, 1U);
        EXPECT_EQ(fewest_moves(2, PassShape::Closed, always, options)->moves, 2U);
        EXPECT_EQ(fewest_moves(50, PassShape::Open, always, options)->moves, 1U);
        EXPECT_EQ(fewest_moves(50, PassShape::Closed, always, options)->moves, 2U);
    }
}

TEST(Segmentation, RefusesOneSampleAndAnEndlessTable)
{
    const auto always = [](std::size_t, std::size_t) { return true; };
    EXPECT_THROW(fewest_moves(1, PassShape::Open, always), DomainError);
    EXPECT_THROW(fewest_moves(0, PassShape::Closed, always), DomainError);
    EXPECT_THROW(fewest_moves(100000, PassShape::Closed, always, exact), LimitError);
}

}  // namespace
}  // namespace endmill
