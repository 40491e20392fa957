// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/ray_bounds.h"

#include <vector>

#include <gtest/gtest.h>

#include "endmill/deviation/detail/cut_rays.h"
#include "random.h"

namespace endmill {
namespace {

std::vector<PartRay> rays_near(const Vec3& place, test::Random& random)
{
    const auto within = [&](double size) {
        return Vec3{random.uniform(-size, size), random.uniform(-size, size),
                    random.uniform(-size, size)};
    };
    std::vector<PartRay> rays;
    const Vec3 normal = within(1);
    for (int i = 0; i < 20; ++i)
        rays.push_back({place + within(1), (normal + within(0.3)).normalized(),
                        Vec3::Zero(), Vec3::Zero()});
    return rays;
}

// A half space that is reported out of reach contains no point of any ray.
TEST(RayBounds, ContainsAllRaysOfItsParts)
{
    test::Random random{41};
    int out_of_reach = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<PartRay> all;
        std::vector<RayBounds> bounds;
        for (int i = 0; i < 3; ++i) {
            const auto some = rays_near(
                {random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)},
                random);
            all.insert(all.end(), some.begin(), some.end());
            bounds.push_back(CutRays{some, std::vector<double>(some.size(), 2)}.bounds());
        }
        const RayBounds common = common_bounds(bounds);
        EXPECT_EQ(common.longest, 2);
        const Vec3 normal =
            Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}
                .normalized();
        const HalfSpace half{normal, random.uniform(0, 15)};
        if (!common.is_out_of_reach(half, 0.5, common.longest))
            continue;
        ++out_of_reach;
        for (const PartRay& ray : all)
            for (const double t : {0.0, 2.0})
                EXPECT_LE(normal.dot(ray.point + t * ray.normal) + 0.5,
                          half.least + 1e-12);
    }
    EXPECT_GT(out_of_reach, 50);
}

TEST(RayBounds, OfOneRayIsThatRayWithAMargin)
{
    const RayBounds one{{1, 2, 3}, {0, 0, 1}, 3, 4, 0.1, 6};
    const RayBounds common = common_bounds({&one, 1});
    EXPECT_EQ(common.centre, one.centre);
    EXPECT_EQ(common.upright, one.upright);
    EXPECT_EQ(common.beside, 5);
    EXPECT_EQ(common.above, 5);
    EXPECT_EQ(common.tilt, 0.1);
    EXPECT_EQ(common.longest, 6);
}

TEST(UnitOrUp, IsUpForAZeroVector)
{
    EXPECT_EQ(unit_or_up(Vec3::Zero()), Vec3::UnitZ());
    EXPECT_EQ(unit_or_up({0, -4, 0}), Vec3(0, -1, 0));
}

}  // namespace
}  // namespace endmill
