// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/inflow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "random.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

class InflowOnAPlane : public testing::Test {
protected:
    const test::SidedSurfaces surfaces{{test::plane(10, 10)}};
    const DensityGrid grid{surfaces.part(), 2};
    const std::vector<double> one = std::vector<double>(grid.nodes(), 1);
};

double by_directions(const std::vector<BoundaryFlow>& flows, int directions)
{
    double greatest = 0;
    for (int k = 0; k < directions; ++k) {
        const double angle = 2 * std::numbers::pi * k / directions;
        double sum = 0;
        for (const BoundaryFlow& piece : flows)
            sum += std::max(
                0.0, piece.flow.dot(Eigen::Vector2d{std::cos(angle), std::sin(angle)}));
        greatest = std::max(greatest, sum);
    }
    return greatest;
}

TEST_F(InflowOnAPlane, IsTheMaximumOverAllDirections)
{
    test::Random random{7};
    for (const std::size_t count : {1U, 2U, 3U, 10U, 72U}) {
        std::vector<BoundaryFlow> flows;
        for (std::size_t k = 0; k < count; ++k) {
            const double x = random.uniform(-1, 1);
            flows.push_back({0, {0.3, 0.4}, {x, random.uniform(-1, 1)}});
        }
        const double exact = greatest_inflow(stored_flows(flows, grid), grid, one);
        const double sampled = by_directions(flows, 3600);
        EXPECT_LE(sampled, exact * (1 + 1e-6));
        EXPECT_GE(sampled, exact * std::cos(std::numbers::pi / 3600) * (1 - 1e-6));
    }
}

TEST_F(InflowOnAPlane, OfOppositeFlowsIsTheLongerOne)
{
    const std::vector<BoundaryFlow> flows{
        {0, {0.5, 0.5}, {2, 0}}, {0, {0.5, 0.5}, {-3, 0}}, {0, {0.5, 0.5}, {0, 0}}};
    EXPECT_NEAR(greatest_inflow(stored_flows(flows, grid), grid, one), 3, 1e-6);
    EXPECT_EQ(greatest_inflow(std::vector<StoredFlow>{}, grid, one), 0);
}

TEST_F(InflowOnAPlane, WeighsEachFlowByTheDensityThere)
{
    std::vector<double> density(grid.nodes());
    for (const DensityCell& cell : grid.cells())
        for (const auto& [corner, u] :
             {std::pair{0, cell.u.low}, std::pair{1, cell.u.high},
              std::pair{2, cell.u.low}, std::pair{3, cell.u.high}})
            density[grid.corners(cell.node)[corner]] = u;
    const std::vector<BoundaryFlow> flows{{0, {0.25, 0.5}, {4, 0}},
                                          {0, {0.75, 0.5}, {4, 0}}};
    EXPECT_NEAR(greatest_inflow(stored_flows(flows, grid), grid, density), 1 + 3, 1e-6);
}

}  // namespace
}  // namespace endmill
