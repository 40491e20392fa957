// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "economic-cl-data/formulas/formula_error.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Errors of the formulas of [KimChoi, section 2 and 3]: the Bezier patch as a sum and by the matrix M,
/// Ferguson's form, and the CL point.
/// \param patch bicubic, without weights.
FormulaErrors patch_formula_errors(const BezierPatch& patch);

/// Surfaces on which the curvature across the feed has a closed form.
struct ClosedFormSurfaces {
    Surface sphere;  ///< radius 25 mm
    Surface
        torus;  ///< tube of radius 15 mm around a ring of radius 40 mm about the z axis
    Surface saddle;  ///< z = (x^2 - y^2) / 64
};

/// Errors of [KimChoi, eq. (6) to (10)] on these surfaces.
FormulaErrors section_formula_errors(const ClosedFormSurfaces& surfaces);

/// Observed order of convergence of eq. (8) in its step eps, on torus and saddle.
double order_of_chord_curvature(const ClosedFormSurfaces& surfaces);

/// Error of [KimChoi, eq. (3)] at the steps of a plan of this library on `surface`.
FormulaError next_point_error(const Surface& surface);

}  // namespace endmill
