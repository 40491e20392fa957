// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "endmill/figures/axonometric_figure.h"

/// \file
/// Charts of several curves over one abscissa, in panels above each other.

namespace endmill {

/// A value for each place of a chart: a list, or a function that computes a value when it is
/// needed, for charts of very many places.
template <class Value>
class ChartColumn {
public:
    ChartColumn() = default;  ///< no values
    ChartColumn(std::vector<Value> values)
        : size_{values.size()},
          value_at_{[values = std::move(values)](std::size_t i) { return values[i]; }}
    {
    }  ///< the values of a list
    ChartColumn(std::initializer_list<Value> values)
        : ChartColumn{std::vector<Value>{values}}
    {
    }  ///< these values
    ChartColumn(std::size_t size, std::function<Value(std::size_t)> value_at)
        : size_{size},
          value_at_{std::move(value_at)}
    {
    }  ///< `size` values of a function

    std::size_t size() const { return size_; }  ///< of values
    Value operator[](std::size_t place) const
    {
        return value_at_(place);
    }  ///< at a place

private:
    std::size_t size_ = 0;
    std::function<Value(std::size_t)> value_at_;
};

/// A curve of a chart.
struct ChartLine {
    std::string_view label;  ///< in the legend of the panel
    LineStyle style;         ///< of the curve
    /// One for each place; a gap where unknown.
    ChartColumn<std::optional<double>> values;
};

/// A panel: curves with a common ordinate.
struct ChartPanel {
    std::string_view label;        ///< of the ordinate, with its unit
    std::vector<ChartLine> lines;  ///< its curves
};

/// A cause that a strip shows.
struct StripCause {
    std::string_view label;   ///< in the legend of the strip
    std::string_view colour;  ///< in the notation of SVG
};

/// A strip of colours below the panels. It shows which cause holds along the abscissa.
struct ChartStrip {
    std::string_view label;          ///< above the strip
    std::vector<StripCause> causes;  ///< the legend names those that occur
    /// One for each place: index of the cause that holds up to it from the place before,
    /// or from 0.
    ChartColumn<std::size_t> cause;
};

/// The texts around the panels.
struct ChartFrame {
    std::string title;                       ///< above the panels
    std::vector<std::string> captions = {};  ///< lines below the title
    std::string_view abscissa;               ///< label of the abscissa, with its unit
};

/// The chart as an SVG file. Where several places fall on one column of pixels, the first
/// and last, least and greatest values in it are drawn, and of a strip the cause that
/// holds for the largest part of the column.
/// \param places abscissas of the values, not decreasing.
/// \throws DomainError unless there is a panel, each line has one value or gap and each
///         strip one cause for each place, places do not decrease, and all numbers are
///         finite.
std::string stacked_chart(const ChartFrame& frame, std::span<const double> places,
                          std::span<const ChartPanel> panels,
                          std::span<const ChartStrip> strips = {});

}  // namespace endmill
