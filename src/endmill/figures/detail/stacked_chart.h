// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/figures/axonometric_figure.h"

namespace endmill {

/// A curve; where a value is none it has a gap.
struct ChartLine {
    std::string_view label;
    LineStyle style;
    std::vector<std::optional<double>> values;  ///< one a place of the abscissa
};

/// Curves with one scale.
struct ChartPanel {
    std::string_view label;  ///< of the ordinate, with its unit
    std::vector<ChartLine> lines;
};

/// What stands around the panels.
struct ChartFrame {
    std::string title;
    std::vector<std::string> captions = {};
    std::string_view abscissa;  ///< its label, with its unit
};

/// The panels over `places`, which rise, as an SVG file. Where more places than that fall on
/// a pixel, the first and last, least and greatest values in it are drawn.
/// \throws DomainError unless there is a panel, each line has a value or none a place, places
///         rise, and all numbers are finite.
std::string stacked_chart(const ChartFrame& frame, std::span<const double> places,
                          std::span<const ChartPanel> panels);

/// Round numbers, 1, 2 or 5 times a power of ten apart, about `count` of them, that cover
/// what lies between `low` and `high`: one below or at it, one above or at it.
/// \pre finite, low <= high, count > 0.
std::vector<double> round_ticks(double low, double high, int count);

}  // namespace endmill
