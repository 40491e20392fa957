// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/extent.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>

namespace endmill {
namespace {

using Rule = boost::math::quadrature::gauss<double, 10>;

// Relative agreement between a rule and its refinement at which the refinement is
// accepted. The finer rule is then far more accurate than that.
constexpr double agreement = 1e-10;
// Agreement as a share of the squared diagonal of the surface: smaller differences are
// rounding.
constexpr double area_rounding = 1e-15;
// Halvings after which a cell is accepted as it is.
constexpr int deepest_halving = 10;

// A square of a patch's parameters.
struct Cell {
    double u;
    double v;
    double width;
};

double area_by_one_rule(const BezierPatch& patch, const Cell& cell)
{
    const auto along_v = [&](double u) {
        return Rule::integrate(
            [&](double v) {
                const SurfaceTangents tangents = patch.tangents(u, v);
                return tangents.du.cross(tangents.dv).norm();
            },
            cell.v, cell.v + cell.width);
    };
    return Rule::integrate(along_v, cell.u, cell.u + cell.width);
}

// Divides the cell into quarters until the sum of their areas agrees with the area of the
// cell.
double refined_area(const BezierPatch& patch, const Cell& cell, double coarse,
                    double tolerance, int halvings_left)
{
    const double half = cell.width / 2;
    const Cell quarters[] = {{cell.u, cell.v, half},
                             {cell.u + half, cell.v, half},
                             {cell.u, cell.v + half, half},
                             {cell.u + half, cell.v + half, half}};
    double areas[4];
    double fine = 0;
    for (int k = 0; k < 4; ++k)
        fine += areas[k] = area_by_one_rule(patch, quarters[k]);
    if (std::abs(fine - coarse) <= tolerance || halvings_left == 0)
        return fine;
    fine = 0;
    for (int k = 0; k < 4; ++k)
        fine +=
            refined_area(patch, quarters[k], areas[k], tolerance / 4, halvings_left - 1);
    return fine;
}

}  // namespace

double area(const Surface& surface)
{
    if (surface.diagonal() == 0)
        return 0;
    double total = 0;
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i) {
            const BezierPatch& patch = surface.patch(i, j);
            const Cell whole{0, 0, 1};
            const double coarse = area_by_one_rule(patch, whole);
            const double tolerance =
                std::max(agreement * coarse,
                         area_rounding * surface.diagonal() * surface.diagonal());
            total += refined_area(patch, whole, coarse, tolerance, deepest_halving);
        }
    return total;
}

double area(std::span<const Surface> surfaces)
{
    double total = 0;
    for (const Surface& surface : surfaces)
        total += area(surface);
    return total;
}

}  // namespace endmill
