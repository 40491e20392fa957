// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace endmill {

inline constexpr double mm_per_m = 1000;
inline constexpr double mm_per_inch = 25.4;  // exact since 1959
inline constexpr double seconds_per_min = 60;
inline constexpr double bytes_per_gib = 0x1p30;

}  // namespace endmill
