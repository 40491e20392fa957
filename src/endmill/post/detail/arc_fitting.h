// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/path/tool_path.h"
#include "endmill/post/control.h"
#include "endmill/post/detail/arc.h"

namespace endmill {

/// Limits and number format of fitted arcs.
struct ArcFitting {
    double tolerance_mm = 0;         ///< above 0: largest distance of arc and path
    ArcForm form = ArcForm::Centre;  ///< words of the block
    int decimals = 4;                ///< digits after the point of the words, 0 to 9
    double unit_mm = 1;              ///< mm, length of one unit of the program
};

/// An arc that replaces several moves of a path.
struct FittedArc {
    std::size_t last;              ///< index of the path point at which the arc ends
    Arc arc;                       ///< as the control reads it from the rounded words
    std::optional<double> radius;  ///< mm, for the form with R
    double error_mm;  ///< bound of the distance between the arc and the moves
};

/// The longest arc that a greedy search finds from point `first` of `path`. It replaces
/// the moves to the points `first` + 1 to `last`. Start and end of the arc are the points
/// themselves, rounded as the program has them. The arc lies in a plane of G17, G18 or
/// G19, turns by less than half a turn, replaces at least three moves, and has a radius
/// from 0.05 mm to 10 m. Its distance from the moves, their whole length included, is at
/// most the tolerance, with all rounding of the words included. The distance of the points
/// alone is at most a quarter of it and two units of the last decimal.
/// \param path the path.
/// \param first index of the start.
/// \param end one past the last point that the arc may replace; the moves to the points
///        between have equal conditions.
/// \param fitting limits and format.
/// \return std::nullopt if no arc is possible.
/// \pre first < end <= path.points.size()
/// Source: docs/methods/removal.md, section 6.
std::optional<FittedArc> longest_arc(const ToolPath& path, std::size_t first,
                                     std::size_t end, const ArcFitting& fitting);

}  // namespace endmill
