// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_limits.h"

#include <cmath>
#include <numbers>

#include "endmill/core/detail/units.h"

namespace endmill {
namespace {

constexpr double newton_per_kgf = 9.80665;
// kgf mm rpm per kW. Source: [ParkMaeng, eq. (19)].
constexpr double paper_power_constant = 974000;

// The f at which a + b f reaches `most`, or std::nullopt if it never does.
std::optional<double> linear_bound(double a, double b, double most)
{
    if (a > most)
        return 0;
    const double bound = (most - a) / b;
    return std::isfinite(bound) ? std::optional{bound} : std::nullopt;
}

// The f at which (f A + h B)^2 + (r1 f A + r2 h B)^2 reaches most^2, with chip = A and
// edge = h B. This is the positive root of a quadratic, in a form without cancellation.
std::optional<double> force_bound(const CuttingMaterial& material, double chip,
                                  double edge, double most)
{
    const double square = chip * chip * (1 + material.r1 * material.r1);
    const double half_linear = chip * edge * (1 + material.r1 * material.r2);
    const double edge_alone = edge * std::hypot(1, material.r2);
    if (edge_alone > most)
        return 0;
    const double left = (most - edge_alone) * (most + edge_alone);
    const double bound =
        left / (half_linear + std::sqrt(half_linear * half_linear + square * left));
    return std::isfinite(bound) ? std::optional{bound} : std::nullopt;
}

// Force in N per unit of the sums and mm of chip thickness.
double force_scale(const LoadModel& model)
{
    return model.material.specific_resistance_n_per_mm2 * model.radius;
}

}  // namespace

EdgeSums scaled(const EdgeSums& sums, double factor)
{
    return {factor * sums.chip, factor * sums.edge, factor * sums.chip_torque,
            factor * sums.edge_torque};
}

CuttingLoads cutting_loads(const LoadModel& model, const EdgeSums& sums,
                           double feed_per_tooth_mm)
{
    const CuttingMaterial& material = model.material;
    const double chip = feed_per_tooth_mm * sums.chip;
    const double edge = material.edge_thickness_mm * sums.edge;
    const double radial = model.form == LimitForm::Paper
                              ? material.r1 * (chip + edge)
                              : material.r1 * chip + material.r2 * edge;
    const double scale = force_scale(model);
    const double torque = feed_per_tooth_mm * sums.chip_torque +
                          material.edge_thickness_mm * sums.edge_torque;
    return {scale * std::hypot(chip + edge, radial),
            scale * (material.r3 * chip + material.r4 * edge),
            scale * model.radius * torque / mm_per_m};
}

FeedBounds feed_bounds(const LoadModel& model, const EdgeSums& sums,
                       const LoadLimits& limits)
{
    const CuttingMaterial& material = model.material;
    const double scale = force_scale(model);
    const double edge = material.edge_thickness_mm * sums.edge;
    FeedBounds bounds;
    if (limits.cutting_force_n) {
        const double most = *limits.cutting_force_n / scale;
        bounds.cutting_force =
            model.form == LimitForm::Paper
                ? linear_bound(edge, sums.chip, most / std::hypot(1, material.r1))
                : force_bound(material, sums.chip, edge, most);
    }
    if (limits.thrust_n)
        bounds.thrust = linear_bound(material.r4 * edge, material.r3 * sums.chip,
                                     *limits.thrust_n / scale);
    if (limits.torque_n_m)
        bounds.torque =
            linear_bound(material.edge_thickness_mm * sums.edge_torque, sums.chip_torque,
                         mm_per_m * *limits.torque_n_m / (scale * model.radius));
    return bounds;
}

double cutting_power_w(LimitForm form, double torque_n_m, double spindle_rpm)
{
    constexpr double watt_per_kw = 1000;
    if (form == LimitForm::Paper)
        return watt_per_kw * spindle_rpm * (mm_per_m * torque_n_m / newton_per_kgf) /
               paper_power_constant;
    return 2 * std::numbers::pi * spindle_rpm * torque_n_m / seconds_per_min;
}

std::optional<double> equivalent_radius(const LoadModel& model, const EdgeSums& sums,
                                        double feed_per_tooth_mm)
{
    const double h = model.material.edge_thickness_mm;
    const double force = feed_per_tooth_mm * sums.chip + h * sums.edge;
    const double torque = feed_per_tooth_mm * sums.chip_torque + h * sums.edge_torque;
    if (!(force > 0))
        return std::nullopt;
    return model.radius * torque / force;
}

}  // namespace endmill
