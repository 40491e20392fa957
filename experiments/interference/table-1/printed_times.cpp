// SPDX-License-Identifier: GPL-3.0-or-later
#include "interference/table-1/printed_times.h"

#include <algorithm>
#include <array>

#include "support/named_cells.h"

namespace endmill {
namespace {

constexpr double rounding_s = 0.5;  // of the printed seconds
constexpr std::array<std::size_t, 3> methods{1, 2, 3};

NamedCells ratio_cells(const Interval& ratio)
{
    return {{"ratio_least", ratio.low}, {"ratio_greatest", ratio.high}};
}

// The method whose time is below all others within the rounding; "none" without one.
std::string fastest(const char* column)
{
    for (const std::size_t one : methods) {
        const bool is_first = std::ranges::all_of(methods, [&](std::size_t other) {
            return other == one ||
                   printed_range({one, column}).high < printed_range({other, column}).low;
        });
        if (is_first)
            return method_name(one);
    }
    return "none";
}

}  // namespace

Interval printed_range(const PrintedTime& time)
{
    const double seconds = published_number(
        "interference/table-1", "print, " + method_name(time.method), time.column);
    return {seconds - rounding_s, seconds + rounding_s};
}

Interval printed_ratio(const PrintedTime& over, const PrintedTime& under)
{
    const Interval a = printed_range(over);
    const Interval b = printed_range(under);
    return {a.low / b.high, a.high / b.low};
}

bool contains(const Interval& range, double value)
{
    return range.low <= value && value <= range.high;
}

std::string method_name(std::size_t method)
{
    return "method " + std::to_string(method);
}

void add_printed(CsvTable& result, const Interval& proportional)
{
    for (const std::size_t method : methods) {
        const Interval ratio = printed_ratio({method, seconds_100}, {method, seconds_50});
        NamedCells cells = ratio_cells(ratio);
        cells.emplace_back(
            "print_allows_proportional",
            word(ratio.low <= proportional.high && ratio.high >= proportional.low));
        add_named(result, "print, " + method_name(method) + ", 100 to 50", cells);
    }
    constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{1, 2}, {2, 3}, {1, 3}}};
    for (const auto& [planes, column] :
         {std::pair{"100", seconds_100}, std::pair{"50", seconds_50}}) {
        const std::string begin = std::string{"print, "} + planes + " planes, ";
        for (const auto& [one, other] : pairs)
            add_named(result, begin + method_name(one) + " to " + std::to_string(other),
                      ratio_cells(printed_ratio({one, column}, {other, column})));
        add_named(result, begin + "fastest", {{"printed_fastest", fastest(column)}});
    }
}

}  // namespace endmill
