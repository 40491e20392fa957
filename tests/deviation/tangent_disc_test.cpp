// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/tangent_disc.h"

#include <array>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"

namespace endmill {
namespace {

Vec3 somewhere(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

TEST(TangentDisc, DistancesOfAFlatCylinder)
{
    const TangentDisc disc{{1, 2, 3}, Vec3::UnitZ(), 2, 0.5};
    EXPECT_EQ(disc.squared_distance({1, 3, 3.25}), 0);
    EXPECT_EQ(disc.squared_distance({2, 2, 5.5}), 4);
    EXPECT_EQ(disc.squared_distance({1, -4, 3}), 16);
    EXPECT_EQ(disc.squared_distance({8, 2, -1.5}), 25 + 16);
}

TEST(TangentDisc, IsNoFurtherThanItsContents)
{
    test::Random random{1};
    for (int i = 0; i < 200; ++i) {
        const std::array<Vec3, 4> corners{somewhere(random, 1), somewhere(random, 1),
                                          somewhere(random, 1), somewhere(random, 1)};
        TangentDisc disc = tangent_disc(corners);
        for (const Vec3& corner : corners)
            disc = disc.including(corner);
        disc = disc.expanded(1e-14);
        for (int k = 0; k < 20; ++k) {
            const double s = random.uniform(0, 1);
            const double t = random.uniform(0, 1);
            const Vec3 held = (1 - s) * ((1 - t) * corners[0] + t * corners[1]) +
                              s * ((1 - t) * corners[3] + t * corners[2]);
            EXPECT_EQ(disc.squared_distance(held), 0);
            const Vec3 place = somewhere(random, 4);
            EXPECT_LE(disc.squared_distance(place), (place - held).squaredNorm());
        }
    }
}

TEST(TangentDisc, OfCornersInAPlaneLiesInIt)
{
    const std::array<Vec3, 4> corners{Vec3{0, 0, 1}, Vec3{2, 0, 1}, Vec3{2, 4, 1},
                                      Vec3{0, 4, 1}};
    const TangentDisc disc = tangent_disc(corners);
    EXPECT_EQ(disc.centre, (Vec3{1, 2, 1}));
    EXPECT_EQ(disc.normal, Vec3::UnitZ());
    EXPECT_EQ(disc.radius, 0);
    EXPECT_EQ(disc.half_thickness, 0);
}

TEST(TangentDisc, OfOnePointHasANormal)
{
    const std::array<Vec3, 4> corners{Vec3{1, 1, 1}, Vec3{1, 1, 1}, Vec3{1, 1, 1},
                                      Vec3{1, 1, 1}};
    const TangentDisc disc = tangent_disc(corners);
    EXPECT_EQ(disc.normal.norm(), 1);
    EXPECT_EQ(disc.squared_distance({1, 1, 4}), 9);
}

}  // namespace
}  // namespace endmill
