// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/extent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>
#include <boost/math/quadrature/gauss.hpp>

#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Relative agreement between two rules of Gauss at which the finer one is accepted. It is
// then far more accurate than that.
constexpr double agreement = 1e-10;
// Agreement as a share of the squared diagonal of the surface: smaller differences are
// rounding.
constexpr double area_rounding = 1e-15;
// Halvings after which a cell is accepted as it is.
constexpr int deepest_halving = 11;

// A rule of Gauss on the unit interval.
struct Rule {
    std::vector<double> places;
    std::vector<double> weights;
};

template <unsigned Points>
Rule make_rule()
{
    // The tables hold the half of the rule on -1 … 1 that is not negative.
    using Half = boost::math::quadrature::gauss<double, Points>;
    Rule rule;
    for (std::size_t k = Half::abscissa().size(); k-- > 0;) {
        rule.places.push_back((1 - Half::abscissa()[k]) / 2);
        rule.weights.push_back(Half::weights()[k] / 2);
    }
    for (std::size_t k = Points % 2; k < Half::abscissa().size(); ++k) {
        rule.places.push_back((1 + Half::abscissa()[k]) / 2);
        rule.weights.push_back(Half::weights()[k] / 2);
    }
    return rule;
}

template <unsigned Points>
const Rule& gauss_rule()
{
    static const Rule rule = make_rule<Points>();
    return rule;
}

// A square of a patch's parameters.
struct Cell {
    double u;
    double v;
    double width;
};

std::vector<double> places_in(const Rule& rule, double low, double width)
{
    std::vector<double> places = rule.places;
    for (double& place : places)
        place = low + width * place;
    return places;
}

double area_by_rule(const BezierPatch& patch, const Cell& cell, const Rule& rule)
{
    const auto tangents = patch.tangents(places_in(rule, cell.u, cell.width),
                                         places_in(rule, cell.v, cell.width));
    double sum = 0;
    auto at = tangents.begin();
    for (const double weight_v : rule.weights) {
        double row = 0;
        for (const double weight_u : rule.weights) {
            row += weight_u * at->du.cross(at->dv).norm();
            ++at;
        }
        sum += weight_v * row;
    }
    return cell.width * cell.width * sum;
}

double coarse_area(const BezierPatch& patch, const Cell& cell)
{
    return area_by_rule(patch, cell, gauss_rule<5>());
}

// Divides the cell into quarters until both rules agree.
double refined_area(const BezierPatch& patch, const Cell& cell, double coarse,
                    double tolerance, int halvings_left)
{
    const double fine = area_by_rule(patch, cell, gauss_rule<10>());
    if (std::abs(fine - coarse) <= tolerance || halvings_left == 0)
        return fine;
    const double half = cell.width / 2;
    double sum = 0;
    for (const double v : {cell.v, cell.v + half})
        for (const double u : {cell.u, cell.u + half}) {
            const Cell quarter{u, v, half};
            sum += refined_area(patch, quarter, coarse_area(patch, quarter),
                                tolerance / 4, halvings_left - 1);
        }
    return sum;
}

double patch_area(const BezierPatch& patch, double least_tolerance)
{
    const Cell whole{0, 0, 1};
    const double coarse = coarse_area(patch, whole);
    return refined_area(patch, whole, coarse,
                        std::max(agreement * coarse, least_tolerance), deepest_halving);
}

}  // namespace

double area(const Surface& surface)
{
    if (surface.diagonal() == 0)
        return 0;
    const double least_tolerance =
        area_rounding * surface.diagonal() * surface.diagonal();
    const auto columns = static_cast<std::size_t>(surface.patches(Parameter::U));
    const auto rows = static_cast<std::size_t>(surface.patches(Parameter::V));
    std::vector<double> areas(columns * rows);
    parallel_for(areas.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            areas[k] = patch_area(surface.patch(static_cast<int>(k % columns),
                                                static_cast<int>(k / columns)),
                                  least_tolerance);
    });
    return std::accumulate(areas.begin(), areas.end(), 0.0);
}

double area(std::span<const Surface> surfaces)
{
    double total = 0;
    for (const Surface& surface : surfaces)
        total += area(surface);
    return total;
}

}  // namespace endmill
