// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/border_integrals.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace endmill {
namespace {

using std::numbers::pi;

TEST(TorqueHeightShare, IsTheIntegralOverTheLatitude)
{
    for (int k = 50; k <= 1000; ++k) {  // near 0 the difference below cancels
        const long double d = k * std::numbers::pi_v<long double> / 2000;
        const long double integral = (d - std::sin(d) * std::cos(d)) / 2;
        const long double u = 2 * std::sin(d / 2) * std::sin(d / 2);
        const auto share = static_cast<double>(integral / (std::sin(d) * u));
        EXPECT_NEAR(torque_height_share(static_cast<double>(u)), share, 1e-15);
    }
    EXPECT_NEAR(torque_height_share(0), 2.0 / 3, 1e-15);
    EXPECT_NEAR(torque_height_share(1), pi / 4, 1e-15);
}

TEST(BorderIntegrals, AgreeWithTheToleranceTheyAreGiven)
{
    const EngagedRegion region{{0.4, -0.3, 0.5, 1}};
    const CoefficientSums fine = border_integrals(region, ChipModel::Paper, 1e-13);
    for (const double tolerance : {1e-3, 1e-6, 1e-9}) {
        const CoefficientSums sums =
            border_integrals(region, ChipModel::Paper, tolerance);
        for (std::size_t k = 0; k < sums.size(); ++k)
            EXPECT_NEAR(sums[k], fine[k], tolerance);
    }
}

}  // namespace
}  // namespace endmill
