// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/plane_points.h"

#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

TEST(PlanePoints, NumbersThePointsOfAllCurves)
{
    const std::vector curves{test::open_curve({{0, 1}, {2, 3}}), test::open_curve({}),
                             test::open_curve({{4, 5}, {6, 7}, {8, 9}})};
    const PlanePoints plane{curves};
    ASSERT_EQ(plane.section().points.size(), 5u);
    for (std::int32_t k = 0; k < 5; ++k) {
        const SegmentNumber number = plane.number(k);
        EXPECT_EQ(plane.section().points[k], curves[number.curve].points[number.point]);
    }
    EXPECT_EQ(plane.number(2), (SegmentNumber{2, 0}));
}

TEST(PlanePoints, CopiesNoSingleCurve)
{
    const SectionCurve curve = test::open_curve({{0, 1}, {2, 3}});
    const PlanePoints plane{{&curve, 1}};
    EXPECT_EQ(plane.section().points.data(), curve.points.data());
    EXPECT_EQ(plane.number(1), (SegmentNumber{0, 1}));
}

TEST(PlanePoints, BoundsCoordinatesAndRefusesNonFiniteOnes)
{
    const SectionCurve far = test::open_curve({{0, 1}, {-1e200, 3}});
    EXPECT_GE((PlanePoints{{&far, 1}}.section().largest_at_most), 1e200);
    const SectionCurve bad =
        test::open_curve({{0, std::numeric_limits<double>::quiet_NaN()}});
    EXPECT_THROW((PlanePoints{{&bad, 1}}), DomainError);
}

// The check compares several points at a time and the last ones singly.
TEST(PlanePoints, ChecksEveryCoordinate)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t size = 1; size <= 37; ++size) {
        for (std::size_t k = 0; k < 2 * size; ++k) {
            SectionCurve curve;
            curve.points.assign(size, SectionPoint{-1, 2});
            double& coordinate = curve.points[k / 2][static_cast<int>(k % 2)];
            for (const double bad : {infinity, -infinity, nan}) {
                coordinate = bad;
                EXPECT_THROW((PlanePoints{{&curve, 1}}), DomainError);
            }
            for (const double far : {1e200, -1e200}) {
                coordinate = far;
                EXPECT_GE((PlanePoints{{&curve, 1}}.section().largest_at_most), 1e200);
            }
            coordinate = 3;
            EXPECT_LT((PlanePoints{{&curve, 1}}.section().largest_at_most), 0x1p+250);
        }
    }
}

}  // namespace
}  // namespace endmill
