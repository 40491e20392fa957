// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace endmill {

/// Round numbers that cover `low` to `high`: multiples of 1, 2 or 5 times a power of ten,
/// about `count` of them; the first is at or below `low`, the last at or above `high`.
/// \pre finite, low <= high, count > 0.
std::vector<double> round_ticks(double low, double high, int count);

/// Round numbers within `low` to `high`, as above; none outside.
/// \pre finite, low <= high, count > 0.
std::vector<double> ticks_within(double low, double high, int count);

/// The distance of neighbouring ticks; 1 if there are fewer than two.
double step_of(const std::vector<double>& ticks);

/// The text of a tick, rounded to the digits of the step.
std::string tick_text(double tick, double step);

}  // namespace endmill
