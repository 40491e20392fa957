// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/cell_circles.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/visibility/sphere_grid.h"
#include "random_maps.h"

namespace endmill {
namespace {

TEST(CellCircles, PassThroughTwoCellsAndCoverEveryPair)
{
    test::Random random{7};
    const SphereGrid grid = sphere_grid("hex:4");
    for (int k = 0; k < 20; ++k) {
        const Vec3 middle = test::random_direction(random);
        const double radius = 0.05;
        const auto normals = cell_circles(grid.centres, middle, radius, 10000);
        for (const Vec3& normal : normals) {
            EXPECT_LE((normal - middle).norm(), radius + 1e-12);
            int cells = 0;
            for (const Vec3& centre : grid.centres)
                cells += std::abs(centre.dot(normal)) < 1e-12 ? 1 : 0;
            EXPECT_GE(cells, 2);
        }
        for (const Vec3& a : grid.centres)
            for (const Vec3& b : grid.centres) {
                const Vec3 product = a.cross(b);
                if (product.norm() < 1e-6 ||
                    (product.normalized() - middle).norm() > radius)
                    continue;
                int known = 0;
                for (const Vec3& normal : normals)
                    known += (product.normalized() - normal).norm() < 1e-9 ? 1 : 0;
                EXPECT_EQ(known, 1);
            }
    }
}

TEST(CellCircles, ListTheCircleOfManyCellsOnceAndNoneOfOppositeCells)
{
    const std::vector<Vec3> square{Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitX(),
                                   -Vec3::UnitY()};
    const auto normals = cell_circles(square, Vec3::UnitZ(), 0.1, 1);
    ASSERT_EQ(normals.size(), 1U);
    EXPECT_EQ(normals[0], Vec3::UnitZ());
    const std::vector<Vec3> opposite{Vec3::UnitX(), -Vec3::UnitX()};
    EXPECT_TRUE(cell_circles(opposite, Vec3::UnitZ(), 0.1, 1).empty());
}

TEST(CellCircles, AreLeftOutIfThereAreTooMany)
{
    const SphereGrid grid = sphere_grid("hex:4");
    const Vec3 middle = Vec3{0.3, 0.5, 0.8}.normalized();
    const std::size_t all = cell_circles(grid.centres, middle, 0.1, 100000).size();
    ASSERT_GT(all, 1U);
    EXPECT_EQ(cell_circles(grid.centres, middle, 0.1, all).size(), all);
    EXPECT_TRUE(cell_circles(grid.centres, middle, 0.1, all - 1).empty());
}

}  // namespace
}  // namespace endmill
