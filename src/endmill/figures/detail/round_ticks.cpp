// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/round_ticks.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/text.h"

namespace endmill {
namespace {

// Width of a range below which its ticks would differ only in the rounding of their
// labels, as a share of its largest number, or absolute for numbers below 1.
constexpr double least_range_share = 1e-9;

// A number this share of a step outside the range counts as within: it is at the end of
// the range, but for rounding.
constexpr double end_share = 1e-6;

}  // namespace

// The step is the smallest of 1, 2, 5, 10 times a power of ten that is at least the rough
// step. A range of zero width gets the least step.
std::vector<double> round_ticks(double low, double high, int count)
{
    const double least =
        std::max({std::abs(low), std::abs(high), 1.0}) * least_range_share;
    const double rough = std::max(high - low, least) / count;
    const double power = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * power;
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough) {
            step = factor * power;
            break;
        }
    const double first = std::floor(low / step);
    const double last = std::max(std::ceil(high / step), first + 1);
    std::vector<double> ticks;
    for (double k = first; k <= last; ++k)
        ticks.push_back(k * step);
    return ticks;
}

std::vector<double> ticks_within(double low, double high, int count)
{
    std::vector<double> ticks = round_ticks(low, high, count);
    const double leeway = end_share * step_of(ticks);
    std::erase_if(
        ticks, [&](double tick) { return tick < low - leeway || tick > high + leeway; });
    return ticks;
}

double step_of(const std::vector<double>& ticks)
{
    return ticks.size() > 1 ? ticks[1] - ticks[0] : 1;
}

std::string tick_text(double tick, double step)
{
    const double digits = std::max(0.0, -std::floor(std::log10(step)));
    const double power = std::pow(10, digits);
    return to_text(std::round(tick * power) / power + 0.0);
}

}  // namespace endmill
