// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/drop_kinks.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "offset_parts.h"

namespace endmill {
namespace {

constexpr double p = 4;       // mm, of the trough z = x^2 / (2 p) + y tan(beta)
constexpr double radius = 7;  // mm, of the ball
constexpr double beta = 25 * std::numbers::pi / 180;

const DriveFrame along_x{Angle::degrees(0)};

DropRest rest_at(const SmoothDrop& drop, const DriveLine& line, const PartPlace& start,
                 double s)
{
    FinerPieces finer;
    const auto known = drop.climb(start, line.axis(s));
    return {s, drop.highest(*known, line.axis(s), finer)};
}

TEST(DropKinks, IsTheCrossingOfTheInclinedTrough)
{
    const test::Polynomial height =
        test::monomial(2, 0, 1 / (2 * p)) + test::monomial(0, 1, std::tan(beta));
    const std::vector<Surface> part{test::graph(height, {{-20, 21}, {-15, 16}}, {3, 2})};
    const SmoothDrop drop{part, Cutter::ball(radius)};
    const DriveLine line{along_x, 0};
    // Closed form A3 of docs/methods/interference.md, section 11.
    const double expected =
        radius * radius / (2 * p) + p / (2 * std::cos(beta) * std::cos(beta));
    for (const double beside : {0.01, 1.0, 6.0}) {
        const DropRest low = rest_at(drop, line, {0, {0.2, 1}}, -beside);
        const DropRest high = rest_at(drop, line, {0, {2.8, 1}}, 0.7 * beside);
        FinerPieces finer;
        const auto kinks = kinks_between(drop, line, low, high, finer);
        ASSERT_EQ(kinks.size(), 1U);
        EXPECT_NEAR(kinks[0].s, 0, 1e-9);
        EXPECT_NEAR(kinks[0].contact.on.height, expected, 1e-9);
    }
}

TEST(DropKinks, AreNoneWhereTheContactChangesSmoothly)
{
    // Over a ridge, from one side to the crease and down the other side.
    const std::vector<Surface> ridge{test::valley(10, 20, -0.5)};
    for (const Cutter& cutter : {Cutter::ball(4), Cutter{4, 1}, Cutter::flat(4)}) {
        const SmoothDrop drop{ridge, cutter};
        const DriveLine line{along_x, 10};
        const DropRest low = rest_at(drop, line, {0, {0.9, 0.5}}, -1.5);
        const DropRest high = rest_at(drop, line, {0, {1.1, 0.5}}, 1.2);
        FinerPieces finer;
        EXPECT_TRUE(kinks_between(drop, line, low, high, finer).empty());
    }
}

TEST(DropKinks, LieOnBothSidesOfAThirdContact)
{
    // Walls at x = -6 and x = 6, and a mound between them that the ball touches as well.
    // By symmetry in y the section consists of circles about (+-6, 5) and (0, 0).
    const auto line_up = [](double x0, double z0, double x1, double z1) {
        std::vector<Vec3> net;
        for (const double y : {-10.0, 10.0}) {
            net.emplace_back(x0, y, z0);
            net.emplace_back(x1, y, z1);
        }
        return Surface{{0, 1}, {0, 1}, {BezierPatch{1, 1, net}}};
    };
    const std::vector<Surface> part{line_up(-8, 5, -6, 5), line_up(-1e-9, 4, 1e-9, 4),
                                    line_up(6, 5, 8, 5)};
    const SmoothDrop drop{part, Cutter::ball(8)};
    const DriveLine line{along_x, 0};
    const DropRest low = rest_at(drop, line, {0, {0.5, 0.5}}, -6);
    const DropRest high = rest_at(drop, line, {2, {0.5, 0.5}}, 6);
    FinerPieces finer;
    const auto kinks = kinks_between(drop, line, low, high, finer);
    ASSERT_EQ(kinks.size(), 2U);
    for (const DropRest& kink : kinks) {
        // Equally far from the edge of the wall and from that of the mound.
        const double x = std::abs(kink.s);
        const double z = kink.contact.on.height;
        EXPECT_NEAR(std::hypot(x, z - 4), 8, 1e-7);
        EXPECT_NEAR(std::hypot(6 - x, z - 5), 8, 1e-7);
    }
    EXPECT_LT(kinks[0].s, 0);
    EXPECT_GT(kinks[1].s, 0);
}

}  // namespace
}  // namespace endmill
