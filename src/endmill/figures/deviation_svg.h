// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "endmill/deviation/deviation.h"

namespace endmill {

/// What surrounds a map of a deviation, and how it is drawn.
struct DeviationFigure {
    DeviationLimits limits = {};      ///< those that were asked for
    std::string title = "Deviation";  ///< above the map; at most 100 characters show
    std::vector<std::string>
        captions{};         ///< lines below the verdict; 150 characters show
    double width_px = 900;  ///< of the whole picture, 400 to 4000
    int squares = 240;      ///< at most, along the longer side of the map; 1 to 1000
};

/// The colour of a place with `left` mm left on it, as SVG writes it: magenta beyond the
/// tolerance, blue shades up to it, grey where less than a tenth of either limit, from
/// green over yellow to orange up to the scallop limit, and red beyond. Both limits are
/// raised by `verdict_slack`, so that the colours say what the verdict does.
/// \pre limits are positive.
std::string_view deviation_colour(double left, const DeviationLimits& limits);

/// A map of what is left on a part, seen along -z, as an SVG file: squares in the colours
/// of `deviation_colour`, each that of the cell in it with the largest share of its limit;
/// white where the part does not show. The deepest gouge and the highest rest are circled
/// and named if they are more than a tenth of their limit. Verdict, maxima and a scale are
/// beside it.
/// \param charts those that were measured.
/// \throws DomainError if an option is out of range, a limit is not positive, the
///         deviation is not one of `charts`, or a number is not finite.
std::string deviation_svg(const PartCharts& charts, const Deviation& deviation,
                          const DeviationFigure& figure);

}  // namespace endmill
