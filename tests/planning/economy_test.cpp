// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/economy.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

PathPoint touching(int pass, Move move, const Vec3& contact, const Vec3& tip)
{
    return {pass,
            0,
            move,
            0,
            {tip, Vec3::UnitZ()},
            SurfaceContact{0, 0, {contact, Vec3::UnitZ()}}};
}

PathPoint lifted(int pass, Move move, const Vec3& tip)
{
    return {pass, 0, move, 0, {tip, Vec3::UnitZ()}};
}

TEST(PathEconomy, CountsAndSumsAZigZag)
{
    ToolPath path;
    path.points = {touching(0, Move::Plunge, {0, 0, 0}, {0, 0, 1}),
                   touching(0, Move::Cut, {3, 4, 0}, {6, 8, 1}),
                   touching(1, Move::Link, {3, 4, 12}, {6, 8, 2}),
                   touching(1, Move::Cut, {3, 4, 11}, {6, 8, 4}),
                   touching(1, Move::Cut, {3, 4, 9}, {6, 8, 8})};
    const PathEconomy economy = path_economy(path);
    EXPECT_EQ(economy.passes, 2U);
    EXPECT_EQ(economy.ncl, 5U);
    EXPECT_EQ(economy.cut.contact_mm, 5 + 1 + 2);
    EXPECT_EQ(economy.cut.tip_mm, 10 + 2 + 4);
    EXPECT_EQ(economy.link.contact_mm, 12);
    EXPECT_EQ(economy.link.tip_mm, 1);
}

TEST(CountedTravel, AddsTheLinksIfTheyCount)
{
    const PathEconomy economy{2, 5, {8, 16}, {12, 1}};
    EXPECT_EQ(counted_travel(economy, TravelKind::Contact, CountedMoves::Cuts), 8);
    EXPECT_EQ(counted_travel(economy, TravelKind::Tip, CountedMoves::Cuts), 16);
    EXPECT_EQ(counted_travel(economy, TravelKind::Contact, CountedMoves::CutsAndLinks),
              8 + 12);
    EXPECT_EQ(counted_travel(economy, TravelKind::Tip, CountedMoves::CutsAndLinks),
              16 + 1);
}

TEST(PathEconomy, OmitsLiftedMoves)
{
    ToolPath path;
    path.points = {touching(0, Move::Plunge, {0, 0, 0}, {0, 0, 0}),
                   touching(0, Move::Cut, {1, 0, 0}, {1, 0, 0}),
                   lifted(1, Move::Retract, {1, 0, 50}),
                   lifted(1, Move::Rapid, {0, 6, 50}),
                   touching(1, Move::Plunge, {0, 6, 0}, {0, 6, 0}),
                   touching(1, Move::Cut, {1, 6, 0}, {1, 6, 0})};
    const PathEconomy economy = path_economy(path);
    EXPECT_EQ(economy.passes, 2U);
    EXPECT_EQ(economy.ncl, 4U);
    EXPECT_EQ(economy.cut.contact_mm, 2);
    EXPECT_EQ(economy.cut.tip_mm, 2);
    EXPECT_EQ(economy.link.contact_mm, 0);
    EXPECT_EQ(economy.link.tip_mm, 0);
}

TEST(PathEconomy, OfAnEmptyPathIsZero)
{
    const PathEconomy economy = path_economy({});
    EXPECT_EQ(economy.passes, 0U);
    EXPECT_EQ(economy.ncl, 0U);
    EXPECT_EQ(economy.cut.contact_mm, 0);
}

TEST(PathEconomy, OfOnePointIsAPassWithoutLength)
{
    ToolPath path;
    path.points = {touching(0, Move::Plunge, {1, 2, 3}, {1, 2, 3})};
    const PathEconomy economy = path_economy(path);
    EXPECT_EQ(economy.passes, 1U);
    EXPECT_EQ(economy.ncl, 1U);
    EXPECT_EQ(economy.cut.tip_mm, 0);
}

// An arch 3 mm high over 4 mm, by three moves at feed.
TEST(PathEconomy, CountsTheMovesOfAnArchAsOneLink)
{
    ToolPath path;
    path.points = {touching(0, Move::Plunge, {0, 0, 0}, {0, 0, 0}),
                   lifted(1, Move::Link, {0, 0, 3}), lifted(1, Move::Link, {4, 0, 3}),
                   touching(1, Move::Link, {4, 0, 0}, {4, 0, 0})};
    const PathEconomy economy = path_economy(path);
    EXPECT_EQ(economy.ncl, 4U);
    EXPECT_EQ(economy.link.tip_mm, 10);
    EXPECT_EQ(economy.link.contact_mm, 4);
    path.points.pop_back();
    EXPECT_THROW(path_economy(path), DomainError);
}

TEST(PathEconomy, RefusesACutThatDoesNotLeadFromContactToContact)
{
    const PathPoint plunge = touching(0, Move::Plunge, {0, 0, 0}, {0, 0, 0});
    const PathPoint cut = touching(0, Move::Cut, {1, 0, 0}, {1, 0, 0});
    const PathPoint retract = lifted(0, Move::Retract, {1, 0, 50});
    EXPECT_THROW(path_economy({{cut}}), DomainError);
    EXPECT_THROW(path_economy({{plunge, retract, cut}}), DomainError);
    EXPECT_THROW(path_economy({{plunge, lifted(0, Move::Link, {1, 0, 0})}}), DomainError);
}

