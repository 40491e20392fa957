// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/wide_sectors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "direction_sets.h"
#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

using test::direction;
using test::up;
using IsAllowed = std::function<bool(const SectorCandidate&)>;

SetupScore score(const SectorCandidate& sector)
{
    return {sector.area(), sector.polar + sector.opposite_polar + sector.width};
}

// Offers each sector of 180 degrees or more, from each direction to each direction.
void offer_all(const DirectionFan& fan, const IsAllowed& is_allowed,
               BestCandidate<SectorCandidate>& best)
{
    const std::size_t count = fan.size();
    for (std::size_t begin = 0; begin < count; ++begin) {
        for (std::size_t end = begin; end < begin + count; ++end) {
            double inside = 0;
            double outside = 0;
            for (std::size_t i = begin; i < begin + count; ++i) {
                double& largest = i <= end ? inside : outside;
                largest = std::max(largest, fan.polar(i));
            }
            const double width = fan.azimuth(end) - fan.azimuth(begin);
            const SectorCandidate sector =
                fan.candidate(fan.azimuth(begin), width, inside, outside);
            if (width >= std::numbers::pi - equal_angles && is_allowed(sector))
                best.offer(sector, score(sector));
        }
    }
}

// Compares the best sectors bit by bit.
void expect_the_same(const DirectionFan& fan, const IsAllowed& is_allowed, double bound)
{
    BestCandidate<SectorCandidate> expected{bound};
    BestCandidate<SectorCandidate> found{bound};
    offer_all(fan, is_allowed, expected);
    offer_wide_sectors(fan, least_wide_sectors(fan), is_allowed, found);
    ASSERT_EQ(found.best().has_value(), expected.best().has_value());
    if (!found.best())
        return;
    EXPECT_EQ(found.best()->from, expected.best()->from);
    EXPECT_EQ(found.best()->width, expected.best()->width);
    EXPECT_EQ(found.best()->polar, expected.best()->polar);
    EXPECT_EQ(found.best()->opposite_polar, expected.best()->opposite_polar);
}

struct Kind {
    std::string name;
    // A set of `count` directions.
    std::function<std::vector<Vec3>(test::Random&, int count)> make;
};

// Sets `count` directions from azimuth and polar angle, in degrees, of the i-th one.
template <class At>
std::vector<Vec3> set_of(int count, const At& at)
{
    std::vector<Vec3> all;
    for (int i = 0; i < count; ++i)
        all.push_back(direction(at(i)).normalized());
    return all;
}

std::vector<Kind> kinds()
{
    return {{"Random",
             [](test::Random& random, int count) {
                 return set_of(count, [&](int) {
                     return test::AzimuthPolar{random.uniform(0, 360),
                                               random.uniform(0, 180)};
                 });
             }},
            {"OnFewAzimuths",
             [](test::Random& random, int count) {
                 return set_of(count, [&](int) {
                     return test::AzimuthPolar{30 * std::floor(random.uniform(0, 12)),
                                               random.uniform(1, 90)};
                 });
             }},
            {"OnAGrid",
             [](test::Random& random, int count) {
                 return set_of(count, [&](int) {
                     return test::AzimuthPolar{45 * std::floor(random.uniform(0, 8)),
                                               20 * std::floor(random.uniform(0, 10))};
                 });
             }},
            // Azimuths that differ by about the tolerance of equal scores.
            {"NearlyEqual",
             [](test::Random& random, int count) {
                 return set_of(count, [&](int) {
                     return test::AzimuthPolar{
                         60 * std::floor(random.uniform(0, 6)) +
                             test::degree * random.log_uniform(1e-7, 1e-4),
                         15 * std::floor(random.uniform(1, 4)) + random.uniform(0, 1e-8)};
                 });
             }},
            {"Spiral",
             [](test::Random& random, int count) {
                 const double turn = random.uniform(0, 360);
                 const double rise = random.uniform(-60, 60) / count;
                 return set_of(count, [&](int i) {
                     return test::AzimuthPolar{turn + 330.0 * i / count, 70 + rise * i};
                 });
             }},
            {"Ring", [](test::Random& random, int count) {
                 const double polar = random.uniform(1, 120);
                 return test::ring(count, polar);
             }}};
}

class WideSectorsOf : public testing::TestWithParam<Kind> {};

TEST_P(WideSectorsOf, AreBestAsIfAllWereTried)
{
    test::Random random{61};
    for (int i = 0; i < 200; ++i) {
        const auto points = GetParam().make(random, 1 + i % 25);
        const DirectionFan fan{PolePoints{up, points}};
        const double infinity = std::numeric_limits<double>::infinity();
        expect_the_same(
            fan, [](const SectorCandidate&) { return true; }, infinity);
        const double width = random.uniform(3, 6.3);
        const double lower = random.uniform(0, 3);
        expect_the_same(
            fan,
            [&](const SectorCandidate& sector) {
                return sector.width <= width &&
                       std::min(sector.polar, sector.opposite_polar) <= lower;
            },
            random.uniform(0, 1) < 0.5 ? infinity : random.uniform(0, 10));
    }
}

TEST_P(WideSectorsOf, AreAtMostFourForEachDirection)
{
    test::Random random{62};
    const auto points = GetParam().make(random, 2000);
    const DirectionFan fan{PolePoints{up, points}};
    EXPECT_LE(least_wide_sectors(fan).size(), 4 * fan.size());
}

INSTANTIATE_TEST_SUITE_P(Sets, WideSectorsOf, testing::ValuesIn(kinds()),
                         [](const auto& kind) { return kind.param.name; });

TEST(WideSectors, NeedDirections)
{
    const DirectionFan none{PolePoints{up, {}}};
    EXPECT_TRUE(least_wide_sectors(none).empty());
    const DirectionFan one{PolePoints{up, std::vector{direction({10, 20})}}};
    EXPECT_TRUE(least_wide_sectors(one).empty());
}

}  // namespace
}  // namespace endmill
