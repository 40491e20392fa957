// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

/// \file
/// Relates the number of points of a path to the memory that planning and writing
/// it needs.

namespace endmill {

/// Upper bound in bytes of the memory for each point of a path until its files are
/// written: the growing path and the text of one file.
inline constexpr double bytes_per_path_point = 900;

/// The greatest number of path points for which `memory_gib` suffices.
/// \pre 0 <= memory_gib
std::size_t most_path_points(double memory_gib);

/// Refuses a path that is too long for `memory_gib` before it is planned. The estimated
/// number of points is right to a factor of two. A path is therefore refused only if half
/// of the estimate is already too many.
/// \param points     estimated number of points.
/// \param memory_gib available memory.
/// \throws LimitError with the number of points, the memory that they need and the limit.
void require_path_memory(double points, double memory_gib);

}  // namespace endmill
