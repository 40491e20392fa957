// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/patch_rows.h"

#include <cassert>

#include "endmill/surface/detail/bernstein_basis.h"
#include "endmill/surface/detail/cubic_bernstein.h"

namespace endmill {
namespace {

using Index = Eigen::Index;

// The polynomials and their derivatives, computed as BezierPatch computes them.
BernsteinBasis<2> basis_at(int degree, double t)
{
    if (degree == 3)
        return cubic_bernstein<2>(t);
    return bernstein_basis<2>(degree, t);
}

// The control points in u of the row and of its derivative across: first a column for
// each homogeneous coordinate of the row, then of the derivative.
Eigen::Matrix<double, Eigen::Dynamic, 8> net_of_row(const BezierPatch& patch, double v)
{
    const int degree_v = patch.degree(Parameter::V);
    const BernsteinBasis<2> basis = basis_at(degree_v, v);
    const Index count = patch.degree(Parameter::U) + 1;
    Eigen::Matrix<double, Eigen::Dynamic, 8> net{count, 8};
    net.setZero();
    for (int j = 0; j <= degree_v; ++j)
        for (Index i = 0; i < count; ++i) {
            const Eigen::RowVector4d point =
                patch.homogeneous_point(static_cast<int>(i), j);
            net.row(i).head<4>() += basis(j, 0) * point;
            net.row(i).tail<4>() += basis(j, 1) * point;
        }
    return net;
}

// The curve with the control coordinates `net` at all places, from the polynomials there.
// Terms of even and odd number are summed separately, as in BezierPatch: for a bicubic
// patch the results are equal to the last bit.
template <typename Net>
Eigen::ArrayXd curve(const Eigen::ArrayXXd& polynomials, const Net& net)
{
    if (net.size() == 4)
        return (polynomials.col(0) * net[0] + polynomials.col(2) * net[2]) +
               (polynomials.col(1) * net[1] + polynomials.col(3) * net[3]);
    Eigen::ArrayXd even = polynomials.col(0) * net[0];
    Eigen::ArrayXd odd = polynomials.col(1) * net[1];
    for (Index k = 2; k < net.size(); ++k)
        (k % 2 == 0 ? even : odd) += polynomials.col(k) * net[k];
    return even + odd;
}

// Converts the coordinates of w r and its derivatives to those of r.
void project(const Eigen::Array<double, Eigen::Dynamic, 3>& weights, TangentRow& row)
{
    for (Index i = 0; i < row.rows(); ++i) {
        const SurfaceTangents homogeneous{
            row.row(i).segment<3>(0), row.row(i).segment<3>(3), row.row(i).segment<3>(6)};
        Eigen::Matrix2d weight;
        weight << weights(i, 0), weights(i, 2), weights(i, 1), 0;
        const SurfaceTangents tangents = projected(homogeneous, weight);
        row.row(i).segment<3>(0) = tangents.point;
        row.row(i).segment<3>(3) = tangents.du;
        row.row(i).segment<3>(6) = tangents.dv;
    }
}

}  // namespace

PatchRows::PatchRows(int degree, std::span<const double> u)
    : values_{static_cast<Index>(u.size()), degree + 1},
      slopes_{static_cast<Index>(u.size()), degree + 1}
{
    for (Index i = 0; i < values_.rows(); ++i) {
        const BernsteinBasis<2> basis = basis_at(degree, u[static_cast<std::size_t>(i)]);
        values_.row(i) = basis.col(0);
        slopes_.row(i) = basis.col(1);
    }
}

TangentRow PatchRows::at(const BezierPatch& patch, double v) const
{
    assert(patch.degree(Parameter::U) == degree());
    const auto net = net_of_row(patch, v);
    TangentRow row{values_.rows(), 9};
    for (Index c = 0; c < 3; ++c) {
        row.col(c) = curve(values_, net.col(c));
        row.col(3 + c) = curve(slopes_, net.col(c));
        row.col(6 + c) = curve(values_, net.col(4 + c));
    }
    if (patch.is_rational()) {
        Eigen::Array<double, Eigen::Dynamic, 3> weights{values_.rows(), 3};
        weights.col(0) = curve(values_, net.col(3));
        weights.col(1) = curve(slopes_, net.col(3));
        weights.col(2) = curve(values_, net.col(7));
        project(weights, row);
    }
    return row;
}

}  // namespace endmill
