// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace endmill {

/// Memory in bytes that a point of a path takes at most until its files are written: the
/// path while it grows, and the text of one file.
inline constexpr double bytes_per_path_point = 900;

/// The most points of a path that fit `memory_gib`.
/// \pre 0 <= memory_gib
std::size_t most_path_points(double memory_gib);

/// Refuses, before the work, a path that would not fit `memory_gib`. Estimates of its
/// `points` are good to a factor of two: a path is refused that would not fit if it had
/// half of them.
/// \throws LimitError that names points, need and limit.
void require_path_memory(double points, double memory_gib);

}  // namespace endmill
