// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/figure-4/tables.h"

#include <algorithm>
#include <cmath>

namespace endmill {
namespace {

// Largest relative difference of the line from the data, in percent.
double largest_misfit_percent(const std::vector<CuttingSpeedDatum>& data,
                              const SpeedLine& line)
{
    double largest = 0;
    for (const auto& [phi_over_pi, speed] : data)
        largest =
            std::max(largest, std::abs(economic_speed(line, phi_over_pi) / speed - 1));
    return 100 * largest;
}

// Speed at which a tool of the constant C_b lasts for a life in min.
double speed_of_life(double cb, double alpha, double life_min)
{
    return cb / std::pow(life_min, alpha);
}

}  // namespace

std::vector<std::string> tool_life_columns()
{
    return {"row",
            "v_m_per_min",
            "ln_v",
            "width_over_diameter",
            "phi_deg",
            "phi_over_pi",
            "ln_phi_over_pi",
            "alpha",
            "alpha_off",
            "t0_min",
            "cb",
            "v1_m_per_min",
            "misfit_percent",
            "v_tg_m_per_min",
            "v_t0_m_per_min",
            "speed_change_percent",
            "fits",
            "fits_as_printed",
            "fits_in_order",
            "alpha_least",
            "alpha_greatest"};
}

void add_data(CsvTable& result, const PrintedSpeeds& printed,
              const std::vector<double>& widths, double printed_pi)
{
    for (std::size_t i = 0; i < printed.data.size(); ++i) {
        const double phi_over_pi = printed.phi_deg.at(i) / 180;
        const double speed = printed.data[i].v_m_per_min;
        add_named(result, "datum " + std::to_string(i + 1),
                  {{"v_m_per_min", speed},
                   {"ln_v", std::log(speed)},
                   {"width_over_diameter", widths.at(i)},
                   {"phi_deg", 180 * std::acos(1 - 2 * widths[i]) / printed_pi},
                   {"phi_over_pi", phi_over_pi},
                   {"ln_phi_over_pi", std::log(phi_over_pi)}});
    }
}

void add_line(CsvTable& result, const std::string& row, const PrintedSpeeds& printed,
              const SpeedLine& line)
{
    const double life = economic_tool_life(line.alpha, printed.costs);
    add_named(result, row,
              {{"alpha", line.alpha},
               {"t0_min", life},
               {"cb", tool_life_constant(line, life)},
               {"v1_m_per_min", line.v1_m_per_min},
               {"misfit_percent", largest_misfit_percent(printed.data, line)}});
}

void add_printed_eq_5(CsvTable& result, const PrintedSpeeds& printed, double cb,
                      double alpha)
{
    const double life = economic_tool_life(alpha, printed.costs);
    double off_tg = 0;
    double off_t0 = 0;
    for (std::size_t i = 0; i < printed.data.size(); ++i) {
        const auto& [phi_over_pi, speed] = printed.data[i];
        const double as_tg = speed_of_life(cb, alpha, life);
        const double as_t0 = speed_of_life(cb, alpha, phi_over_pi * life);
        add_named(result, "eq. (5), datum " + std::to_string(i + 1),
                  {{"v_tg_m_per_min", as_tg}, {"v_t0_m_per_min", as_t0}});
        off_tg = std::max(off_tg, 100 * std::abs(as_tg / speed - 1));
        off_t0 = std::max(off_t0, 100 * std::abs(as_t0 / speed - 1));
    }
    add_named(result, "eq. (5), life as T_g", {{"misfit_percent", off_tg}});
    add_named(result, "eq. (5), life as T0", {{"misfit_percent", off_t0}});
}

void add_costs(CsvTable& result, const ToolCosts& costs, double cb, double alpha)
{
    ToolCosts dear = costs;
    dear.tool *= 2;
    const double life = economic_tool_life(alpha, costs);
    const double longer = economic_tool_life(alpha, dear);
    const SpeedLine line{alpha, speed_of_life(cb, alpha, life)};
    const auto add = [&](const std::string& row, double constant) {
        const double speed = speed_of_life(constant, alpha, longer);
        add_named(
            result, "tool cost doubled, " + row,
            {{"t0_min", longer},
             {"cb", constant},
             {"v1_m_per_min", speed},
             {"speed_change_percent", 100 * std::abs(speed / line.v1_m_per_min - 1)}});
    };
    add("C_b follows", tool_life_constant(line, longer));
    add("C_b fixed", cb);
}

}  // namespace endmill
