// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace endmill {

/// Ways to evaluate the path interval l of [KimChoi, eq. (4)] that are equal in exact
/// arithmetic. With A = 2 (R + rho)(h + rho) and B = rho^2 + 2 R rho + (h + rho)^2:
enum class IntervalForm {
    Printed,   ///< eq. (4) from left to right, 4 (R + rho)^2 (h + rho)^2 - B^2
    Squares,   ///< A^2 - B^2
    Factors,   ///< (A - B)(A + B)
    Expanded,  ///< the powers of rho collected, the print's form before its eq. (15)
};

/// In which arithmetic.
enum class Precision {
    Single,  ///< 24 bits, as FORTRAN's REAL had them
    Double,  ///< 53 bits
};

/// The ball and the section that an interval belongs to.
struct IntervalCase {
    double radius;          ///< R of the ball, mm
    double scallop_height;  ///< h, mm
    double section_radius;  ///< rho, mm, positive: a convex section
};

/// l in mm, evaluated as told, every operation rounded. Not a number where the rounded
/// radicand is negative.
double printed_interval(const IntervalCase& at, IntervalForm form, Precision precision);

/// l in mm by eq. (4) in decimal arithmetic of 50 digits, right to 15.
double interval_in_50_digits(const IntervalCase& at);

}  // namespace endmill
