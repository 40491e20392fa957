// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/table_match.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace endmill {
namespace {

// A cell is expected within 2 % on either side without any evidence.
constexpr double expected_share = 0.04;
// Printed with one decimal: 20 809.3 and 20 809.4 differ by one unit and rounding.
constexpr double travel_rounding_mm = 1e-6;
// Smallest step of the search for a width, as a share of the range: 5e-6 mm of a height.
constexpr double least_step = 0x1p-26;
constexpr int bisections = 6;

double cell_width(TableQuantity quantity)
{
    return quantity == TableQuantity::Ncl ? 1 : 2 * matched_travel_mm;
}

bool is_matched(TableQuantity quantity, double difference)
{
    return quantity == TableQuantity::Ncl
               ? difference == 0
               : std::abs(difference) <= matched_travel_mm + travel_rounding_mm;
}

// log2 of the number of ways to choose `chosen` of `all`.
double choice_bits(int chosen, int all)
{
    const auto log_factorial = [](int n) { return std::lgamma(n + 1.0); };
    return (log_factorial(all) - log_factorial(chosen) - log_factorial(all - chosen)) /
           std::log(2.0);
}

// Distance from values[index] in the direction of `sign` up to which `is_good` holds.
double good_distance(std::span<const double> values, std::size_t index,
                     const Interval& range, double sign,
                     const std::function<bool(std::span<const double>)>& is_good)
{
    std::vector<double> moved{values.begin(), values.end()};
    const double most = sign > 0 ? range.high - values[index] : values[index] - range.low;
    const auto holds = [&](double distance) {
        moved[index] = values[index] + sign * distance;
        return is_good(moved);
    };
    double good = 0;
    double step = least_step * range.length();
    while (step < most && holds(step)) {
        good = step;
        step *= 4;
    }
    if (step >= most) {
        if (most <= 0 || holds(most))
            return std::max(most, 0.0);
        step = most;
    }
    for (int i = 0; i < bisections; ++i) {
        const double middle = (good + step) / 2;
        (holds(middle) ? good : step) = middle;
    }
    return good;
}

}  // namespace

double deviation_bits(TableQuantity quantity, double difference)
{
    const double unit = cell_width(quantity) / 2;
    const double share = difference / unit;
    return std::log2(1 + share * share) / 2;
}

bool is_left_out(const DirectionCost& target)
{
    return target.ncl == 0;
}

double deviation_bits(const DirectionCost& run, const DirectionCost& target)
{
    if (is_left_out(target))
        return 0;
    const double points = static_cast<double>(run.ncl) - static_cast<double>(target.ncl);
    return deviation_bits(TableQuantity::Ncl, points) +
           deviation_bits(TableQuantity::Tcd, run.tcd_mm - target.tcd_mm);
}

double deviation_bits(const EconomyTables& tables, const EconomyTables& target)
{
    double bits = 0;
    for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                bits += deviation_bits(tables.runs[k][i][j], target.runs[k][i][j]);
    return bits;
}

TableMatch table_match(const EconomyTables& tables, const EconomyTables& target,
                       std::span<const Parameter> directions,
                       std::span<const TableQuantity> quantities)
{
    TableMatch match;
    int cells = 0;
    double squares = 0;
    const auto compare = [&](TableQuantity quantity, double computed, double wanted) {
        const double difference = computed - wanted;
        const double percent = 100 * std::abs(difference) / wanted;
        match.worst_percent = std::max(match.worst_percent, percent);
        squares += percent * percent;
        match.deviation += deviation_bits(quantity, difference);
        ++cells;
        if (!is_matched(quantity, difference))
            return;
        ++(quantity == TableQuantity::Ncl ? match.ncl : match.tcd);
        match.information += std::log2(expected_share * wanted / cell_width(quantity));
    };
    for (const Parameter direction : directions)
        for (const TableQuantity quantity : quantities)
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) {
                    const double wanted = target.cell(quantity, direction, i, j);
                    if (wanted != 0)  // not left out
                        compare(quantity, tables.cell(quantity, direction, i, j), wanted);
                }
    match.rms_percent = cells > 0 ? std::sqrt(squares / cells) : 0;
    match.choice = choice_bits(match.ncl + match.tcd, cells);
    return match;
}

double bits_of_values(std::span<const double> values, std::span<const Interval> ranges,
                      const std::function<int(std::span<const double>)>& matched)
{
    const int number = matched(values);
    const auto is_good = [&](std::span<const double> moved) {
        return matched(moved) >= number;
    };
    double bits = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double width = good_distance(values, i, ranges[i], 1, is_good) +
                             good_distance(values, i, ranges[i], -1, is_good);
        const double least = 2 * least_step * ranges[i].length();
        bits += std::max(1.0, std::log2(ranges[i].length() / std::max(width, least)));
    }
    return bits;
}

}  // namespace endmill
