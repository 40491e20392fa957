// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/path/tool_path.h"

/// \file
/// Less of a path or of a row of values, for drawing.

namespace endmill {

/// Points of a path that are drawn, and how far the drawing is from the path.
struct ReducedPath {
    std::vector<std::size_t> points;  ///< numbers of points, ascending
    double tolerance_mm = 0;          ///< no tip is farther from the drawn lines
    bool joins_moves = false;  ///< whether a line may stand for moves of several kinds
};

/// Chooses points of a path for drawing. The ends of each run of moves of one kind in one pass
/// remain. Within a run a point is left out if the chord that replaces it stays within the
/// tolerance (Douglas and Peucker). The tolerance is the smallest of 0 and the extent of the
/// tips over powers of two for which at most `most_points` remain. If the ends of the runs alone are
/// more, the same is done without regard to kinds and passes. Runs of more than 4096 points are
/// divided, so that of more than 4096 `most_points` points more than `most_points` may remain.
/// \param path        any number of points.
/// \param most_points at least 2.
/// \throws DomainError if `most_points` is less than 2.
ReducedPath reduced_path(const ToolPath& path, std::size_t most_points);

/// Numbers of values that are drawn: all if they are at most `most`, else the least and the
/// greatest of each of `most` / 2 runs of neighbours. Values that are not finite are skipped.
/// \param values any. \param most at least 2.
/// \return ascending.
/// \throws DomainError if `most` is less than 2.
std::vector<std::size_t> extremes(std::span<const float> values, std::size_t most);

}  // namespace endmill
