// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/piece_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

double length(const PieceLink& link)
{
    return (link.to - link.from).norm();
}

// Twice the length and 20 mm for a lift over the plane x = 50 mm.
double lifted_over_a_wall(const PieceLink& link)
{
    const bool crosses = (link.from.x() < 50) != (link.to.x() < 50);
    return crosses ? 2 * length(link) + 20 : length(link);
}

Vec3 random_tip(test::Random& random)
{
    return {random.uniform(0, 100), random.uniform(0, 100), random.uniform(0, 10)};
}

enum class Reversal { All, None, EverySecond };

// Pieces of random length up to 100 mm.
std::vector<PieceEnds> random_pieces(test::Random& random, std::size_t count,
                                     Reversal reversal = Reversal::All)
{
    std::vector<PieceEnds> pieces;
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 first = random_tip(random);
        const Vec3 last = first + random.uniform(0, 1) * (random_tip(random) - first);
        const bool may_reverse = reversal == Reversal::All ||
                                 (reversal == Reversal::EverySecond && k % 2 == 1);
        pieces.push_back(OpenPiece{first, last, may_reverse});
    }
    return pieces;
}

// A way to cut a piece.
struct Way {
    Vec3 entry = Vec3::Zero();
    Vec3 exit = Vec3::Zero();
};

std::vector<Way> ways_of(const PieceEnds& piece)
{
    std::vector<Way> ways;
    if (const auto* open = std::get_if<OpenPiece>(&piece)) {
        ways.push_back({open->first, open->last});
        if (open->may_reverse)
            ways.push_back({open->last, open->first});
    } else {
        for (const Vec3& start : std::get<ClosedPiece>(piece).starts)
            ways.push_back({start, start});
    }
    return ways;
}

// The least cost over all orders and ways, by the dynamic program over subsets.
double least_cost(const std::vector<PieceEnds>& pieces, const LinkCost& cost)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const std::size_t count = pieces.size();
    std::vector<std::vector<Way>> ways;
    ways.reserve(count);
    for (const PieceEnds& piece : pieces)
        ways.push_back(ways_of(piece));
    // By subset, last piece and its way.
    std::vector<std::vector<std::vector<double>>> least(std::size_t{1} << count);
    for (auto& of_subset : least)
        for (const auto& of_piece : ways)
            of_subset.emplace_back(of_piece.size(), infinite);
    for (std::size_t k = 0; k < count; ++k)
        std::ranges::fill(least[std::size_t{1} << k][k], 0.0);
    for (std::size_t subset = 1; subset < least.size(); ++subset)
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t way = 0; way < ways[k].size(); ++way) {
                const double so_far = least[subset][k][way];
                if (so_far == infinite)
                    continue;
                for (std::size_t j = 0; j < count; ++j) {
                    if ((subset >> j & 1) != 0)
                        continue;
                    auto& next = least[subset | std::size_t{1} << j][j];
                    for (std::size_t to = 0; to < ways[j].size(); ++to)
                        next[to] = std::min(
                            next[to],
                            so_far + cost({k, j, ways[k][way].exit, ways[j][to].entry}));
                }
            }
    double best = infinite;
    for (const auto& of_piece : least.back())
        best = std::min(best, std::ranges::min(of_piece));
    return best;
}

// The least length of the tours that begin at any end and lead to the nearest remaining
// end each time.
double nearest_neighbour_length(const std::vector<PieceEnds>& pieces)
{
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t first = 0; first < pieces.size(); ++first)
        for (const Way& first_way : ways_of(pieces[first])) {
            std::vector<bool> is_cut(pieces.size());
            is_cut[first] = true;
            Vec3 at = first_way.exit;
            double sum = 0;
            for (std::size_t k = 1; k < pieces.size(); ++k) {
                std::size_t nearest = 0;
                Way nearest_way;
                double distance = std::numeric_limits<double>::infinity();
                for (std::size_t j = 0; j < pieces.size(); ++j)
                    for (const Way& way : ways_of(pieces[j]))
                        if (!is_cut[j] && (way.entry - at).norm() < distance)
                            nearest = j, nearest_way = way,
                            distance = (way.entry - at).norm();
                is_cut[nearest] = true;
                at = nearest_way.exit;
                sum += distance;
            }
            best = std::min(best, sum);
        }
    return best;
}

