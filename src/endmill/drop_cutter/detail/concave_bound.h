// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

namespace endmill {

/// Whether a concave function stays at or below `limit` over 0 … 1, as far as few values
/// can prove it. Neighbouring values define lines that lie above the function beyond them
/// and so bound it. True is certain. False means that a value exceeds the limit, or that
/// the bounds do not decide.
/// \param function concave where it is finite; minus infinity outside an interval.
/// \param limit in the function's unit.
bool stays_below(const std::function<double(double)>& function, double limit);

}  // namespace endmill
