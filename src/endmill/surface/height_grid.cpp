// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/nurbs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <Eigen/SparseLU>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

// The knots of the not-a-knot spline: both ends degree + 1 times, and all inner grid
// lines except the second and the last but one.
SplineParameter not_a_knot(std::span<const double> lines)
{
    const int degree = std::min<int>(3, static_cast<int>(lines.size()) - 1);
    std::vector<double> knots(static_cast<std::size_t>(degree) + 1, lines.front());
    if (lines.size() > 4)
        knots.insert(knots.end(), lines.begin() + 2, lines.end() - 2);
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, lines.back());
    return {degree, std::move(knots)};
}

// The B-splines that are not zero at t, by the recurrence of Cox and de Boor.
struct BasisRow {
    int first;                   // number of the first one
    std::vector<double> values;  // degree + 1 values
};

BasisRow basis_row(const SplineParameter& parameter, double t)
{
    const auto& [degree, knots] = parameter;
    const auto inner_end = knots.begin() + parameter.points();
    const auto above = std::upper_bound(knots.begin() + degree + 1, inner_end, t);
    const int span = static_cast<int>(above - knots.begin()) - 1;
    std::vector<double> values{1};
    for (int level = 1; level <= degree; ++level) {
        std::vector<double> next(static_cast<std::size_t>(level) + 1, 0.0);
        for (int k = 0; k < level; ++k) {
            const double low = knots[span - level + 1 + k];
            const double high = knots[span + 1 + k];
            const double share = (t - low) / (high - low);
            next[k] += (1 - share) * values[k];
            next[k + 1] += share * values[k];
        }
        values = std::move(next);
    }
    return {span - degree, std::move(values)};
}

using Collocation = Eigen::SparseLU<Eigen::SparseMatrix<double>>;

// The linear equations for the coefficients of the spline with given values at `lines`.
void factorize(Collocation& equations, const SplineParameter& parameter,
               std::span<const double> lines)
{
    const auto size = static_cast<Eigen::Index>(lines.size());
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index row = 0; row < size; ++row) {
        const auto [first, values] = basis_row(parameter, lines[row]);
        for (std::size_t k = 0; k < values.size(); ++k)
            entries.emplace_back(static_cast<int>(row), first + static_cast<int>(k),
                                 values[k]);
    }
    Eigen::SparseMatrix<double> matrix{size, size};
    matrix.setFromTriplets(entries.begin(), entries.end());
    equations.compute(matrix);
    require(equations.info() == Eigen::Success,
            "height_grid: the grid lines lie too unevenly to be interpolated");
}

// The Greville abscissa of coefficient i: the mean of the knots between. The spline t ->
// t has these coefficients.
double greville(const SplineParameter& parameter, int i)
{
    double sum = 0;
    for (int k = 1; k <= parameter.degree; ++k)
        sum += parameter.knots[i + k];
    return sum / parameter.degree;
}

// Whether the lines rise by more than the least interval.
bool rises(std::span<const double> lines)
{
    if (!std::ranges::all_of(lines, [](double t) { return std::isfinite(t); }))
        return false;
    const double least = least_grid_interval * (lines.back() - lines.front());
    return std::ranges::adjacent_find(lines, [&](double low, double high) {
               return !(high - low > least);
           }) == lines.end();
}

}  // namespace

// The tensor product is solved one parameter after the other: first for each grid line
// along x, then for the resulting coefficients along y.
Surface height_grid(std::span<const double> x, std::span<const double> y,
                    std::span<const double> z, ToolSide tool_side)
{
    require(x.size() >= 2 && y.size() >= 2, "height_grid: need two grid lines each way");
    require(z.size() == x.size() * y.size(),
            "height_grid: the number of heights does not match the grid");
    require(rises(x) && rises(y), "height_grid: grid lines must be finite and rise");
    require(std::ranges::all_of(z, [](double height) { return std::isfinite(height); }),
            "height_grid: heights must be finite");
    Nurbs nurbs{not_a_knot(x), not_a_knot(y), {}, {}};
    Eigen::MatrixXd heights =
        Eigen::Map<const Eigen::MatrixXd>{z.data(), static_cast<Eigen::Index>(x.size()),
                                          static_cast<Eigen::Index>(y.size())};
    Collocation along_x;
    Collocation along_y;
    factorize(along_x, nurbs.u, x);
    factorize(along_y, nurbs.v, y);
    const Eigen::MatrixXd across = along_x.solve(heights).transpose();
    heights = along_y.solve(across).transpose();

    nurbs.control_points.reserve(z.size());
    for (int j = 0; j < nurbs.v.points(); ++j)
        for (int i = 0; i < nurbs.u.points(); ++i)
            nurbs.control_points.emplace_back(greville(nurbs.u, i), greville(nurbs.v, j),
                                              heights(i, j));
    return nurbs_surface(nurbs, tool_side);
}

}  // namespace endmill