// Checks that each piece is cut once in an allowed way, and the sum of the costs.
void expect_valid(const PieceOrder& order, const std::vector<PieceEnds>& pieces,
                  const LinkCost& cost)
{
    ASSERT_EQ(order.pieces.size(), pieces.size());
    std::vector<int> times(pieces.size());
    double sum = 0;
    Vec3 exit = Vec3::Zero();
    for (std::size_t k = 0; k < order.pieces.size(); ++k) {
        const auto& [piece, is_reversed, start] = order.pieces[k];
        ASSERT_LT(piece, pieces.size());
        ++times[piece];
        Way way;
        if (const auto* open = std::get_if<OpenPiece>(&pieces[piece])) {
            EXPECT_TRUE(open->may_reverse || !is_reversed);
            EXPECT_EQ(start, 0U);
            way =
                is_reversed ? Way{open->last, open->first} : Way{open->first, open->last};
        } else {
            EXPECT_FALSE(is_reversed);
            const auto& starts = std::get<ClosedPiece>(pieces[piece]).starts;
            ASSERT_LT(start, starts.size());
            way = {starts[start], starts[start]};
        }
        if (k > 0)
            sum += cost({order.pieces[k - 1].piece, piece, exit, way.entry});
        exit = way.exit;
    }
    EXPECT_EQ(std::ranges::count(times, 1), std::ptrdiff_t(pieces.size()));
    EXPECT_NEAR(order.link_cost, sum, 1e-13 * sum);
}

TEST(PieceOrder, OfNinePiecesIsNearTheOptimumAndNeverWorseThanTheNearestNeighbour)
{
    test::Random random{22};
    double ratios = 0;
    for (int k = 0; k < 100; ++k) {
        const std::vector<PieceEnds> pieces = random_pieces(random, 9);
        const PieceOrder order = order_pieces(pieces);
        expect_valid(order, pieces, length);
        const double least = least_cost(pieces, length);
        EXPECT_GE(order.link_cost, least * (1 - 1e-12));
        EXPECT_LE(order.link_cost, nearest_neighbour_length(pieces) * (1 + 1e-12));
        ratios += order.link_cost / least;
    }
    EXPECT_LE(ratios / 100, 1.01);
}

TEST(PieceOrder, WithOneWayPiecesIsNearTheOptimum)
{
    test::Random random{23};
    for (const Reversal reversal : {Reversal::None, Reversal::EverySecond}) {
        double ratios = 0;
        for (int k = 0; k < 50; ++k) {
            const std::vector<PieceEnds> pieces = random_pieces(random, 9, reversal);
            const PieceOrder order = order_pieces(pieces);
            expect_valid(order, pieces, length);
            EXPECT_LE(order.link_cost, nearest_neighbour_length(pieces) * (1 + 1e-12));
            ratios += order.link_cost / least_cost(pieces, length);
        }
        EXPECT_LE(ratios / 50, 1.02);
    }
}

TEST(PieceOrder, ChoosesTheStartsOfClosedPieces)
{
    test::Random random{24};
    double ratios = 0;
    for (int round = 0; round < 50; ++round) {
        std::vector<PieceEnds> pieces = random_pieces(random, 3);
        for (int k = 0; k < 4; ++k) {
            ClosedPiece circle;
            const Vec3 centre = random_tip(random);
            const double radius = random.uniform(1, 30);
            for (int corner = 0; corner < 24; ++corner)
                circle.starts.push_back(centre + radius * Vec3{std::cos(corner * 0.2618),
                                                               std::sin(corner * 0.2618),
                                                               0});
            pieces.push_back(circle);
        }
        const PieceOrder order = order_pieces(pieces);
        expect_valid(order, pieces, length);
        ratios += order.link_cost / least_cost(pieces, length);
    }
    EXPECT_LE(ratios / 50, 1.05);
}

TEST(PieceOrder, MinimisesTheCostOfTheCaller)
{
    test::Random random{25};
    double ratios = 0;
    for (int k = 0; k < 50; ++k) {
        const std::vector<PieceEnds> pieces = random_pieces(random, 9);
        const PieceOrder order = order_pieces(pieces, {.cost = lifted_over_a_wall});
        expect_valid(order, pieces, lifted_over_a_wall);
        ratios += order.link_cost / least_cost(pieces, lifted_over_a_wall);
    }
    EXPECT_LE(ratios / 50, 1.05);
}

