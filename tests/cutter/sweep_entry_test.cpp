// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/sweep_entry.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"

namespace endmill {
namespace {

Vec3 random_vector(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

class SweepEntryOf : public testing::TestWithParam<Cutter> {};

// The region is convex. So an entry is right if a place just before it is outside and one
// just after it inside; and a line without an entry has no place inside.
TEST_P(SweepEntryOf, IsWhereTheHeightIsCrossedFromOutside)
{
    test::Random random{11};
    constexpr double step = 1e-7;
    int entries = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 from = random_vector(random, 5);
        Vec3 move = random_vector(random, 8);
        if (i % 5 == 1)
            move.z() = 0;
        if (i % 5 == 2)
            move = Vec3{0, 0, -3};
        if (i % 5 == 3)
            move *= 1e-3;
        const StraightSweep sweep{GetParam(), from, from + move};
        Line line{random_vector(random, 9), random_vector(random, 1).normalized()};
        if (i % 7 == 0)
            line.direction = Vec3::UnitZ();
        if (i % 7 == 1)
            line.direction = Vec3{0.6, 0.8, 0};
        const auto entry = sweep_entry(sweep, line);
        const auto inside = [&](double t) {
            return clears(sweep, line.origin + t * line.direction);
        };
        if (!entry) {
            for (int k = -300; k <= 300; ++k)
                EXPECT_FALSE(inside(0.1 * k)) << i << " " << 0.1 * k;
            continue;
        }
        ++entries;
        ASSERT_TRUE(std::isfinite(entry->t)) << i;
        EXPECT_FALSE(inside(entry->t - step)) << i;
        // A line that grazes the region leaves it again within a step.
        if (entry->normal.dot(line.direction) < -1e-2) {
            EXPECT_TRUE(inside(entry->t + step)) << i;
        }
        EXPECT_NEAR(entry->normal.norm(), 1, 1e-9) << i;
        EXPECT_LE(entry->normal.dot(line.direction), 1e-6) << i;
        EXPECT_LE(entry->normal.z(), 1e-12) << i;
    }
    EXPECT_GT(entries, 1000);
}

INSTANTIATE_TEST_SUITE_P(BallFlatBull, SweepEntryOf,
                         testing::Values(Cutter::ball(5), Cutter::flat(5), Cutter{5, 2},
                                         Cutter{5, 0.05}, Cutter{5, 4.9}));

TEST(SweepEntry, IntoABallIsAtItsSurface)
{
    const StraightSweep still{Cutter::ball(5), {0, 0, 0}, {0, 0, 0}};
    const auto entry = sweep_entry(still, {{3, 0, -20}, Vec3::UnitZ()});
    ASSERT_TRUE(entry);
    EXPECT_NEAR(entry->t, 21, 1e-14 * 21);
    EXPECT_LT((entry->normal - Vec3{0.6, 0, -0.8}).norm(), 1e-14);
}

TEST(SweepEntry, IntoTheShankIsAtItsSide)
{
    for (const Cutter& cutter : {Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}}) {
        const StraightSweep level{cutter, {0, 0, 0}, {10, 0, 0}};
        const auto entry = sweep_entry(level, {{5, -9, 8}, Vec3::UnitY()});
        ASSERT_TRUE(entry);
        EXPECT_NEAR(entry->t, 4, 1e-13);
        EXPECT_LT((entry->normal + Vec3::UnitY()).norm(), 1e-13);
    }
}

TEST(SweepEntry, OfALineStraightDownIsFromInside)
{
    for (const Cutter& cutter : {Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}}) {
        const StraightSweep level{cutter, {0, 0, 0}, {10, 0, 0}};
        const auto entry = sweep_entry(level, {{5, 0, 8}, -Vec3::UnitZ()});
        ASSERT_TRUE(entry);
        EXPECT_EQ(entry->t, -std::numeric_limits<double>::infinity());
    }
}

TEST(SweepEntry, IsEmptyForALineThatMisses)
{
    for (const Cutter& cutter : {Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}}) {
        const StraightSweep level{cutter, {0, 0, 0}, {10, 0, 0}};
        EXPECT_FALSE(sweep_entry(level, {{5, 5.001, 0}, Vec3::UnitZ()}));
        EXPECT_FALSE(sweep_entry(level, {{5, 0, -1e-9}, Vec3::UnitX()}));
    }
}

}  // namespace
}  // namespace endmill
