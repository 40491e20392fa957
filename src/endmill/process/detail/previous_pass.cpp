// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/previous_pass.h"

#include <algorithm>
#include <cmath>

#include "endmill/process/detail/bracketed_newton.h"
#include "endmill/process/detail/quartic_stations.h"

namespace endmill {
namespace {

double value(const PassCondition& condition, const PassPoint& point)
{
    return condition.base + condition.turn * point.cosine + condition.front * point.tau;
}

// The square of the condition, with tau^2 = 2 a sin(phi) - 2 b cos(phi) - R_p^2, is a quartic in
// u = tan(phi/2).
Quartic squared(const EngagedRegion& region, const PassCondition& condition)
{
    const double f2 = condition.front * condition.front;
    const double both = condition.turn * condition.turn;
    const double cosine = 2 * (condition.base * condition.turn + region.rise * f2);
    const double sine = -2 * region.across * f2;
    const double rest =
        condition.base * condition.base + region.pick_feed * region.pick_feed * f2;
    return {both + cosine + rest, 2 * sine, 2 * (rest - both), 2 * sine,
            both - cosine + rest};
}

double half_tangent(const PassPoint& point)
{
    return point.sine / (1 + point.cosine);
}

// The root of the condition in a bracket.
double solve(const EngagedRegion& region, const PassCondition& condition, double low,
             double high)
{
    constexpr double least_step = 1e-15;  // of p, which is at most 1: about its rounding
    const bool rises = value(condition, pass_point(region, high)) > 0;
    return bracketed_newton({low, high, rises, (low + high) / 2}, least_step,
                            [&](double p) -> ValueAndSlope {
                                const PassPoint point = pass_point(region, p);
                                return {value(condition, point),
                                        (condition.front * point.tau_by_x -
                                         condition.turn * point.sine * point.phi_by_x) *
                                            2 / (1 + p * p)};
                            });
}

}  // namespace

PassPoint pass_point(const EngagedRegion& region, double p)
{
    const double sine = 2 * p / (1 + p * p);
    const double cosine = (1 - p) * (1 + p) / (1 + p * p);
    const double half_sine = region.amplitude * sine;
    const double half_cosine = std::sqrt((1 - half_sine) * (1 + half_sine));
    const double sin_nu = 2 * half_sine * half_cosine;
    const double cos_nu = 1 - 2 * half_sine * half_sine;
    return {cos_nu * region.cos_mu + sin_nu * region.sin_mu,
            sin_nu * region.cos_mu - cos_nu * region.sin_mu, region.reach * cosine,
            -region.reach * sine, -2 * region.amplitude * cosine / half_cosine};
}

double pass_parameter(const EngagedRegion& region, double u)
{
    const double sine = 2 * u / (1 + u * u);
    const double cosine = (1 - u) * (1 + u) / (1 + u * u);
    const double sin_nu = cosine * region.cos_mu + sine * region.sin_mu;
    const double cos_nu = sine * region.cos_mu - cosine * region.sin_mu;
    const double half_sine = sin_nu / std::sqrt(2 * (1 + std::max(cos_nu, 0.0)));
    const double tau2 = 2 * (region.across * sine - region.rise * cosine) -
                        region.pick_feed * region.pick_feed;
    if (tau2 <= 0)  // behind the front plane, beyond one of the border's ends
        return half_sine > 0 ? 1 : region.first;
    const double p =
        (half_sine / region.amplitude) / (1 + std::sqrt(tau2) / region.reach);
    return std::clamp(p, region.first, 1.0);
}

SignChanges sign_changes(const EngagedRegion& region, const PassCondition& condition)
{
    SignChanges changes;
    if (region.first >= 1)
        return changes;
    const double u_low = half_tangent(pass_point(region, 1));
    const double u_high = half_tangent(pass_point(region, region.first));
    QuarticStations stations;
    if (u_low < u_high)
        stations = quartic_stations(squared(region, condition), u_low, u_high);
    double from = region.first;
    double last_middle = from;
    for (int k = stations.count; k >= 0; --k) {
        const double to = k > 0 ? pass_parameter(region, stations.at[k - 1]) : 1;
        const double middle = (from + to) / 2;
        const bool is_positive = value(condition, pass_point(region, middle)) > 0;
        if (k == stations.count)
            changes.is_positive = is_positive;
        else if (is_positive != (changes.is_positive == (changes.count % 2 == 0)))
            changes.at[changes.count++] = solve(region, condition, last_middle, middle);
        last_middle = middle;
        from = to;
    }
    return changes;
}

}  // namespace endmill