// Line k lies k mm beside the first one. The shortest order is the zigzag.
TEST(PieceOrder, OfShuffledParallelLinesIsTheZigzag)
{
    test::Random random{26};
    for (const std::size_t count : {7, 200, 1500}) {
        std::vector<PieceEnds> pieces;
        for (std::size_t k = 0; k < count; ++k)
            pieces.push_back(OpenPiece{{0, double(k), 0}, {1000, double(k), 0}});
        std::ranges::shuffle(pieces, random.engine());
        const PieceOrder order = order_pieces(pieces);
        expect_valid(order, pieces, length);
        EXPECT_NEAR(order.link_cost, double(count - 1), 1e-9);
    }
}

TEST(PieceOrder, CallsTheCostInProportionToThePieces)
{
    const auto calls = [](std::size_t count) {
        test::Random random{27};
        std::vector<PieceEnds> pieces;
        for (std::size_t k = 0; k < count; ++k) {
            const double side = std::sqrt(double(count));
            const Vec3 first{random.uniform(0, side), random.uniform(0, side), 0};
            pieces.push_back(OpenPiece{first, first + Vec3{0.5, 0, 0}});
        }
        std::size_t called = 0;
        PieceOrderOptions options;
        options.tours = 1;
        options.cost = [&](const PieceLink& link) {
            ++called;
            return length(link);
        };
        const PieceOrder order = order_pieces(pieces, options);
        expect_valid(order, pieces, length);
        return double(called);
    };
    const double few = calls(1000);
    EXPECT_LT(few, 1000 * 1500);
    EXPECT_LT(calls(8000), 10 * few);
}

TEST(PieceOrder, IsTheSameEachTime)
{
    test::Random random{28};
    const std::vector<PieceEnds> pieces = random_pieces(random, 120);
    const PieceOrder order = order_pieces(pieces);
    const PieceOrder again = order_pieces(pieces);
    EXPECT_EQ(order.link_cost, again.link_cost);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        EXPECT_EQ(order.pieces[k].piece, again.pieces[k].piece);
        EXPECT_EQ(order.pieces[k].is_reversed, again.pieces[k].is_reversed);
    }
}

TEST(PieceOrder, OfEqualPiecesCostsNothing)
{
    std::vector<PieceEnds> pieces(300, OpenPiece{{1, 2, 3}, {1, 2, 3}});
    pieces.resize(400, ClosedPiece{std::vector<Vec3>(5, Vec3{1, 2, 3})});
    const PieceOrder order = order_pieces(pieces);
    expect_valid(order, pieces, length);
    EXPECT_EQ(order.link_cost, 0);
}

TEST(PieceOrder, OfFewPieces)
{
    EXPECT_TRUE(order_pieces({}).pieces.empty());
    EXPECT_EQ(order_pieces({}).link_cost, 0);
    const OpenPiece line{{0, 0, 0}, {10, 0, 0}};
    const OpenPiece beside{{0, 3, 0}, {10, 3, 0}};
    const ClosedPiece ring{{{10, 5, 0}, {10, -2, 0}}};
    EXPECT_EQ(order_pieces(std::vector<PieceEnds>{line}).pieces.size(), 1U);
    EXPECT_EQ(order_pieces(std::vector<PieceEnds>{line, beside}).link_cost, 3);
    const PieceOrder closed = order_pieces(std::vector<PieceEnds>{line, ring});
    EXPECT_EQ(closed.link_cost, 2);
    const bool ring_is_first = closed.pieces.front().piece == 1;
    EXPECT_EQ(closed.pieces[ring_is_first ? 0 : 1].start, 1U);
    EXPECT_EQ(closed.pieces[ring_is_first ? 1 : 0].is_reversed, ring_is_first);
}

TEST(PieceOrder, RefusesInvalidPiecesAndOptions)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const OpenPiece line{{0, 0, 0}, {10, 0, 0}};
    for (const PieceEnds& bad :
         {PieceEnds{OpenPiece{{nan, 0, 0}, {1, 0, 0}}},
          PieceEnds{OpenPiece{{0, 0, 0}, {1, INFINITY, 0}}}, PieceEnds{ClosedPiece{}},
          PieceEnds{ClosedPiece{{Vec3{0, 0, nan}}}}})
        EXPECT_THROW(order_pieces(std::vector<PieceEnds>{line, bad}), DomainError);
    EXPECT_THROW(order_pieces(std::vector<PieceEnds>{line}, {.tours = 0}), DomainError);
    EXPECT_THROW(order_pieces(std::vector<PieceEnds>{line}, {.neighbours = 0}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
