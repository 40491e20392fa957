// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "endmill/strategy/detail/front_march.h"

namespace endmill {

/// Passes start at a distance from these places of the border, as from a front.
struct BorderStart {
    double first_share;  ///< of the length of all borders, where the side begins
    double last_share;   ///< where it ends
};

/// The first pass is the section of the part with an upright plane.
struct LineStart {
    double angle;  ///< of the plane to +x, rad
    double share;  ///< position of the plane over the part's extent, 0 to 1
};

/// Where the first pass lies.
using MarchStart = std::variant<BorderStart, LineStart>;

/// The starts that are worth a trial: all borders, each side of the border between two
/// corners, and sections through the middle in several directions.
std::vector<MarchStart> march_starts(const PartSamples& samples);

/// Lays the passes of a start, and of further starts where it leaves components of the
/// part uncovered.
/// \param coverage      what is covered so far; the passes are added.
/// \param start         where the first pass lies; nothing if passes have been added.
/// \param slack, rounds of FrontMarch.
std::vector<LevelLine> lay_lines(Coverage& coverage,
                                 const std::optional<MarchStart>& start, double slack,
                                 int rounds);

/// The passes on lines of a net.
std::vector<LaidPass> passes_on(std::span<const LevelLine> lines,
                                const PartSamples& samples);

}  // namespace endmill
