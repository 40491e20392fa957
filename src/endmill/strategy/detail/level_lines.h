// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/strategy/detail/part_samples.h"

namespace endmill {

/// A line on the net of samples, by the places where it crosses edges.
struct LevelLine {
    std::vector<SampleEdge> places;  ///< in order, at least two
    bool is_closed;                  ///< whether the last place joins the first
};

/// The lines on which `values`, taken as linear in each triangle, are `level`. A line runs across the seam of twins. The order of lines and their
/// directions depend on the numbers of the samples only.
/// \param samples of the part.
/// \param values  one for each sample.
/// \param near    samples outside which no value is below the level; if empty, any may be.
/// \param level   the lines are those on which the values are `level`.
std::vector<LevelLine> level_lines(const PartSamples& samples,
                                   std::span<const double> values,
                                   std::span<const std::int32_t> near = {},
                                   double level = 0);

/// The parts of `lines` on which `values` are above `level`. A part begins and ends one place
/// further, so that neighbouring parts leave nothing between them.
std::vector<LevelLine> where_positive(std::span<const LevelLine> lines,
                                      std::span<const double> values, double level = 0);

/// The share of an edge at which a smooth value that changes its sign along the edge is 0: on the
/// parabola through its values at both ends and at the linear estimate.
/// \param value of a share, 0 to 1.
template <typename Value>
double crossing_share(const Value& value)
{
    const double first = value(0.0);
    const double last = value(1.0);
    if ((first < 0) == (last < 0))
        return std::abs(first) < std::abs(last) ? 0 : 1;
    const double share = first / (first - last);
    if (!(share > 0 && share < 1))
        return share > 0 ? 1 : 0;
    // first + slope s + bow s^2
    const double bow = value(share) / (share * (share - 1));
    const double slope = last - first - bow;
    const double root = std::sqrt(std::max(0.0, slope * slope - 4 * bow * first));
    const double sum = -(slope + std::copysign(root, slope)) / 2;
    const double near = sum == 0 ? share : first / sum;
    const double found = near >= 0 && near <= 1 ? near : sum / bow;
    return found >= 0 && found <= 1 ? found : share;
}

/// The value at a place, linear between its samples.
inline double value_at(const SampleEdge& place, std::span<const double> values)
{
    return values[place.from] + place.share * (values[place.to] - values[place.from]);
}

}  // namespace endmill
