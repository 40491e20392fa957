// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/figures/force_figures.h"

/// \file
/// Points and lines on the unit ball, for the figures of ball-end milling. The frame is
/// that of BallEngagement: the tip of the ball is at (0, 0, -1).

namespace endmill {

/// Latitude of the stock's top on the ball, in rad from the tip; pi / 2 if the top is
/// above the equator. \pre the engagement cuts something.
double highest_latitude(const BallEngagement& engagement);

/// The point of the unit ball at a latitude from the tip and an azimuth from Y towards X,
/// both in rad.
Vec3 ball_point(double latitude, double azimuth);

/// The shorter arc of a circle around `centre`, as points.
/// \param from,to unit vectors from the centre, less than half a turn apart.
std::vector<Vec3> arc_between(const Vec3& centre, const Vec3& from, const Vec3& to,
                              double radius);

/// The points of the unit ball at one latitude between two azimuths, all in rad.
std::vector<Vec3> latitude_line(double latitude, double from, double to);

/// Draws an arrow of the frame with its name beyond the head. \param ends in radii.
void add_named_arrow(AxonometricFigure& figure, const BallFrame& frame,
                     std::span<const Vec3, 2> ends, std::string_view name,
                     const LineStyle& style);

}  // namespace endmill
