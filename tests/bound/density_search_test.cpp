// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/density_search.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "bound_surfaces.h"

namespace endmill {
namespace {

// The density of the ball on the default net keeps its condition at places that the
// search has not seen, and its integral is that of an independent program with another grid.
TEST(DensitySearch, OnTheNetKeepsTheConditionAtFreshPlaces)
{
    const test::SidedSurfaces net = test::dataset("net_rot24_7D");
    const BoundedPart part = net.part();
    BoundProblem problem = test::usual_problem();
    problem.tool = CoveringTool::Ball;
    DensitySearch search{part, problem, {3.8, 20000}};
    const FoundDensity found = search.run();
    EXPECT_NEAR(found.integral, 10317, 0.005 * 10317);
    EXPECT_LT(found.greatest_inflow, 1.005);
    const std::vector<double> inflows =
        search.inflows_at_random(found.at_nodes, 20000, 99);
    EXPECT_LT(*std::ranges::max_element(inflows), 1.005);
    // The condition is tight nearly everywhere, else the bound could be larger.
    std::vector<double> sorted = inflows;
    std::ranges::sort(sorted);
    EXPECT_GT(sorted[sorted.size() / 4], 0.97);
}

TEST(DensitySearch, ReportsProgressFromZeroToOne)
{
    const test::SidedSurfaces part = test::dataset("sphere");
    const BoundedPart bounded = part.part();
    const BoundProblem problem = test::usual_problem();
    std::vector<double> shares;
    DensitySearch search{
        bounded, problem, {6, 1000, [&](double share) { shares.push_back(share); }}};
    search.run();
    EXPECT_EQ(shares.front(), 0);
    EXPECT_EQ(shares.back(), 1);
    EXPECT_TRUE(std::ranges::is_sorted(shares));
}

}  // namespace
}  // namespace endmill
