// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_bound.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "direction_sets.h"
#include "endmill/setup/detail/rectangle_candidate.h"

namespace endmill {
namespace {

using test::degree;
using test::up;

using std::numbers::pi;

std::vector<Vec3> anywhere(test::Random& random, int count)
{
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k)
        points.push_back(
            test::direction({random.uniform(0, 360), random.uniform(1, 179)}));
    return points;
}

// If no direction lies along R1, the ranges follow from the angles of each direction.
TEST(RectangleNeeds, AgreeWithTheAnglesOfEachDirection)
{
    test::Random random{11};
    for (int i = 0; i < 200; ++i) {
        const std::vector<Vec3> points = anywhere(random, 1 + i % 9);
        const PolePoints seen{up, points};
        const R1Azimuth azimuth{random.uniform(0, pi)};
        const RectangleExtents found = RectangleNeeds{seen}.at(azimuth, azimuth);
        const auto expected =
            rectangle_about(up, seen.frame.equator(azimuth.angle), points);
        EXPECT_NEAR(found.alpha.from, expected.alpha.from, 1e-12);
        EXPECT_NEAR(found.alpha.to, expected.alpha.to, 1e-12);
        EXPECT_NEAR(found.beta.from, expected.beta.from, 1e-12);
        EXPECT_NEAR(found.beta.to, expected.beta.to, 1e-12);
    }
}

TEST(RectangleNeeds, LeaveTheSideOfTheOppositeOfTheToolAxisOpen)
{
    const std::vector<Vec3> points = test::directions({{270, 30}, {90, 50}, {0, 180}});
    const RectangleNeeds needs{PolePoints{up, points}};
    EXPECT_TRUE(needs.has_opposite());
    const R1Azimuth along_x{0};
    const RectangleExtents found = needs.at(along_x, along_x);
    EXPECT_NEAR(found.alpha.from, -50 * degree, 1e-12);
    EXPECT_NEAR(found.alpha.to, 30 * degree, 1e-12);
    const RectangleBound bound = needs.over(R1Azimuth{0}, R1Azimuth{1e-9});
    const double beta = found.beta.to - found.beta.from;
    EXPECT_NEAR(bound.areas[0], (180 + 50) * degree * beta, 1e-7);
    EXPECT_NEAR(bound.areas[1], (180 + 30) * degree * beta, 1e-7);
}

// Intervals of all widths between neighbouring splits. No rectangle in them is below the
// bound.
TEST(RectangleNeeds, AreNowhereBelowTheBoundOfTheInterval)
{
    test::Random random{12};
    for (int i = 0; i < 300; ++i) {
        std::vector<Vec3> points = anywhere(random, 1 + i % 9);
        if (i % 5 == 0)
            points.push_back(-up);
        const RectangleNeeds needs{PolePoints{up, points}};
        std::vector<double> splits = needs.splits();
        splits.push_back(0);
        splits.push_back(pi);
        std::sort(splits.begin(), splits.end());
        for (std::size_t k = 1; k < splits.size(); ++k) {
            const double from = random.uniform(splits[k - 1], splits[k]);
            const double to = i % 2 == 0 ? splits[k] : from + 0.01 * (splits[k] - from);
            if (to - from < 1e-6)
                continue;
            const RectangleBound bound = needs.over(R1Azimuth{from}, R1Azimuth{to});
            for (int step = 0; step <= 50; ++step) {
                const R1Azimuth azimuth{from + (to - from) * step / 50};
                const RectangleExtents here =
                    needs.at(azimuth, R1Azimuth{(from + to) / 2});
                const bool is_open = needs.has_opposite();
                const double beta = here.beta.to - here.beta.from;
                const double plus = is_open ? pi : here.alpha.to;
                const double minus = is_open ? pi : -here.alpha.from;
                EXPECT_GE((plus - here.alpha.from) * beta, bound.areas[0] * (1 - 1e-12));
                EXPECT_GE((here.alpha.to + minus) * beta, bound.areas[1] * (1 - 1e-12));
                EXPECT_LE(here.alpha.from, bound.extents.alpha.from + 1e-12);
                EXPECT_GE(here.alpha.to, bound.extents.alpha.to - 1e-12);
                EXPECT_LE(here.beta.from, bound.extents.beta.from + 1e-12);
                EXPECT_GE(here.beta.to, bound.extents.beta.to - 1e-12);
            }
            EXPECT_GE(bound.areas[0], bound.extents.area() * (1 - 1e-12));
        }
    }
}

// With the convex alpha of a low direction and a sum of two betas that rise and fall, the
// gap of the bound falls to a quarter when the interval is halved.
TEST(RectangleNeeds, ConvergeWithTheSquareOfTheIntervalsWidth)
{
    const std::vector<Vec3> points =
        test::directions({{90, 120}, {200, 60}, {330, 50}, {10, 20}});
    const RectangleNeeds needs{PolePoints{up, points}};
    const auto lack = [&](double width) {
        const double from = 20 * degree;
        const RectangleBound bound = needs.over(R1Azimuth{from}, R1Azimuth{from + width});
        double least = 100;
        for (int step = 0; step <= 1000; ++step) {
            const R1Azimuth azimuth{from + width * step / 1000};
            least = std::min(least, needs.at(azimuth, azimuth).area());
        }
        return least - bound.areas[0];
    };
    const double wide = lack(0.04);
    const double narrow = lack(0.02);
    EXPECT_GT(wide, 0);
    EXPECT_NEAR(narrow / wide, 0.25, 0.1);
}

}  // namespace
}  // namespace endmill
