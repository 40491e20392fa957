// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <cmath>
#include <cstddef>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// Far finer than an angle is known; keeps 5 from being 5.000000000000001.
constexpr double angles_per_degree = 1e9;

}  // namespace

std::string force_profile_csv(std::span<const double> angles,
                              std::span<const CuttingForce> forces)
{
    require(angles.size() == forces.size(), "force_profile_csv: need an angle a force");
    std::string text = "theta_deg,force_x_n,force_y_n,force_z_n,torque_n_m\n";
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const double degrees =
            std::round(Angle::radians(angles[i]).degrees() * angles_per_degree) /
            angles_per_degree;
        for (const double number :
             {degrees, forces[i].x_n, forces[i].y_n, forces[i].z_n}) {
            require(std::isfinite(number), "force_profile_csv: a number is not finite");
            append_text(text, number);
            text += ',';
        }
        require(std::isfinite(forces[i].torque_n_m),
                "force_profile_csv: a number is not finite");
        append_text(text, forces[i].torque_n_m);
        text += '\n';
    }
    return text;
}

}  // namespace endmill
