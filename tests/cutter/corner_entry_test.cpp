// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/corner_entry.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The limit `before` decides only whether the entry is reported.
TEST(CornerEntry, WithinALengthIsTheEntryOrEmpty)
{
    test::Random random{41};
    const auto uniform = [&](double size) {
        return Vec3{random.uniform(-size, size), random.uniform(-size, size),
                    random.uniform(-size, size)};
    };
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 from = uniform(5);
        const StraightSweep sweep{Cutter{5, 2}, from, from + uniform(i % 2 ? 0.3 : 6)};
        const Line line{uniform(9), uniform(1).normalized()};
        const auto entry = corner_entry(sweep, line, infinite);
        for (const double before : {-3.0, 0.0, 0.1, 4.0}) {
            const auto sooner = corner_entry(sweep, line, before);
            if (!entry || entry->t >= before + 1e-12) {
                EXPECT_FALSE(sooner) << i << " " << before;
            } else if (entry->t < before - 1e-12) {
                ASSERT_TRUE(sooner) << i << " " << before;
                // Where the line grazes the region, its entry is less accurate.
                const double graze = std::abs(entry->normal.dot(line.direction));
                EXPECT_NEAR(sooner->t, entry->t, 1e-11 / std::max(graze, 1e-6)) << i;
                ++found;
            }
        }
    }
    EXPECT_GT(found, 500);
}

TEST(CornerEntry, IntoTheCornerIsOnItsCircle)
{
    const StraightSweep level{Cutter{5, 2}, {0, 0, 0}, {20, 0, 0}};
    const auto entry = corner_entry(level, {{10, 4, -9}, Vec3::UnitZ()}, infinite);
    ASSERT_TRUE(entry);
    EXPECT_NEAR(entry->t, 9 + 2 - std::sqrt(3.0), 1e-13);
    EXPECT_LT((entry->normal - Vec3{0, 0.5, -std::sqrt(0.75)}).norm(), 1e-13);
}

}  // namespace
}  // namespace endmill
