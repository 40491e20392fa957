// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/lost-surface/readings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "endmill/planning/path_interval.h"

namespace endmill {
namespace {

constexpr double chords_mm = 0.3;  // links are chords, shorter than their arc
constexpr double arc_step_mm = 0.5;
constexpr Interval arcs_u{344, 360};
constexpr Interval arcs_v{202, 214};
// Ranges in which the lengths of passes are sought, mm.
constexpr double length_below = 30;
constexpr double length_above = 5;
constexpr double most_half_difference = 15;
constexpr int golden_sections = 45;  // 1e-9 of the range

// Smallest value of a convex function on an interval, by golden sections.
double convex_minimum(const Interval& range, const std::function<double(double)>& f)
{
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double a = range.low;
    double b = range.high;
    double c = b - golden * (b - a);
    double d = a + golden * (b - a);
    double fc = f(c);
    double fd = f(d);
    for (int i = 0; i < golden_sections; ++i)
        if (fc < fd) {
            b = d;
            d = c;
            fd = fc;
            c = b - golden * (b - a);
            fc = f(c);
        } else {
            a = c;
            c = d;
            fc = fd;
            d = a + golden * (b - a);
            fd = f(d);
        }
    return std::min(fc, fd);
}

struct Row {
    std::array<int, 3> passes;
    std::array<double, 3> tcd_mm;
    double arc_mm;        // of the passes
    double other_arc_mm;  // of the links
};

// Share of an interval that the last pass may leave.
double most_rest(LastPath last_path)
{
    switch (last_path) {
        case LastPath::Border:
            return 0;
        case LastPath::Half:
            return 0.5;
        case LastPath::None:
            break;
    }
    return 1;
}

double row_excess(const Row& row, LastPath last_path, double interval_factor)
{
    const auto excess = [&](double forward, double backward) {
        double worst = std::max({0.0, forward - row.arc_mm, backward - row.arc_mm});
        for (int j = 0; j < 3; ++j) {
            const int passes = row.passes[j];
            const int backward_passes = passes / 2;
            const double links = row.tcd_mm[j] - (passes - backward_passes) * forward -
                                 backward_passes * backward;
            const double interval = interval_factor * row.other_arc_mm / (passes - 1);
            const double low =
                row.other_arc_mm - chords_mm - most_rest(last_path) * interval;
            worst = std::max({worst, links - row.other_arc_mm, low - links});
        }
        return worst;
    };
    return convex_minimum(
        {row.arc_mm - length_below, row.arc_mm + length_above}, [&](double mean) {
            return convex_minimum(
                {-most_half_difference, most_half_difference},
                [&](double half) { return excess(mean + half, mean - half); });
        });
}

}  // namespace

Surplus surplus_points(const EconomyTables& printed, const DecodedTables& decoded,
                       int direction, int tolerance)
{
    std::array<double, 3> surplus{};
    for (int j = 0; j < 3; ++j)
        surplus[j] = static_cast<double>(printed.runs[direction][tolerance][j].ncl) -
                     decoded.passes[direction][tolerance].points_a_pair *
                         decoded.counts[direction][tolerance][j] / 2.0;
    const auto [low, high] = std::ranges::minmax(surplus);
    return {low, high};
}

double interval_spread(const EconomyTables& printed, int direction, int tolerance,
                       double ratio)
{
    std::array<double, 3> products{};
    for (int j = 0; j < 3; ++j) {
        const BallCutter ball{table_diameters_mm[j] / 2};
        const double h = ratio * table_tolerances_mm[tolerance];
        products[j] = printed.runs[direction][tolerance][j].tcd_mm *
                      path_interval(ball, 0, h).chord;
    }
    const auto [low, high] = std::ranges::minmax(products);
    return high / low - 1;
}

double middle_ball_deviation(const EconomyTables& tables, int direction, int tolerance)
{
    const auto& row = tables.runs[direction][tolerance];
    const double share = std::log(table_diameters_mm[1] / table_diameters_mm[0]) /
                         std::log(table_diameters_mm[2] / table_diameters_mm[0]);
    const double expected =
        std::lerp(std::log(row[0].tcd_mm), std::log(row[2].tcd_mm), share);
    return 100 * (std::log(row[1].tcd_mm) - expected);
}

LinkContradiction link_contradiction(const EconomyTables& printed,
                                     const DecodedTables& decoded, LastPath last_path,
                                     double interval_factor)
{
    // The largest excess of the six rows, given up beyond `enough`.
    const auto worst_row = [&](const std::array<double, 2>& arcs, double enough) {
        double worst = 0;
        for (int row_number = 0; row_number < 6 && worst < enough; ++row_number) {
            const int k = row_number / 3;
            const int i = row_number % 3;
            Row row{decoded.counts[k][i], {}, arcs[k], arcs[1 - k]};
            for (int j = 0; j < 3; ++j)
                row.tcd_mm[j] = printed.runs[k][i][j].tcd_mm;
            worst = std::max(worst, row_excess(row, last_path, interval_factor));
        }
        return worst;
    };
    LinkContradiction least{1e9, 0, 0};
    const int steps_u = static_cast<int>(arcs_u.length() / arc_step_mm);
    const int steps_v = static_cast<int>(arcs_v.length() / arc_step_mm);
    for (int a = 0; a <= steps_u; ++a)
        for (int b = 0; b <= steps_v; ++b) {
            const std::array arcs{arcs_u.low + a * arc_step_mm,
                                  arcs_v.low + b * arc_step_mm};
            const double worst = worst_row(arcs, least.excess_mm);
            if (worst < least.excess_mm)
                least = {worst, arcs[0], arcs[1]};
        }
    return least;
}

}  // namespace endmill
