// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "endmill/core/angle.h"

namespace endmill {

/// The length of passes in a direction.
struct DirectionTravel {
    Angle direction;                   ///< of the passes, from +x towards +y
    std::optional<double> contact_mm;  ///< by contacts, if they are known
    double tip_mm;                     ///< by tips
};

/// Title and captions of the chart of lengths.
struct TravelFigure {
    std::string title = "Length of passes";  ///< above the curves
    std::vector<std::string> captions = {};  ///< lines below the title
};

/// The lengths of passes over their direction, as an SVG file: a curve by tips, and
/// one by contacts where they are known.
/// \param travel by rising direction, at least one.
/// \throws DomainError unless directions do not fall and every number is finite.
std::string direction_travel_svg(std::span<const DirectionTravel> travel,
                                 const TravelFigure& figure);

}  // namespace endmill
