// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/previous_pass.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/detail/bracketed_newton.h"
#include "endmill/process/detail/quartic_roots.h"

// A condition base + turn cos(phi) + front tau is solved in two steps:
// 1. Its square is a quartic in u = tan(phi/2), whose roots and extrema split the curve.
//    Squaring adds false roots, so the sign of the condition itself at the middle of each
//    part decides where it really changes.
// 2. Between two such middles of different sign, Newton's method finds the root in p.

namespace endmill {
namespace {

double value(const PassCondition& condition, const PassPoint& point)
{
    return condition.base + condition.turn * point.cosine + condition.front * point.tau;
}

// The square of the condition as a polynomial in u = tan(phi/2). With
// tau^2 = 2 a sin(phi) - 2 b cos(phi) - R_p^2 it is a quartic.
Quartic squared(const PreviousPassCurve& curve, const PassCondition& condition)
{
    const double f2 = condition.front * condition.front;
    const double both = condition.turn * condition.turn;
    const double cosine = 2 * (condition.base * condition.turn + curve.rise * f2);
    const double sine = -2 * curve.across * f2;
    const double rest =
        condition.base * condition.base + curve.pick_feed * curve.pick_feed * f2;
    return {both + cosine + rest, 2 * sine, 2 * (rest - both), 2 * sine,
            both - cosine + rest};
}

double half_tangent(const PassPoint& point)
{
    return point.sine / (1 + point.cosine);
}

// The root of the condition in a bracket.
double solve(const PreviousPassCurve& curve, const PassCondition& condition, double low,
             double high)
{
    constexpr double least_step =
        1e-15;  // of p, whose magnitude is at most 1: its rounding
    const bool rises = value(condition, pass_point(curve, high)) > 0;
    return bracketed_newton({low, high, rises, (low + high) / 2}, least_step,
                            [&](double p) -> ValueAndSlope {
                                const PassPoint point = pass_point(curve, p);
                                return {value(condition, point),
                                        (condition.front * point.tau_by_x -
                                         condition.turn * point.sine * point.phi_by_x) *
                                            2 / (1 + p * p)};
                            });
}

}  // namespace

PreviousPassCurve::PreviousPassCurve(const BallEngagement& engagement)
    : pick_feed{engagement.previous == PreviousPass::Beside ? engagement.pick_feed_ratio
                                                            : 0},
      cos_mu{std::cos(engagement.mu)},
      sin_mu{std::sin(engagement.mu)},
      across{pick_feed * cos_mu},
      rise{pick_feed * sin_mu},
      amplitude{std::sqrt(std::max(0.0, 1 - pick_feed / 2) / 2)},
      reach{2 * std::sqrt(pick_feed) * amplitude},
      first{1}
{
    if (engagement.previous != PreviousPass::Beside || pick_feed >= 2)
        return;
    // nu begins at mu, which is the wall, unless the wall is behind the front plane
    // there.
    const double tau2 = 2 * across - pick_feed * pick_feed;
    const double half_sine = std::sin(engagement.mu / 2);
    if (tau2 > 0)
        first = (half_sine / amplitude) / (1 + std::sqrt(tau2) / reach);
    else
        first = sin_mu > 0 ? 1 : -1;
}

PassPoint pass_point(const PreviousPassCurve& curve, double p)
{
    const double sine = 2 * p / (1 + p * p);
    const double cosine = (1 - p) * (1 + p) / (1 + p * p);
    const double half_sine = curve.amplitude * sine;
    const double half_cosine = std::sqrt((1 - half_sine) * (1 + half_sine));
    const double sin_nu = 2 * half_sine * half_cosine;
    const double cos_nu = 1 - 2 * half_sine * half_sine;
    return {cos_nu * curve.cos_mu + sin_nu * curve.sin_mu,
            sin_nu * curve.cos_mu - cos_nu * curve.sin_mu, curve.reach * cosine,
            -curve.reach * sine, -2 * curve.amplitude * cosine / half_cosine};
}

double pass_parameter(const PreviousPassCurve& curve, double u)
{
    const double sine = 2 * u / (1 + u * u);
    const double cosine = (1 - u) * (1 + u) / (1 + u * u);
    const double sin_nu = cosine * curve.cos_mu + sine * curve.sin_mu;
    const double cos_nu = sine * curve.cos_mu - cosine * curve.sin_mu;
    const double half_sine = sin_nu / std::sqrt(2 * (1 + std::max(cos_nu, 0.0)));
    const double tau2 = 2 * (curve.across * sine - curve.rise * cosine) -
                        curve.pick_feed * curve.pick_feed;
    if (tau2 <= 0)  // behind the front plane, beyond an end of the curve
        return half_sine > 0 ? 1 : curve.first;
    const double p = (half_sine / curve.amplitude) / (1 + std::sqrt(tau2) / curve.reach);
    return std::clamp(p, curve.first, 1.0);
}

SignChanges sign_changes(const PreviousPassCurve& curve, const PassCondition& condition)
{
    SignChanges changes;
    if (curve.first >= 1)
        return changes;
    const double u_low = half_tangent(pass_point(curve, 1));
    const double u_high = half_tangent(pass_point(curve, curve.first));
    RootsAndExtrema breaks;
    if (u_low < u_high)
        breaks = roots_and_extrema(squared(curve, condition), u_low, u_high);
    double from = curve.first;
    double last_middle = from;
    for (int k = breaks.count; k >= 0; --k) {
        const double to = k > 0 ? pass_parameter(curve, breaks.at[k - 1]) : 1;
        const double middle = (from + to) / 2;
        const bool is_positive = value(condition, pass_point(curve, middle)) > 0;
        if (k == breaks.count)
            changes.is_positive = is_positive;
        else if (is_positive != (changes.is_positive == (changes.count % 2 == 0)))
            changes.at[changes.count++] = solve(curve, condition, last_middle, middle);
        last_middle = middle;
        from = to;
    }
    return changes;
}

}  // namespace endmill
