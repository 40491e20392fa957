// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace endmill {

/// Rounding error of a computed length, as a share of it. A limit is raised by this share
/// before a length is compared with it.
inline constexpr double limit_rounding = 1e-9;

/// Numbers of reports, rounded to the digits that matter. Files and --json keep all
/// digits.

/// A length in mm, or any other quantity, to 5 significant digits: "0.66637", "137107".
/// Below 5e-7 it is "0".
std::string shown(double value);

/// A coordinate in mm to 0.001 mm: "-2.435".
std::string shown_coordinate(double mm);

/// An angle to 0.01 degrees: "12.35", "45".
std::string shown_degrees(double degrees);

/// An open upper limit in mm to 5 significant digits. It is rounded down, so that every
/// value below the shown limit is below the limit itself.
std::string shown_limit(double mm);

}  // namespace endmill
