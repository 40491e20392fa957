// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/raised_enclosure.h"

#include <cmath>
#include <vector>

namespace endmill {
namespace {

using VectorSeries = std::array<IntervalSeries<2>, 3>;

// Order of the expansion that second derivatives of the normal need.
constexpr int order = 3;

double choose(int n, int k)
{
    double result = 1;
    for (int i = 1; i <= k; ++i)
        result *= (n - k + i) / static_cast<double>(i);
    return result;
}

// Coefficients of all Bernstein polynomials of a degree as polynomials of x - middle:
// entry (a, i) is that of (x - middle)^a in B_i.
Eigen::MatrixXd bernstein_expansions(int degree, double middle)
{
    Eigen::MatrixXd result(degree + 1, degree + 1);
    for (int i = 0; i <= degree; ++i) {
        Eigen::VectorXd polynomial = Eigen::VectorXd::Zero(degree + 1);
        polynomial[0] = choose(degree, i);
        for (int factor = 0; factor < degree; ++factor) {
            const double constant = factor < i ? middle : 1 - middle;
            const double slope = factor < i ? 1 : -1;
            for (int a = degree; a > 0; --a)
                polynomial[a] = constant * polynomial[a] + slope * polynomial[a - 1];
            polynomial[0] *= constant;
        }
        result.col(i) = polynomial;
    }
    return result;
}

// The powers 0 to `degree` of all x with |x| <= half.
std::vector<Interval> powers(int degree, double half)
{
    std::vector<Interval> result;
    double power = 1;
    for (int a = 0; a <= degree; ++a, power *= half)
        result.push_back(a == 0       ? Interval{1, 1}
                         : a % 2 == 0 ? Interval{0, power}
                                      : around_zero(power));
    return result;
}

// A box in the parameters of a patch: its middle, and half its size.
struct LocalBox {
    double middle;
    double half;
    double slope;  // units of the patch's parameter per unit of the global one
};

LocalBox local_box(std::span<const double> breaks, int number, const Interval& range)
{
    const double slope = 1 / (breaks[number + 1] - breaks[number]);
    return {((range.low + range.high) / 2 - breaks[number]) * slope,
            range.length() / 2 * slope, slope};
}

// The series over the box of a polynomial with coefficients (a, b) about its middle.
IntervalSeries<order> series_of(const Eigen::MatrixXd& coefficients, const LocalBox& u,
                                const LocalBox& v)
{
    const int p = static_cast<int>(coefficients.rows()) - 1;
    const int q = static_cast<int>(coefficients.cols()) - 1;
    const std::vector<Interval> x = powers(p, u.half);
    const std::vector<Interval> y = powers(q, v.half);
    IntervalSeries<order> result;
    for (int n = 0; n <= order; ++n)
        for (int j = 0; j <= n; ++j) {
            const int i = n - j;
            Interval sum{0, 0};
            for (int a = i; a <= p; ++a)
                for (int b = j; b <= q; ++b)
                    sum = sum + coefficients(a, b) * choose(a, i) * choose(b, j) *
                                    (x[a - i] * y[b - j]);
            result(i, j) = std::pow(u.slope, i) * std::pow(v.slope, j) * sum;
        }
    return result;
}

// The series of the points of a patch. For a rational one the middle of the box is the
// origin, so that the quotients are enclosed closely.
std::array<IntervalSeries<order>, 3> point_series(const BezierPatch& patch,
                                                  const LocalBox& u, const LocalBox& v)
{
    const int p = patch.degree(Parameter::U);
    const int q = patch.degree(Parameter::V);
    const Eigen::MatrixXd of_u = bernstein_expansions(p, u.middle);
    const Eigen::MatrixXd of_v = bernstein_expansions(q, v.middle);
    std::array<Eigen::MatrixXd, 4> coefficients;
    for (int k = 0; k < 4; ++k) {
        Eigen::MatrixXd net(p + 1, q + 1);
        for (int j = 0; j <= q; ++j)
            for (int i = 0; i <= p; ++i)
                net(i, j) = patch.homogeneous_point(i, j)[k];
        coefficients[k] = of_u * net * of_v.transpose();
    }
    std::array<IntervalSeries<order>, 3> result;
    for (int k = 0; k < 3; ++k) {
        if (!patch.is_rational()) {
            result[k] = series_of(coefficients[k], u, v);
            continue;
        }
        const double origin = coefficients[k](0, 0) / coefficients[3](0, 0);
        result[k] = series_of(coefficients[k] - origin * coefficients[3], u, v) /
                    series_of(coefficients[3], u, v);
        result[k](0, 0) = result[k](0, 0) + Interval{origin, origin};
    }
    return result;
}

template <int Order>
std::array<IntervalSeries<Order>, 3> cross(const std::array<IntervalSeries<Order>, 3>& a,
                                           const std::array<IntervalSeries<Order>, 3>& b)
{
    const auto component = [&](int i, int j) {
        return a[i] * b[j] + -1.0 * (a[j] * b[i]);
    };
    return {component(1, 2), component(2, 0), component(0, 1)};
}

// The derivatives (1, 0) and (0, 1), or (2, 0), (1, 1) and (0, 2).
template <int Order>
std::array<IntervalVector, 2> firsts(const std::array<IntervalSeries<Order>, 3>& series)
{
    std::array<IntervalVector, 2> result;
    for (int k = 0; k < 3; ++k) {
        result[0][k] = series[k](1, 0);
        result[1][k] = series[k](0, 1);
    }
    return result;
}

template <int Order>
std::array<IntervalVector, 3> seconds(const std::array<IntervalSeries<Order>, 3>& series)
{
    std::array<IntervalVector, 3> result;
    for (int k = 0; k < 3; ++k) {
        result[0][k] = 2 * series[k](2, 0);
        result[1][k] = series[k](1, 1);
        result[2][k] = 2 * series[k](0, 2);
    }
    return result;
}

}  // namespace

std::optional<RaisedEnclosure> raised_enclosure(const BoundedPart& part,
                                                const ContactPlace& place,
                                                const ParameterBox& box, double height)
{
    const Surface& surface = part.surfaces[place.surface];
    const LocalBox u = local_box(surface.breaks(Parameter::U), place.i, box.u);
    const LocalBox v = local_box(surface.breaks(Parameter::V), place.j, box.v);
    const auto points = point_series(surface.patch(place.i, place.j), u, v);
    VectorSeries du;
    VectorSeries dv;
    for (int k = 0; k < 3; ++k) {
        du[k] = points[k].derivative_u();
        dv[k] = points[k].derivative_v();
    }
    const VectorSeries across = cross(du, dv);
    const IntervalSeries<2> square =
        across[0] * across[0] + across[1] * across[1] + across[2] * across[2];
    Interval least{0, 0};
    for (int k = 0; k < 3; ++k)
        least = least + endmill::square(across[k](0, 0));
    if (!(least.low > 0) || !(square(0, 0).low > 0))
        return std::nullopt;
    IntervalSeries<2> area = square_root(square);
    VectorSeries raised;
    VectorSeries normal;
    for (int k = 0; k < 3; ++k) {
        normal[k] = part.sides[place.surface] * (across[k] / area);
        raised[k] = points[k].template up_to<2>() + height * normal[k];
    }
    return RaisedEnclosure{{raised[0](0, 0), raised[1](0, 0), raised[2](0, 0)},
                           firsts(raised),
                           seconds(raised),
                           firsts(points),
                           seconds(points),
                           firsts(normal),
                           area(0, 0),
                           {area(1, 0), area(0, 1)}};
}

}  // namespace endmill
