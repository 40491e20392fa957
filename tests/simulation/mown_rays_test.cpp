// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/mown_rays.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"
#include "tip_path.h"

namespace endmill {
namespace {

class MownRaysOf : public testing::TestWithParam<Cutter> {};

// The tree, the half spaces and the few rays that go ahead change nothing.
TEST_P(MownRaysOf, AreTheLeastOfEverySweepByItself)
{
    test::Random random{21};
    const auto uniform = [&](double size) {
        return Vec3{random.uniform(-size, size), random.uniform(-size, size),
                    random.uniform(-size, size)};
    };
    for (int round = 0; round < 60; ++round) {
        std::vector<Vec3> tips;
        for (int i = 0; i < 60; ++i)
            tips.push_back((i % 2 ? tips.back() : Vec3{uniform(12)}) + uniform(2));
        const std::vector<StraightSweep> sweeps =
            path_sweeps(test::tip_path(tips), GetParam());
        const SweepTree tree{sweeps};
        const Vec3 centre = uniform(8);
        Vec3 normal = uniform(1);
        normal.z() = std::abs(normal.z());
        std::vector<PartRay> rays;
        for (int i = 0; i < 40; ++i)
            rays.push_back({centre + uniform(0.5), (normal + uniform(0.1)).normalized(),
                            Vec3::Zero(), Vec3::Zero()});
        const std::vector<double> lengths(rays.size(), 15);
        MownRays mowing{rays, lengths};
        mowing.mow(tree);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            double least = 15;
            for (const StraightSweep& sweep : sweeps)
                if (const auto left = mown(sweep, rays[k]))
                    least = std::min(least, left->left);
            EXPECT_NEAR(mowing[static_cast<int>(k)].left, least, 1e-10);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(BallFlatBull, MownRaysOf,
                         testing::Values(Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}));

TEST(Mown, DoesNotCountWhatIsTakenOnAnotherSideOfThePart)
{
    const StraightSweep beyond{Cutter::ball(5), {-20, 0, -9}, {-20, 0, -9}};
    const PartRay wall{{0, 0, 0}, Vec3::UnitX(), Vec3::Zero(), Vec3::Zero()};
    EXPECT_FALSE(mown(beyond, wall));
    const StraightSweep through{Cutter::ball(5), {-4, 0, -9}, {-4, 0, -9}};
    ASSERT_TRUE(mown(through, wall));
    EXPECT_NEAR(mown(through, wall)->left, -9, 1e-12);
}

}  // namespace
}  // namespace endmill
