// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/cutting_force.h"

#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using std::numbers::pi;

const CuttingMaterial material{2000, 0.016, 0.4, 0.5, 0.2, 0.6, 0.37, 28};
const MillingTool mill{5, 2, 0.5};

// A slot on level ground has I = 0, 1/4, 0, 1/pi, 1/pi, 1/2, 1/4, pi/8
// (docs/methods/ball-end-milling.md, section 9, A1).
TEST(MeanForce, OfASlotIsClosed)
{
    const CuttingCoefficients slot =
        cutting_coefficients({0, 0, 0, 1, PreviousPass::None});
    const double scale = 2 * 5 * 2000;
    const double f = 0.1;
    const double h = 0.016;
    const CuttingForce up = mean_force(slot, material, mill, f, Milling::Up);
    EXPECT_NEAR(up.x_n, scale * (f * 0.4 / 4 + h * 0.5 / pi), 1e-8);
    EXPECT_NEAR(up.y_n, -scale * (f / 4 + h / pi), 1e-8);
    EXPECT_NEAR(up.z_n, scale * (f * 0.2 / pi + h * 0.6 / 2), 1e-8);
    EXPECT_NEAR(up.torque_n_m, scale * 5 * (f / 4 + h * pi / 8) / 1000, 1e-8);
}

// A climb cut is computed twice: by the form for milling down, and as the mirror image of
// its region (azimuth t to pi - t) in the form for milling up, mirrored in Y. Behind the
// axis, the chip keeps its sign.
TEST(MeanForce, MillingDownIsThatOfTheMirroredCut)
{
    for (const double lambda : {-0.4, 0.0, 0.3}) {
        const CuttingCoefficients c = cutting_coefficients({-0.3, lambda, 0.5, 1.2});
        const CuttingCoefficients mirrored{-c.I1, c.I2, -c.I3, c.I4,
                                           c.I5,  c.I6, c.I7,  c.I8};
        const CuttingForce down = mean_force(c, material, mill, 0.1, Milling::Down);
        const CuttingForce up = mean_force(mirrored, material, mill, 0.1, Milling::Up);
        EXPECT_NEAR(down.x_n, up.x_n, 1e-9);
        EXPECT_NEAR(down.y_n, -up.y_n, 1e-9);
        EXPECT_NEAR(down.z_n, up.z_n, 1e-9);
        EXPECT_NEAR(down.torque_n_m, -up.torque_n_m, 1e-12);
    }
}

TEST(MeanForce, RefusesUnsoundCuts)
{
    EXPECT_THROW(mean_force({}, material, mill, -0.1, Milling::Up), DomainError);
    EXPECT_THROW(mean_force({}, material, {5, 0, 0}, 0.1, Milling::Up), DomainError);
    CuttingMaterial bad = material;
    bad.specific_resistance_n_per_mm2 = 0;
    EXPECT_THROW(mean_force({}, bad, mill, 0.1, Milling::Up), DomainError);
}

}  // namespace
}  // namespace endmill
