// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/parallel.h"
#include "endmill/setup/clamping.h"
#include "endmill/setup/detail/sampled_poses.h"
#include "plane_part.h"

namespace endmill {
namespace {

// A machine, its sampled poses and the search for clamping positions.
struct Example {
    Example(const char* word, const LinearLimits& limits)
    {
        machine = test::machine_of(word);
        machine.pivot = 50;
        machine.linear = limits;
        reach = {machine.configuration, machine.rotary};
        poses = sampled_poses(plane.grid, plane.visibility, {reach});
    }

    ClampingSearch search() const
    {
        return {plane.mesh, plane.visibility,    plane.grid.centres,
                machine,    reach_limits(reach), 0};
    }

    test::PlanePart plane{60};
    Machine machine;
    RotaryReach reach;
    std::vector<FittedPose> poses;
};

constexpr LinearLimits narrow{LinearRange{0, 45}, {0, 92}, {0, 200}};
constexpr LinearLimits too_narrow{LinearRange{0, 20}, {0, 45}, {0, 30}};

TEST(TravelSearch, FindsTheFirstPoseThatFits)
{
    for (const char* word : {"W/xyBzca/T", "W/xyBzab/T", "W/xyBz/T"}) {
        const Example example{word, narrow};
        const ClampingSearch search = example.search();
        const TravelSearch found = travel_search(search, example.poses, std::nullopt);
        ASSERT_TRUE(found.fits()) << word;
        ASSERT_LE(found.poses, example.poses.size());
        for (std::size_t k = 0; k < found.poses; ++k) {
            const auto bounds = search.bounds(example.poses[k].pose);
            const bool fits = bounds && greatest_slack(*bounds) >= -travel_rounding;
            EXPECT_EQ(fits, k + 1 == found.poses) << word << k;
        }
        EXPECT_TRUE(is_same_pose(found.pose->pose, example.poses[found.poses - 1].pose));
    }
}

TEST(TravelSearch, ShowsTheNearestPoseWhereNoneFits)
{
    const Example example{"W/xyBz/T", too_narrow};
    const ClampingSearch search = example.search();
    const TravelSearch found = travel_search(search, example.poses, std::nullopt);
    EXPECT_FALSE(found.fits());
    EXPECT_EQ(found.poses, example.poses.size());
    double greatest = -std::numeric_limits<double>::infinity();
    for (const FittedPose& fit : example.poses)
        greatest = std::max(greatest, greatest_slack(*search.bounds(fit.pose)));
    EXPECT_NEAR(found.clamping->least_slack(), greatest, 1e-6);
    EXPECT_NEAR(greatest_slack(*search.bounds(found.pose->pose)), greatest, 1e-9);
}

TEST(TravelSearch, IsTheSameWithAnyNumberOfThreads)
{
    const Example example{"W/xyBzca/T", narrow};
    const TravelSearch one = travel_search(example.search(), example.poses, std::nullopt);
    for (const int threads : {1, 3, 8}) {
        set_thread_count(threads);
        const TravelSearch other =
            travel_search(example.search(), example.poses, std::nullopt);
        EXPECT_EQ(other.poses, one.poses);
        EXPECT_EQ(other.clamping->clamp, one.clamping->clamp);
    }
}

TEST(TravelSearch, CountsPosesOutOfReach)
{
    const Example example{"W/xyBz/T", narrow};
    FittedPose beside = example.poses.front();
    beside.pose = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    const TravelSearch found =
        travel_search(example.search(), {&beside, 1}, std::nullopt);
    EXPECT_EQ(found.poses, 1U);
    EXPECT_EQ(found.out_of_reach, 1U);
    EXPECT_FALSE(found.pose);
    EXPECT_FALSE(found.fits());
}

}  // namespace
}  // namespace endmill