// The reference is the sum in long double, whose error is 2000 times smaller.
TEST(PathEconomy, SumsToTheAccuracyStated)
{
    test::Random random{1};
    const auto place = [&] {
        const double size = random.log_uniform(1e-3, 1e3);
        const double x = random.uniform(-size, size);
        const double y = random.uniform(-size, size);
        return Vec3{x, y, random.uniform(-size, size)};
    };
    constexpr int moves = 20000;
    ToolPath path;
    path.points.push_back(touching(0, Move::Plunge, place(), place()));
    long double contacts = 0;
    long double tips = 0;
    for (int k = 0; k < moves; ++k) {
        const PathPoint& from = path.points.back();
        const PathPoint to = touching(0, Move::Cut, place(), place());
        const auto length = [](const Vec3& a, const Vec3& b) {
            return (b.cast<long double>() - a.cast<long double>()).norm();
        };
        contacts += length(from.contact()->contact.point, to.contact()->contact.point);
        tips += length(from.location.tip, to.location.tip);
        path.points.push_back(to);
    }
    const Travel cut = path_economy(path).cut;
    const double most = 1.2e-16 * (moves + 4);
    EXPECT_LT(std::abs(cut.contact_mm - contacts), most * contacts);
    EXPECT_LT(std::abs(cut.tip_mm - tips), most * tips);
}

struct PrintedCell {
    DirectionCost u;
    DirectionCost v;
    int reduction_ncl_percent;
    int reduction_tcd_percent;
};

// [KimChoi, table 1, table 2] at D = 10, 15 and 20 mm and a tolerance of 0.5 mm. The
// reductions are 23.15, 22.71 and 22.36 % of the points, and 8.52, 7.90 and 7.39 % of the
// travel.
TEST(CompareDirections, GivesTheReductionsThatThePaperPrints)
{
    for (const auto& [u, v, ncl, tcd] :
         {PrintedCell{{1313, 25699.9}, {1009, 23509.5}, 2315, 852},
          {{1061, 20809.3}, {820, 19164.4}, 2271, 790},
          {{917, 18015.1}, {712, 16683.1}, 2236, 739}}) {
        const DirectionComparison comparison = compare_directions(u, v);
        EXPECT_EQ(comparison.recommended, Parameter::V);
        EXPECT_EQ(std::lround(1e4 * comparison.reduction_ncl), ncl);
        EXPECT_EQ(std::lround(1e4 * comparison.reduction_tcd), tcd);
        const DirectionComparison turned = compare_directions(v, u);
        EXPECT_EQ(turned.recommended, Parameter::U);
        EXPECT_EQ(turned.reduction_ncl, comparison.reduction_ncl);
    }
}

TEST(CompareDirections, PrefersLessTravelThenFewerPointsThenU)
{
    EXPECT_EQ(compare_directions({10, 100}, {99, 99}).recommended, Parameter::V);
    EXPECT_EQ(compare_directions({10, 100}, {9, 100}).recommended, Parameter::V);
    EXPECT_EQ(compare_directions({9, 100}, {10, 100}).recommended, Parameter::U);
    const DirectionComparison equal = compare_directions({10, 100}, {10, 100});
    EXPECT_EQ(equal.recommended, Parameter::U);
    EXPECT_EQ(equal.reduction_ncl, 0);
    EXPECT_EQ(equal.reduction_tcd, 0);
}

TEST(CompareDirections, ReducesToTheAccuracyStated)
{
    test::Random random{2};
    for (int k = 0; k < 20000; ++k) {
        const double one = random.log_uniform(1e-3, 1e6);
        const double other = one * (1 + random.log_uniform(1e-15, 10));
        const auto n = static_cast<std::size_t>(random.log_uniform(1, 6e15));
        const std::size_t more = n / 3;
        const auto comparison = compare_directions({n, one}, {n + more, other});
        const long double tcd =
            (static_cast<long double>(other) - one) / static_cast<long double>(other);
        const long double ncl = static_cast<long double>(more) / (n + more);
        EXPECT_LE(std::abs(comparison.reduction_tcd - tcd), 4e-16L * tcd);
        EXPECT_LE(std::abs(comparison.reduction_ncl - ncl), 4e-16L * ncl);
    }
}

TEST(CompareDirections, RefusesCostsThatAreNotPositiveAndFinite)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(compare_directions({0, 1}, {1, 1}), DomainError);
    EXPECT_THROW(compare_directions({1, 1}, {0, 1}), DomainError);
    EXPECT_THROW(compare_directions({1, 0}, {1, 1}), DomainError);
    EXPECT_THROW(compare_directions({1, 1}, {1, -1}), DomainError);
    EXPECT_THROW(compare_directions({1, nan}, {1, 1}), DomainError);
    EXPECT_THROW(compare_directions({1, 1}, {1, infinity}), DomainError);
}

}  // namespace
}  // namespace endmill
