// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/setup/setup_pose.h"
#include "support/named_cells.h"

namespace endmill {

/// The family CA or AB. \throws DomainError for another word.
RotaryFamily family_of_word(const std::string& word);

/// The mode of that name. \throws DomainError if there is none.
SetupMode mode_of_word(const std::string& word);

/// The objective of that name: "floored-area", "total-range" or "tilt".
/// \throws DomainError for another word.
SetupObjective objective_of_word(const std::string& word);

/// The name that section 3.1 of the paper gives to machines whose two rotary axes lie on
/// these sides of the bed: "spindle tilting", "table tilting" or "table and spindle".
/// \pre the machine has two rotary axes.
std::string type_name(const MachineConfiguration& machine);

/// Converts rad^2 to square degrees.
double square_degrees(double square_radians);

/// Converts the value of an objective from rad or rad^2 to degrees or square degrees.
double in_degrees(SetupObjective objective, double value);

/// Cells of a tool axis in the part's frame: axis_x, axis_y, axis_z, tilt_deg (from z),
/// azimuth_deg (from x), leans_to_x (whether it leans to +x). Azimuth and lean are empty
/// within 0.006 degrees of z.
NamedCells axis_cells(const Vec3& axis);

/// Ranges of a pose: area_deg2, phi_s_deg, phi_l_deg, theta_s_deg, theta_l_deg (smaller
/// and larger magnitude of the ends of a range), width_deg (of C in C,A, of R1 in A,B).
NamedCells range_cells(RotaryFamily family, const FittedPose& fit);

}  // namespace endmill
