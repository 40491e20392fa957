// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/reach.h"

#include <gtest/gtest.h>

#include "endmill/gouge/detail/swept_axis.h"
#include "random.h"

namespace endmill {
namespace {

// The general axis of module gouge is the second route.
TEST(UprightSweep, HasTheDistanceOfTheSweptAxis)
{
    test::Random random{1};
    for (int trial = 0; trial < 20000; ++trial) {
        const Vec3 from{random.uniform(-5, 5), random.uniform(-5, 5),
                        random.uniform(-5, 5)};
        Vec3 to{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
        if (trial % 3 == 0)
            to.head<2>() = from.head<2>();  // upright
        if (trial % 7 == 0)
            to = from;  // at rest
        const Vec3 point{random.uniform(-9, 9), random.uniform(-9, 9),
                         random.uniform(-9, 9)};
        const Vec3 nearest = SweptAxis{from, to, Vec3::UnitZ()}.nearest(point);
        const double squared = UprightSweep{from, to}.squared_distance(point);
        EXPECT_NEAR(std::sqrt(squared), (nearest - point).norm(), 1e-9);
    }
}

TEST(BeyondReach, IsTheDistanceToFirstOrder)
{
    for (const double beyond : {-1e-4, 1e-4})
        EXPECT_NEAR(beyond_reach((5 + beyond) * (5 + beyond), 5), beyond, 1e-8);
}

TEST(PointReach, IsThatOfASweepAtRest)
{
    test::Random random{2};
    for (int trial = 0; trial < 1000; ++trial) {
        const Vec3 centre{random.uniform(-5, 5), random.uniform(-5, 5),
                          random.uniform(-5, 5)};
        const Vec3 point{random.uniform(-9, 9), random.uniform(-9, 9),
                         random.uniform(-9, 9)};
        EXPECT_NEAR(point_reach(centre, point, 5),
                    beyond_reach(UprightSweep{centre, centre}.squared_distance(point), 5),
                    1e-12);
    }
}

}  // namespace
}  // namespace endmill
