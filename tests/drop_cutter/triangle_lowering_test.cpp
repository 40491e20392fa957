// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/triangle_lowering.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/detail/exact_arithmetic.h"
#include "endmill/core/tolerance.h"
#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

template <typename Real>
TriangleLowering<Real> lowered(const CutterShape<Real>& shape,
                               const std::array<Vec3, 3>& corners)
{
    std::array<AxisPlace<Real>, 3> places;
    for (int k = 0; k < 3; ++k)
        places[k] = {Real{corners[k].x()}, Real{corners[k].y()}, Real{corners[k].z()}};
    TriangleLowering<Real> lowering{shape, -std::numeric_limits<double>::infinity()};
    lowering.lower_onto(places);
    return lowering;
}

// The result with twice the digits is the same, unless the result in doubles is marked as
// doubtful.
TEST(TriangleLowering, DetectsInsufficientPrecision)
{
    test::Random random{1};
    int plain = 0;
    for (int k = 0; k < 3000; ++k) {
        const double r = std::array{0.0, 0.7, 2.0}[k % 3];
        const Vec3 centre = test::random_point(random, 2);
        const double size = random.log_uniform(1e-7, 3);
        const std::array<Vec3, 3> corners{centre + test::random_point(random, size),
                                          centre + test::random_point(random, size),
                                          centre + test::random_point(random, size)};
        const CutterShape<double> shape{2, r, 2 - r};
        const auto found = lowered(shape, corners);
        if (found.is_doubtful())
            continue;
        const DoubleDouble R{2};
        const CutterShape<DoubleDouble> precise{R, DoubleDouble{r}, R - DoubleDouble{r}};
        const auto expected = lowered(precise, corners).contact(0, 0);
        if (std::isfinite(expected.tip_z)) {
            EXPECT_NEAR(found.contact(0, 0).tip_z, expected.tip_z, tip_accuracy);
        }
        ++plain;
    }
    EXPECT_GT(plain, 1500);
}

// On a level triangle, and where no part of it is below the cutter.
TEST(TriangleLowering, FindsTheFacetOrNothing)
{
    const CutterShape<double> ball{2, 2, 0};
    const auto under = lowered(ball, {Vec3{-1, -1, 3}, Vec3{2, -1, 3}, Vec3{-1, 2, 3}});
    EXPECT_EQ(under.contact(5, 6).tip_z, 3);
    EXPECT_EQ(under.contact(5, 6).point, Vec3(5, 6, 3));
    EXPECT_EQ(under.contact(5, 6).kind, TouchKind::Facet);
    const auto beside = lowered(ball, {Vec3{3, 3, 3}, Vec3{4, 3, 3}, Vec3{3, 4, 3}});
    EXPECT_EQ(beside.contact(5, 6).tip_z, -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace endmill
