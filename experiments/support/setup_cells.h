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

/// The objective "floored-area", "total-range" or "tilt".
/// \throws DomainError for another word.
SetupObjective objective_of_word(const std::string& word);

/// rad^2 in square degrees.
double square_degrees(double square_radians);

/// What an objective's value, in rad or rad^2, is in degrees or square degrees.
double in_degrees(SetupObjective objective, double value);

/// A tool axis in the part's frame, and whether it leans to +x: axis_x, axis_y, axis_z,
/// tilt_deg (from z), azimuth_deg (from x), leans_to_x. Azimuth and lean are
/// empty where they are those of 0.006 degrees or less.
NamedCells axis_cells(const Vec3& axis);

/// What a pose needs: area_deg2, phi_s_deg, phi_l_deg, theta_s_deg, theta_l_deg (smaller and
/// larger magnitude of the ends of a range), width_deg (of C in C,A, of R1 in A,B).
NamedCells range_cells(RotaryFamily family, const FittedPose& fit);

}  // namespace endmill
