// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/tool_life.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

bool is_positive(double value)
{
    return std::isfinite(value) && value > 0;
}

void require_sound(std::span<const CuttingSpeedDatum> data)
{
    require(!data.empty(), "tool life: need a datum");
    for (const CuttingSpeedDatum& datum : data) {
        require(datum.phi_over_pi > 0 && datum.phi_over_pi <= 1,
                "tool life: need 0 < phi/pi <= 1");
        require(is_positive(datum.v_m_per_min), "tool life: need 0 < cutting speed");
    }
}

struct LogMeans {
    double angle;  // mean of ln(phi/pi)
    double speed;  // mean of ln V
};

LogMeans log_means(std::span<const CuttingSpeedDatum> data)
{
    LogMeans sum{0, 0};
    for (const CuttingSpeedDatum& datum : data) {
        sum.angle += std::log(datum.phi_over_pi);
        sum.speed += std::log(datum.v_m_per_min);
    }
    const auto count = static_cast<double>(data.size());
    return {sum.angle / count, sum.speed / count};
}

// Slope of ln V against ln(phi/pi), computed about the means to avoid cancellation.
double slope(std::span<const CuttingSpeedDatum> data, const LogMeans& means)
{
    double angle_angle = 0;
    double angle_speed = 0;
    for (const CuttingSpeedDatum& datum : data) {
        const double angle = std::log(datum.phi_over_pi) - means.angle;
        angle_angle += angle * angle;
        angle_speed += angle * (std::log(datum.v_m_per_min) - means.speed);
    }
    return angle_speed / angle_angle;
}

}  // namespace

void require_sound(const SpeedLine& line)
{
    require(line.alpha > 0 && line.alpha < 1, "tool life: need 0 < alpha < 1");
    require(is_positive(line.v1_m_per_min), "tool life: need 0 < v1");
}

SpeedLine fitted_speed_line(std::span<const CuttingSpeedDatum> data)
{
    require_sound(data);
    require(std::ranges::any_of(data,
                                [&](const CuttingSpeedDatum& datum) {
                                    return datum.phi_over_pi != data.front().phi_over_pi;
                                }),
            "tool life: need two different phi/pi");
    const double alpha = -slope(data, log_means(data));
    if (!(alpha > 0 && alpha < 1))
        throw GeometryError{
            "the cutting speed must fall as the engaged angle grows, and less than "
            "inversely: between alpha 0 and 1; the data give " +
            (std::isfinite(alpha) ? to_text(alpha) : "none")};
    return fitted_speed_line(data, alpha);
}

SpeedLine fitted_speed_line(std::span<const CuttingSpeedDatum> data, double alpha)
{
    require_sound(data);
    require(alpha > 0 && alpha < 1, "tool life: need 0 < alpha < 1");
    const LogMeans means = log_means(data);
    const double v1 = std::exp(means.speed + alpha * means.angle);
    if (!is_positive(v1))
        throw GeometryError{"the cutting speeds give a speed V1 that is not above 0"};
    return {alpha, v1};
}

double economic_tool_life(double alpha, const ToolCosts& costs)
{
    require(alpha > 0 && alpha < 1, "tool life: need 0 < alpha < 1");
    require(std::isfinite(costs.change_min) && costs.change_min >= 0,
            "tool life: need 0 <= time of a tool change");
    require(std::isfinite(costs.tool) && costs.tool >= 0,
            "tool life: need 0 <= cost of a tool");
    require(is_positive(costs.machine_per_min),
            "tool life: need 0 < cost of the machine");
    const double change = costs.change_min + costs.tool / costs.machine_per_min;
    const double life = (1 / alpha - 1) * change;
    require(is_positive(life),
            "tool life: a tool that costs nothing has no economic life; need a cost or a "
            "time of a tool change");
    return life;
}

double tool_life_constant(const SpeedLine& line, double tool_life_min)
{
    require_sound(line);
    require(is_positive(tool_life_min), "tool life: need 0 < tool life");
    return line.v1_m_per_min * std::pow(tool_life_min, line.alpha);
}

double economic_speed(const SpeedLine& line, double phi_over_pi)
{
    require_sound(line);
    require(phi_over_pi > 0 && phi_over_pi <= 1, "economic_speed: need 0 < phi/pi <= 1");
    return line.v1_m_per_min * std::pow(phi_over_pi, -line.alpha);
}

double spindle_speed_rpm(double v_m_per_min, double radius_mm)
{
    require(is_positive(v_m_per_min), "spindle_speed_rpm: need 0 < cutting speed");
    require(is_positive(radius_mm), "spindle_speed_rpm: need 0 < radius");
    return mm_per_m * v_m_per_min / (2 * std::numbers::pi * radius_mm);
}

}  // namespace endmill
