// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/figures/direction_figures.h"

namespace endmill {

/// A chart of directions in a plane around a pole. The azimuth counts counter-clockwise
/// from the right; rings are at equal polar angles.
class DirectionChart {
public:
    /// The axes of the chart.
    struct Frame {
        Vec3 pole;   ///< unit vector; the direction in the centre
        Vec3 right;  ///< unit vector across the pole; its direction has azimuth 0
    };

    /// An empty chart with its rings and azimuths.
    /// \param reach largest polar angle in the chart: below 90 degrees in the gnomonic,
    ///              at most 90 in the orthographic, at most 180 in the equidistant
    ///              projection.
    /// \throws DomainError for another reach.
    DirectionChart(std::string_view title, const Frame& frame, ChartProjection projection,
                   Angle reach);

    /// Draws the parts of a curve that are within reach, as straight lines between
    /// points.
    void add_curve(std::span<const Vec3> directions, const LineStyle& style);

    /// Draws a disc at each direction within reach, and a line of the legend.
    void add_marks(std::span<const Vec3> directions, std::string_view colour,
                   std::string_view label);

    /// Adds a line of the legend.
    void add_legend(std::string_view label, const LineStyle& style);

    /// The whole SVG file.
    std::string text() const { return picture_.text(); }

private:
    double radius_at(double polar) const;
    PixelPoint place(const Vec3& direction) const;
    bool is_shown(const Vec3& direction) const;
    PixelPoint next_legend() const;  // where the sample of the next line begins
    void name_legend(std::string_view label);
    void add_rings();
    void add_azimuths();

    Frame frame_;
    Vec3 up_;
    ChartProjection projection_;
    double reach_;  // rad
    SvgPicture picture_;
    int legend_lines_ = 0;
};

}  // namespace endmill
