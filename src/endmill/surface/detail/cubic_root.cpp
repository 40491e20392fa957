// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/cubic_root.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/detail/bracketed_newton.h"

namespace endmill {
namespace {

using Bernstein = std::array<double, 4>;

// Value and derivative by de Casteljau's algorithm.
ValueAndSlope evaluate(const Bernstein& b, double t)
{
    const double s = 1 - t;
    const double b01 = s * b[0] + t * b[1];
    const double b12 = s * b[1] + t * b[2];
    const double b23 = s * b[2] + t * b[3];
    const double b012 = s * b01 + t * b12;
    const double b123 = s * b12 + t * b23;
    return {s * b012 + t * b123, 3 * (b123 - b012)};
}

// The ends of the monotone pieces of the cubic in (0, 1], in rising order; the last one
// is 1.
struct PieceEnds {
    std::array<double, 3> at;
    int count;
};

PieceEnds monotone_pieces(const Bernstein& b)
{
    PieceEnds ends{{}, 0};
    const auto add = [&](double t) {
        if (0 < t && t < 1)
            ends.at[ends.count++] = t;
    };
    // The derivative is the quadratic d0 (1-t)^2 + 2 d1 t (1-t) + d2 t^2 = A t^2 + 2 B t
    // + d0.
    const double d0 = b[1] - b[0];
    const double d1 = b[2] - b[1];
    const double d2 = b[3] - b[2];
    const double A = d0 - 2 * d1 + d2;
    const double B = d1 - d0;
    const double discriminant = B * B - A * d0;
    const bool rises_throughout = d0 >= 0 && d1 >= 0 && d2 >= 0;
    if (!rises_throughout && discriminant > 0) {
        // The root of larger size first, then the other one from their product, so that
        // no digits cancel. A root that does not exist becomes infinite and is not in (0,
        // 1).
        const double q = -(B + std::copysign(std::sqrt(discriminant), B));
        const double one = q / A;
        const double other = d0 / q;
        add(std::min(one, other));
        add(std::max(one, other));
    }
    ends.at[ends.count++] = 1;
    return ends;
}

// The root in [low, high], where the cubic rises from below zero to zero or above. Not
// `bracketed_newton`: only a short Newton step, not a short bisection, proves that the
// root is near.
double bracketed_root(const Bernstein& b, double low, double high)
{
    // Halving alone would need 60 steps; Newton steps end after about four.
    constexpr int most_steps = 80;
    // After a Newton step shorter than this, the next step would be below rounding.
    constexpr double last_step = 1e-9;
    // Most roots are near the start of the first piece, where the cubic is nearly the
    // parabola b0 + 2 B t + A t^2.
    const double B = 1.5 * (b[1] - b[0]);
    const double A = 3 * (b[2] - 2 * b[1] + b[0]);
    const double near_start = -b[0] / (B + std::sqrt(B * B - A * b[0]));
    double t = low < near_start && near_start < high ? near_start : (low + high) / 2;
    for (int step = 0; step < most_steps; ++step) {
        const ValueAndSlope here = evaluate(b, t);
        (here.value < 0 ? low : high) = t;
        const auto [next, is_newton] = root_step(low, high, t, here);
        const double length = std::abs(next - t);
        t = next;
        if (length <= (is_newton ? last_step : 0))
            break;
    }
    return t;
}

}  // namespace

std::optional<double> first_rise_to_zero(const std::array<double, 4>& bernstein)
{
    if (*std::ranges::max_element(bernstein) < 0)
        return std::nullopt;  // the cubic lies in the convex hull of its coefficients
    const PieceEnds ends = monotone_pieces(bernstein);
    double start = 0;
    for (int piece = 0; piece < ends.count; ++piece) {
        const double end = ends.at[piece];
        const double value = end == 1 ? bernstein[3] : evaluate(bernstein, end).value;
        if (value >= 0)
            return bracketed_root(bernstein, start, end);
        start = end;
    }
    return std::nullopt;
}

std::array<double, 4> restrict_to_upper_end(const std::array<double, 4>& bernstein,
                                            double from)
{
    const double s = 1 - from;
    const auto& b = bernstein;
    const double b01 = s * b[0] + from * b[1];
    const double b12 = s * b[1] + from * b[2];
    const double b23 = s * b[2] + from * b[3];
    const double b012 = s * b01 + from * b12;
    const double b123 = s * b12 + from * b23;
    return {s * b012 + from * b123, b123, b23, b[3]};
}

}  // namespace endmill
