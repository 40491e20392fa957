// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <Eigen/Core>

#include "endmill/surface/bezier_patch.h"

namespace endmill {

/// Points and first partials at places along a row of a patch, a row each: x, y and z of the
/// point, of the partial in u and of that in v, as SurfaceTangents has them.
using TangentRow = Eigen::Array<double, Eigen::Dynamic, 9>;

/// Patches on a grid of parameters, row by row: the Bernstein polynomials are computed once
/// for a column and once for a row, and the net is contracted once a row, so that a place
/// costs a quarter of BezierPatch::tangents.
class PatchRows {
public:
    /// \param degree of the patches in u, 1 … 25.
    /// \param u where each row is evaluated, in the patches' own parameter.
    PatchRows(int degree, std::span<const double> u);

    int degree() const { return static_cast<int>(values_.cols()) - 1; }  ///< as given

    /// What patch.tangents(u, v) is at each u, to a few roundings.
    /// \pre patch.degree(Parameter::U) == degree()
    TangentRow at(const BezierPatch& patch, double v) const;

private:
    Eigen::ArrayXXd values_;  // a column a polynomial, a row a place
    Eigen::ArrayXXd slopes_;
};

}  // namespace endmill
