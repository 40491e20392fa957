// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/mesh_density_search.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "test_meshes.h"

namespace endmill {
namespace {

TEST(MeshDensitySearch, OnWavesKeepsTheConditionAtFreshPlaces)
{
    const TriangleMesh mesh = test::grid_mesh(60, 60, [](int i, int j) {
        return Vec3{1.0 * i, 1.0 * j, 3 * std::sin(0.12 * i) * std::cos(0.1 * j)};
    });
    const BoundProblem problem = test::tip_problem();
    MeshDensitySearch search{mesh, problem, {3, 5000}};
    search.run();
    const std::vector<double> inflows = search.inflows_at_random(5000, 99);
    EXPECT_GT(inflows.size(), 4000U);
    EXPECT_LT(*std::ranges::max_element(inflows), 1.005);
}

// Where the ball pivots about a ridge its centre travels on an arc, and covers on both sides.
TEST(MeshDensitySearch, TriesTheNormalsOfARidge)
{
    const TriangleMesh roof = test::grid_mesh(20, 20, [](int i, int j) {
        return Vec3{2.0 * i, 2.0 * j, 20 - 0.8 * std::abs(2.0 * j - 20)};
    });
    const BoundProblem problem = test::tip_problem();
    MeshDensitySearch search{roof, problem, {3, 5000}};
    search.run();
    const std::vector<double> inflows = search.inflows_at_random(5000, 5);
    EXPECT_LT(*std::ranges::max_element(inflows), 1.01);
}

// The bottom of a V keeps more than half the scallop height: it has no weight.
TEST(MeshDensitySearch, LeavesOutWhatTheBallDoesNotReach)
{
    const auto groove = [](double slope) {
        return test::grid_mesh(20, 40, [slope](int i, int j) {
            return Vec3{2.0 * i, 1.0 * j, slope * std::abs(j - 20.0)};
        });
    };
    const auto integral_of = [](const TriangleMesh& mesh) {
        const BoundProblem problem = test::tip_problem();
        MeshDensitySearch search{mesh, problem, {1.5, 1000}};
        return search.run().integral;
    };
    // The sides have 28.3 mm each in place of 20. The ball touches both 7.5 mm from the bottom,
    // and rolling down one side it covers a disc of 2.7 mm radius on the other at once. So there
    // the density is 0, and each side counts from 10.2 mm on, or one spacing farther.
    const double flat = integral_of(groove(0));
    const double deep = integral_of(groove(1));
    EXPECT_LT(deep, 18.1 / 20 * flat);
    EXPECT_GT(deep, 16.6 / 20 * flat);
}

}  // namespace
}  // namespace endmill
