// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "economic-cl-data/formulas/formula_error.h"

namespace endmill {

/// A ball that leaves a scallop on a section.
struct ScallopSection {
    double radius;          ///< R of the ball, mm
    double scallop_height;  ///< h, mm
    double section_radius;  ///< rho, mm, negative where concave
};

/// A step along a curve.
struct StepCase {
    double curve_radius;     ///< rho, mm
    double chord_tolerance;  ///< delta, mm
};

/// Errors of [KimChoi, eq. (4), (5), (11) to (17)], in decimal arithmetic of 50 digits. The true angle
/// between the contacts follows from the distance of ball centre and peak, by bisection.
FormulaErrors interval_formula_errors(std::span<const ScallopSection> sections);

/// Errors of [KimChoi, eq. (1), (2)], in decimal arithmetic of 50 digits, against points on a circle.
FormulaErrors step_formula_errors(std::span<const StepCase> steps);

}  // namespace endmill
