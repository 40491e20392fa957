// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/reach.h"

#include <vector>

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

// Different instructions give the same bits as the sweeps one by one.
TEST(SweepRows, HaveTheGapsOfTheirSweeps)
{
    test::Random random{3};
    const auto place = [&] {
        return Vec3{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
    };
    SweepRows rows;
    for (std::size_t count = 0; count < 80; ++count) {
        std::vector<UprightSweep> sweeps;
        rows.clear();
        for (std::size_t k = 0; k < count; ++k) {
            const Vec3 from = place();
            Vec3 to = place();
            if (k % 3 == 0)
                to.head<2>() = from.head<2>();  // upright
            sweeps.emplace_back(from, k % 7 == 0 ? from : to);
            rows.add(sweeps.back());
        }
        ASSERT_EQ(rows.size(), count);
        std::vector<double> gaps(count);
        for (int trial = 0; trial < 50; ++trial) {
            const Vec3 point = place();
            rows.gaps_at(point, 4, gaps);
            for (std::size_t k = 0; k < count; ++k)
                EXPECT_EQ(gaps[k], beyond_reach(sweeps[k].squared_distance(point), 4));
        }
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
