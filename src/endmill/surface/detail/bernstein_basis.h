// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace endmill {

/// Highest degree of a Bezier curve or patch.
inline constexpr int most_degree = 25;

/// The Bernstein polynomials of one degree, one in each row: values in the first column,
/// first derivatives in the second, second derivatives in the third. It uses no heap
/// memory.
template <int Columns>
using BernsteinBasis =
    Eigen::Matrix<double, Eigen::Dynamic, Columns, Eigen::ColMajor, most_degree + 1>;

/// The polynomials C(n,i) t^i (1-t)^(n-i) of degree n at t, with `Columns` - 1 of their
/// derivatives, by the recurrence from degree to degree. No digits cancel inside [0, 1].
/// For degree 3, `cubic_bernstein` computes the same faster.
/// \pre 0 <= degree <= most_degree
template <int Columns>
BernsteinBasis<Columns> bernstein_basis(int degree, double t);

extern template BernsteinBasis<1> bernstein_basis<1>(int degree, double t);
extern template BernsteinBasis<2> bernstein_basis<2>(int degree, double t);
extern template BernsteinBasis<3> bernstein_basis<3>(int degree, double t);

}  // namespace endmill
