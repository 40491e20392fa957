// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "endmill/deviation/deviation.h"

namespace endmill {

/// Title, limits and size of a map of a deviation.
struct DeviationFigure {
    DeviationLimits limits = {};          ///< tolerance and scallop limit of the verdict
    std::string title = "Deviation";      ///< above the map; cut after 100 characters
    std::vector<std::string> captions{};  ///< lines below the verdict; cut after 150
    double width_px = 1040;               ///< of the whole picture, 400 to 4000
    int squares = 240;  ///< number along the longer side of the map, at most; 1 to 1000
};

/// The colour of a deviation of `left` mm, in the notation of SVG: magenta for a gouge
/// beyond the tolerance, shades of blue for smaller gouges, grey below a tenth of either
/// limit, green, yellow and orange for remaining stock up to the scallop limit, and red
/// beyond. `verdict_slack` is added to both limits, so that colours agree with the
/// verdict.
/// \pre limits are positive.
std::string_view deviation_colour(double left, const DeviationLimits& limits);

/// A map of the deviation seen along -z, as an SVG file, as wide as the part and with axes
/// in mm. Each square has the colour of its worst cell: the one with the largest deviation
/// divided by the limit. It is white where the part is not visible, and where the stock is
/// not judged because the cutter cannot touch the part; the scale names the latter. The
/// deepest gouge and the largest remaining stock are
/// circled and labelled if they exceed a tenth of their limit. Verdict, maxima and a
/// scale are beside the map.
/// \param charts those that the deviation was measured on.
/// \throws DomainError if an option is out of range, a limit is not positive, the
///         deviation does not belong to `charts`, or a number is not finite.
std::string deviation_svg(const PartCharts& charts, const Deviation& deviation,
                          const DeviationFigure& figure);

}  // namespace endmill
