// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/corner_entry.h"
#include "endmill/cutter/detail/sweep_entry.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Vec3 random_vector(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

// The second route is S itself, which is computed without half spaces: the entry is on S,
// and no earlier place is in the region. Nearly all rising lines are decided.
TEST(CornerApproach, EndsWhereTheHeightIsThatOfTheLine)
{
    test::Random random{23};
    int rising = 0;
    int known = 0;
    int found = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 from = random_vector(random, 5);
        const StraightSweep sweep{Cutter{5, i % 3 == 0 ? 0.3 : 2.0}, from,
                                  from + random_vector(random, i % 2 ? 0.3 : 8)};
        Line line{random_vector(random, 9), random_vector(random, 1).normalized()};
        line.direction.z() = std::abs(line.direction.z());
        const CornerApproach approach = corner_approach(sweep, line, infinite);
        ++rising;
        if (approach.enters == Answer::Undecided)
            continue;
        EXPECT_EQ(approach.enters == Answer::Yes, approach.entry.has_value());
        ++known;
        const double end = approach.entry ? approach.entry->t - 1e-7 : 30;
        for (double t = -30; t < end; t += 0.1)
            EXPECT_FALSE(clears(sweep, line.origin + t * line.direction))
                << i << " " << t;
        if (!approach.entry)
            continue;
        const Vec3& normal = approach.entry->normal;
        EXPECT_NEAR(normal.norm(), 1, 1e-12) << i;
        EXPECT_LE(normal.z(), 0) << i;
        EXPECT_LT(normal.dot(line.direction), 0) << i;
        if (normal.z() > -0.1)  // S is steep at the side
            continue;
        const Vec3 at = line.origin + approach.entry->t * line.direction;
        EXPECT_NEAR(sweep.height(at.x(), at.y()), at.z(), 1e-11) << i;
        ++found;
    }
    EXPECT_GT(known, 0.97 * rising);
    EXPECT_GT(found, 500);
}

// The region is symmetric to the vertical plane through the move.
TEST(CornerApproach, IsTheSameOnBothSidesOfTheMove)
{
    const StraightSweep sweep{Cutter{5, 2}, {1, 0, 0}, {4, 0, 1}};
    const auto left =
        corner_approach(sweep, {{2, 3.8, -4}, Vec3{0.1, -0.2, 1}.normalized()}, infinite);
    const auto right =
        corner_approach(sweep, {{2, -3.8, -4}, Vec3{0.1, 0.2, 1}.normalized()}, infinite);
    ASSERT_TRUE(left.entry && right.entry);
    EXPECT_NEAR(left.entry->t, right.entry->t, 1e-13);
    EXPECT_NEAR(left.entry->normal.y(), -right.entry->normal.y(), 1e-12);
}

TEST(CornerApproach, OfAMoveOfNoLengthIsToTheCutter)
{
    const StraightSweep still{Cutter{5, 2}, {0, 0, 0}, {0, 0, 0}};
    for (const double before : {infinite, 40.0, 9.3}) {
        const auto corner = corner_approach(still, {{4, 0, -9}, Vec3::UnitZ()}, before);
        ASSERT_TRUE(corner.entry) << before;
        EXPECT_NEAR(corner.entry->t, 9 + 2 - std::sqrt(3.0), 1e-13);
        const auto bottom = corner_approach(still, {{1, 1, -9}, Vec3::UnitZ()}, before);
        ASSERT_TRUE(bottom.entry) << before;
        EXPECT_NEAR(bottom.entry->t, 9, 1e-14);
        EXPECT_EQ(bottom.entry->normal, -Vec3::UnitZ());
    }
}

TEST(CornerApproach, IsNoneWhereTheEntryComesLater)
{
    const StraightSweep level{Cutter{5, 2}, {0, 0, 0}, {20, 0, 0}};
    const auto later = corner_approach(level, {{10, 0, -9}, Vec3::UnitZ()}, 8.999);
    EXPECT_EQ(later.enters, Answer::No);
    EXPECT_FALSE(later.entry);
    const auto beside = corner_approach(level, {{10, 5.1, -9}, Vec3::UnitZ()}, infinite);
    EXPECT_NE(beside.enters, Answer::Yes);
}

// A search from outside cannot decide a line that comes from above.
TEST(CornerApproach, OfALineStraightDownIsUndecided)
{
    const StraightSweep level{Cutter{5, 2}, {0, 0, 0}, {20, 0, 0}};
    EXPECT_EQ(corner_approach(level, {{10, 0, 9}, -Vec3::UnitZ()}, infinite).enters,
              Answer::Undecided);
}

}  // namespace
}  // namespace endmill
