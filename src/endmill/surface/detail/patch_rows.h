// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include <Eigen/Core>

#include "endmill/surface/bezier_patch.h"

namespace endmill {

/// Points and first partial derivatives along a row of a patch, one place in each row: x,
/// y and z of the point, of the derivative in u and of the derivative in v, in the order
/// of SurfaceTangents.
using TangentRow = Eigen::Array<double, Eigen::Dynamic, 9>;

/// Evaluates patches on a grid of parameters, row by row. The Bernstein polynomials are
/// computed once for each column and each row, and the control net is contracted once for
/// each row. So a place takes a quarter of the time of BezierPatch::tangents.
class PatchRows {
public:
    /// \param degree degree of the patches in u, 1 to 25.
    /// \param u places in each row, in the parameter of the patches.
    PatchRows(int degree, std::span<const double> u);

    int degree() const { return static_cast<int>(values_.cols()) - 1; }  ///< as given

    /// The values of patch.tangents(u, v) at all u, accurate to a few roundings.
    /// \pre patch.degree(Parameter::U) == degree()
    TangentRow at(const BezierPatch& patch, double v) const;

private:
    Eigen::ArrayXXd values_;  // one column for each polynomial, one row for each place
    Eigen::ArrayXXd slopes_;
};

}  // namespace endmill
