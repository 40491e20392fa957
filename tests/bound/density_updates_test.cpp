// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/density_updates.h"

#include <gtest/gtest.h>

#include "endmill/bound/detail/density_lattice.h"

namespace endmill {
namespace {

// Two cubes that share a face, with the area 1 in the middle of each.
DensityLattice two_cubes()
{
    const std::vector<Eigen::AlignedBox3d> boxes{{Vec3{0, 0, 0}, Vec3{0.5, 0.5, 0.5}},
                                                 {Vec3{1.1, 0, 0}, Vec3{1.5, 0.5, 0.5}}};
    DensityLattice lattice{boxes, 1};
    lattice.add_area({0.5, 0.5, 0.5}, 1);
    lattice.add_area({1.5, 0.5, 0.5}, 1);
    return lattice;
}

using Flows = std::vector<FlowAt<LatticePlace>>;

// A place that limits the density in the middle of a cube to 1 / flow.
Flows limit(const DensityLattice& lattice, double x, float flow)
{
    return {{*lattice.place({x, 0.5, 0.5}), flow, 0}};
}

TEST(UpdateDensity, LowersTheNodesOfACellThatExceedsOneAndRaisesOthers)
{
    const DensityLattice lattice = two_cubes();
    std::vector<double> density(lattice.nodes(), 1);
    const std::vector<Flows> places{limit(lattice, 0.5, 4), limit(lattice, 1.5, 0.0625F)};
    EXPECT_DOUBLE_EQ(update_density(lattice, places, density), 4);
    // the face in the middle belongs to the first cube too
    const auto at = [&](double x) {
        return lattice.value(density, *lattice.place({x, 0.5, 0.5}));
    };
    EXPECT_NEAR(at(0.001), 0.5, 1e-6);
    EXPECT_NEAR(at(1.999), 2, 0.01);
}

TEST(UpdateDensity, IsZeroWhereNoBoundaryComes)
{
    const DensityLattice lattice = two_cubes();
    std::vector<double> density(lattice.nodes(), 1);
    update_density(lattice, std::vector<Flows>{limit(lattice, 0.5, 1)}, density);
    EXPECT_NEAR(lattice.value(density, *lattice.place({1.999, 0.5, 0.5})), 0, 0.01);
}

// The best density of the linear program: each cube alone allows 1 / flow in its middle.
TEST(ImproveDensity, ComesNearTheOptimum)
{
    const DensityLattice lattice = two_cubes();
    std::vector<double> density(lattice.nodes(), 1);
    const std::vector<Flows> places{limit(lattice, 0.5, 2), limit(lattice, 1.5, 1)};
    improve_density(lattice, places, density, 200);
    double integral = 0;
    for (std::size_t node = 0; node < lattice.nodes(); ++node)
        integral += density[node] * lattice.weights()[node];
    EXPECT_LE(integral, 1.5 + 1e-9);
    EXPECT_GT(integral, 1.49);
}

}  // namespace
}  // namespace endmill
