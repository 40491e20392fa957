// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/bernstein_basis.h"

#include <algorithm>

namespace endmill {
namespace {

// Turns the polynomials of degree - 1 in `column` into those of `degree`.
template <class Column>
void raise(Column&& column, int degree, double t)
{
    column[degree] = t * column[degree - 1];
    for (int i = degree - 1; i > 0; --i)
        column[i] = (1 - t) * column[i] + t * column[i - 1];
    column[0] *= 1 - t;
}

// Turns polynomials of degree - 1 in `column`, or their derivatives, into the derivatives
// of those of `degree`.
template <class Column>
void differentiate(Column&& column, int degree)
{
    column[degree] = degree * column[degree - 1];
    for (int i = degree - 1; i > 0; --i)
        column[i] = degree * (column[i - 1] - column[i]);
    column[0] *= -degree;
}

}  // namespace

template <int Columns>
BernsteinBasis<Columns> bernstein_basis(int degree, double t)
{
    // Column k first contains the polynomials of degree - k; then it is differentiated k
    // times.
    BernsteinBasis<Columns> basis = BernsteinBasis<Columns>::Zero(degree + 1, Columns);
    for (int k = std::min(Columns - 1, degree); k >= 0; --k) {
        const int start = degree - k;
        if (k + 1 < Columns && k < degree) {
            basis.col(k) = basis.col(k + 1);
            raise(basis.col(k), start, t);
            continue;
        }
        basis(0, k) = 1;
        for (int n = 1; n <= start; ++n)
            raise(basis.col(k), n, t);
    }
    for (int k = 1; k < Columns && k <= degree; ++k)
        for (int n = degree - k + 1; n <= degree; ++n)
            differentiate(basis.col(k), n);
    return basis;
}

template BernsteinBasis<1> bernstein_basis<1>(int degree, double t);
template BernsteinBasis<2> bernstein_basis<2>(int degree, double t);
template BernsteinBasis<3> bernstein_basis<3>(int degree, double t);

}  // namespace endmill
