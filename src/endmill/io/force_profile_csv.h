// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "endmill/process/cutting_force.h"

namespace endmill {

/// Forces over a turn as a CSV file with a row an angle and the columns theta_deg,
/// force_x_n, force_y_n, force_z_n, torque_n_m, in the frame of CuttingForce.
/// \param angles of the cutter, rad, one a force; written in degrees, rounded to 1e-9.
/// \throws DomainError unless there is an angle for each force, and every number is finite.
std::string force_profile_csv(std::span<const double> angles,
                              std::span<const CuttingForce> forces);

}  // namespace endmill
