// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/deviation_areas.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace endmill {
namespace {

// The value that 99 % of the area does not reach, from a histogram over the leading bits
// of each value, that is in steps of 1/2048 of it.
double area_quantile(std::span<const float> values, std::span<const float> areas,
                     double share)
{
    constexpr int dropped_bits = 12;
    std::vector<double> bins(std::size_t{1} << (32 - 1 - dropped_bits));
    double total = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float value =
            values[i] > 0 ? values[i] : 0.0F;  // not -0: its bits are high
        bins[std::bit_cast<std::uint32_t>(value) >> dropped_bits] += areas[i];
        total += areas[i];
    }
    double sum = 0;
    for (std::uint32_t bin = 0; bin < bins.size(); ++bin) {
        sum += bins[bin];
        if (bins[bin] > 0 && sum >= share * total)
            return std::bit_cast<float>(bin << dropped_bits);
    }
    return 0;
}

}  // namespace

void add_areas(Deviation& deviation)
{
    double rest = 0;
    for (std::size_t i = 0; i < deviation.left.size(); ++i) {
        const double left = deviation.left[i];
        const double area = deviation.area[i];
        deviation.area_mm2 += area;
        rest += area * std::max(left, 0.0);
    }
    if (deviation.area_mm2 > 0)
        deviation.mean_scallop_mm = rest / deviation.area_mm2;
    deviation.p99_scallop_mm = area_quantile(deviation.left, deviation.area, 0.99);
}

}  // namespace endmill
