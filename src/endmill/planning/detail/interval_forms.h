// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace endmill {

/// Forms of the path interval l of [KimChoi, eq. (4)]. They are equal in exact arithmetic
/// and differ in their rounding errors. With A = 2 (R + rho)(h + rho) and B = rho^2 + 2 R
/// rho + (h + rho)^2, the radicand is
enum class IntervalForm {
    Printed,   ///< eq. (4) from left to right, 4 (R + rho)^2 (h + rho)^2 - B^2
    Squares,   ///< A^2 - B^2
    Factors,   ///< (A - B)(A + B)
    Expanded,  ///< the powers of rho collected, the print's form before its eq. (15)
};

/// Binary floating-point arithmetic of the evaluation.
enum class Precision {
    Single,  ///< 24 bits, as FORTRAN's REAL
    Double,  ///< 53 bits
};

/// Arguments of the path interval.
struct IntervalCase {
    double radius;          ///< R of the ball, mm
    double scallop_height;  ///< h, mm
    double section_radius;  ///< rho, mm, positive: a convex section
};

/// The interval l in mm by `form`, with every operation rounded to `precision`. Not a
/// number if the rounded radicand is negative.
double printed_interval(const IntervalCase& at, IntervalForm form, Precision precision);

/// The interval l in mm by eq. (4) in decimal arithmetic of 50 digits. Relative error
/// below 1e-15, the rounding of the result.
double interval_in_50_digits(const IntervalCase& at);

}  // namespace endmill
