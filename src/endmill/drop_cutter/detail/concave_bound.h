// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>

namespace endmill {

/// Whether a concave function stays at or below `limit` over 0 … 1, as far as few values
/// can show: no where one is above it, and where the lines through neighbouring values,
/// which lie above the function where they are drawn out, leave it open.
/// \param function may be minus infinity, outside an interval.
bool stays_below(const std::function<double(double)>& function, double limit);

}  // namespace endmill
