// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/figures/axonometric_figure.h"

namespace endmill {

/// How directions are laid on a plane about a pole.
enum class ChartProjection {
    Equidistant,  ///< polar angles keep their ratio
    Gnomonic,     ///< great circles become straight
    Orthographic  ///< as the sphere is seen from the pole
};

/// Directions about a pole in a plane: azimuth counter-clockwise from the right, rings at
/// polar angles.
class DirectionChart {
public:
    /// What the chart is of.
    struct Frame {
        Vec3 pole;   ///< unit, in the middle
        Vec3 right;  ///< unit, across it: azimuth 0
    };

    /// \param reach largest polar angle that is drawn; below 90 degrees in the gnomonic,
    ///        at most 90 in the orthographic, at most 180 in the equidistant projection.
    DirectionChart(std::string_view title, const Frame& frame, ChartProjection projection,
                   Angle reach);

    /// Directions joined by straight lines, as far as they are within reach.
    void add_curve(std::span<const Vec3> directions, const LineStyle& style);

    /// A disc at each direction within reach, and a line of the legend.
    void add_marks(std::span<const Vec3> directions, std::string_view colour,
                   std::string_view label);

    /// A line of the legend.
    void add_legend(std::string_view label, const LineStyle& style);

    /// The whole file.
    std::string text() const { return picture_.text(); }

private:
    double radius_at(double polar) const;
    PixelPoint place(const Vec3& direction) const;
    bool is_shown(const Vec3& direction) const;
    PixelPoint next_legend() const;  // where its sample begins
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
