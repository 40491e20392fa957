// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "endmill/cutter/cutter.h"

namespace endmill {

/// Values that are combined with each other; each list rises.
struct Sweep {
    std::vector<double> radii;       ///< of the balls, mm
    std::vector<double> curvatures;  ///< across the feed, 1/mm
    std::vector<double> intervals;   ///< mm
    std::vector<double> scallops;    ///< mm
};

/// The scallop height; nothing if the balls do not meet above the section, or if the interval exceeds the
/// diameter of the section.
std::optional<double> scallop_if_any(const BallCutter& ball, double curvature,
                                     double interval);

/// For each statement of [KimChoi, section 3], the share in percent of the neighbouring pairs of the sweep
/// for which it holds.
std::vector<std::pair<std::string, double>> trends(const Sweep& sweep);

}  // namespace endmill
