// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace endmill {

/// Rounding error of a computed length, as a share of it. A limit is raised by this share
/// before a length is compared with it.
inline constexpr double limit_rounding = 1e-9;

/// Numbers of reports, rounded to the digits that matter. Files and --json keep all
/// digits. Digits before the point are never rounded away, and at most six follow it.

/// A measured length in mm, or another measured quantity: 4 significant digits from 1 up,
/// 3 below ("137107", "38.61", "0.666"). Below 5e-7 it is "0".
std::string shown(double value);

/// The result of a formula, to 5 significant digits: "0.036801".
std::string shown_result(double value);

/// A time in any unit, to 3 significant digits: "1.97".
std::string shown_time(double value);

/// A coordinate in mm to 0.001 mm: "-2.435".
std::string shown_coordinate(double mm);

/// An angle to 0.01 degrees: "12.35", "45".
std::string shown_degrees(double degrees);

/// As `shown`, but with as many digits as it takes to see on which side of `limit` the
/// value lies: with the limit 0.05, 0.05002 is "0.05002" and not "0.05".
std::string shown_against(double value, double limit);

/// An upper limit in mm to 5 significant digits. It is rounded down, so that every value
/// below the shown limit is below the limit itself. Below 5e-7 it is to 3 digits: "1e-09".
std::string shown_limit(double mm);

/// An error bound in mm to 5 significant digits, rounded up, so that it stays a bound.
std::string shown_bound(double mm);

}  // namespace endmill
