// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/density_lattice.h"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

constexpr double spacing = 0.7;

// Boxes along a diagonal.
std::vector<Eigen::AlignedBox3d> bar()
{
    std::vector<Eigen::AlignedBox3d> boxes;
    for (int k = 0; k < 20; ++k) {
        const Vec3 low = Vec3::Constant(-3 + 0.4 * k);
        boxes.emplace_back(low, low + Vec3{0.4, 0.5, 0.6});
    }
    return boxes;
}

// A random point of a box.
Vec3 random_point(const Eigen::AlignedBox3d& box, test::Random& random)
{
    const double x = random.uniform(box.min().x(), box.max().x());
    const double y = random.uniform(box.min().y(), box.max().y());
    return {x, y, random.uniform(box.min().z(), box.max().z())};
}

std::vector<double> random_values(const DensityLattice& lattice, test::Random& random)
{
    std::vector<double> values(lattice.nodes());
    for (double& value : values)
        value = random.uniform(0, 1);
    return values;
}

TEST(DensityLattice, IsContinuousAcrossCells)
{
    const DensityLattice lattice{bar(), spacing};
    test::Random random{1};
    const std::vector<double> values = random_values(lattice, random);
    int crossings = 0;
    for (const Eigen::AlignedBox3d& box : bar())
        for (int k = 0; k < 400; ++k) {
            const Vec3 point = random_point(box, random);
            // the next cell along x begins here
            const auto at = lattice.place(point);
            ASSERT_TRUE(at);
            const Vec3 border = point + spacing * (1 - double{at->x}) * Vec3::UnitX();
            const auto before = lattice.place(border - 1e-6 * Vec3::UnitX());
            const auto behind = lattice.place(border + 1e-6 * Vec3::UnitX());
            if (!before || !behind)
                continue;
            ++crossings;
            EXPECT_NE(before->node, behind->node);
            EXPECT_NEAR(lattice.value(values, *before), lattice.value(values, *behind),
                        1e-5);
        }
    EXPECT_GT(crossings, 100);
}

TEST(DensityLattice, IsLinearAlongEachAxisInACell)
{
    const DensityLattice lattice{bar(), spacing};
    test::Random random{2};
    const std::vector<double> values = random_values(lattice, random);
    for (const LatticeCell& cell : lattice.cells()) {
        const auto value = [&](float x, float y, float z) {
            return lattice.value(values, {cell.node, x, y, z});
        };
        EXPECT_NEAR(value(0.5F, 0.2F, 0.7F),
                    (value(0, 0.2F, 0.7F) + value(1, 0.2F, 0.7F)) / 2, 1e-6);
        EXPECT_NEAR(value(0.3F, 0.5F, 0.7F),
                    (value(0.3F, 0, 0.7F) + value(0.3F, 1, 0.7F)) / 2, 1e-6);
        EXPECT_NEAR(value(0.3F, 0.2F, 0.5F),
                    (value(0.3F, 0.2F, 0) + value(0.3F, 0.2F, 1)) / 2, 1e-6);
        EXPECT_EQ(value(1, 0, 0), values[lattice.corners(cell.node)[1]]);
        EXPECT_EQ(value(0, 1, 0), values[lattice.corners(cell.node)[2]]);
        EXPECT_EQ(value(0, 0, 1), values[lattice.corners(cell.node)[4]]);
    }
}

TEST(DensityLattice, WeightsAreTheIntegralsOfTheHats)
{
    DensityLattice lattice{bar(), spacing};
    test::Random random{3};
    const std::vector<double> values = random_values(lattice, random);
    double area = 0;
    double integral = 0;
    for (const Eigen::AlignedBox3d& box : bar()) {
        const Vec3 point = random_point(box, random);
        const double piece = random.uniform(1, 2);
        lattice.add_area(point, piece);
        area += piece;
        integral += piece * lattice.value(values, *lattice.place(point));
    }
    const std::vector<double>& weights = lattice.weights();
    EXPECT_NEAR(std::reduce(weights.begin(), weights.end()), area, 1e-9);
    EXPECT_NEAR(std::inner_product(weights.begin(), weights.end(), values.begin(), 0.0),
                integral, 1e-9);
}

TEST(DensityLattice, HasNoPlaceBesideTheBoxes)
{
    const DensityLattice lattice{bar(), spacing};
    EXPECT_FALSE(lattice.place({-3, 4, -3}));
    EXPECT_FALSE(lattice.place({100, 100, 100}));
    const DensityLattice empty{{}, spacing};
    EXPECT_EQ(empty.nodes(), 0U);
    EXPECT_FALSE(empty.place({0, 0, 0}));
}

}  // namespace
}  // namespace endmill
