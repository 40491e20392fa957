// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/tangent_condition.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

TEST(TangentCondition, HoldsOnAPolynomialInEqualPatches)
{
    const Surface surface =
        test::graph(test::monomial(2, 1, 0.01) + test::monomial(1, 3, 0.002),
                    {{0, 6}, {0, 4}}, {3, 2});
    const std::vector<TangentCondition> conditions = tangent_conditions(surface);
    ASSERT_EQ(conditions.size(), 3U);
    EXPECT_EQ(conditions[0].border, "u=1");
    EXPECT_EQ(conditions[1].border, "u=2");
    EXPECT_EQ(conditions[2].border, "v=1");
    for (const TangentCondition& condition : conditions) {
        EXPECT_NEAR(condition.least_ratio, 1, 1e-12);
        EXPECT_NEAR(condition.greatest_ratio, 1, 1e-12);
        EXPECT_LT(condition.worst_bend.radians(), 1e-7);
    }
}

TEST(TangentCondition, OfAValleyHasTheAngleBetweenItsPlanes)
{
    const double slope = 0.3;
    const std::vector<TangentCondition> conditions =
        tangent_conditions(test::valley(10, 5, slope));
    ASSERT_EQ(conditions.size(), 1U);
    EXPECT_NEAR(conditions[0].worst_bend.radians(), 2 * std::atan(slope), 1e-12);
    EXPECT_NEAR(conditions[0].measured.normals.radians(), 2 * std::atan(slope), 1e-9);
    EXPECT_NEAR(conditions[0].least_ratio, 1, 1e-12);
}

// A plane in two patches whose control points are 1 and 2 mm apart in u.
TEST(TangentCondition, MeasuresTheRatioOfTheLegs)
{
    std::vector<Vec3> net;
    for (int row = 0; row < 4; ++row)
        for (const double x : {0.0, 1.0, 2.0, 3.0, 5.0, 7.0, 9.0})
            net.emplace_back(x, row, 0);
    const auto conditions = tangent_conditions(composite_bezier(2, 1, net));
    ASSERT_EQ(conditions.size(), 1U);
    EXPECT_NEAR(conditions[0].least_ratio, 2, 1e-12);
    EXPECT_NEAR(conditions[0].greatest_ratio, 2, 1e-12);
}

TEST(TangentCondition, RefusesALegWithoutLength)
{
    std::vector<Vec3> net;
    for (int row = 0; row < 4; ++row)
        for (const double x : {0.0, 1.0, 3.0, 3.0, 5.0, 7.0, 9.0})
            net.emplace_back(x, row, 0);
    EXPECT_THROW(tangent_conditions(composite_bezier(2, 1, net)), DomainError);
}

}  // namespace
}  // namespace endmill
