// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr const char* header = "theta_deg,force_x_n,force_y_n,force_z_n,torque_n_m\n";

TEST(ForceProfileCsv, HasARowAnAngle)
{
    const std::vector<double> angles{0, std::numbers::pi / 36};
    const std::vector<CuttingForce> forces{{1, -2, 3.5, 0.25}, {0, 0, 0, -1}};
    EXPECT_EQ(force_profile_csv(angles, forces),
              std::string{header} + "0,1,-2,3.5,0.25\n5,0,0,0,-1\n");
    EXPECT_EQ(force_profile_csv({}, {}), header);
}

TEST(ForceProfileCsv, RefusesNumbersThatAreNotFinite)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> angle{1};
    for (const CuttingForce& wrong :
         {CuttingForce{nan, 0, 0, 0}, CuttingForce{0, nan, 0, 0},
          CuttingForce{0, 0, nan, 0}, CuttingForce{0, 0, 0, nan}})
        EXPECT_THROW(force_profile_csv(angle, std::vector{wrong}), DomainError);
    EXPECT_THROW(force_profile_csv(std::vector{nan}, std::vector{CuttingForce{}}),
                 DomainError);
    EXPECT_THROW(force_profile_csv({}, std::vector{CuttingForce{}}), DomainError);
}

}  // namespace
}  // namespace endmill
