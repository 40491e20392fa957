// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "endmill/figures/axonometric_figure.h"
#include "endmill/process/cutting_force.h"

namespace endmill {

/// The frame of BallEngagement as it stands in a room whose x is the feed seen from above, y to
/// the left of it and z upwards: its Y is to the left of the feed when milling up, and to the
/// right of it when milling down.
/// Source: spec of ball-end milling, section 1.
struct BallFrame {
    Milling milling = Milling::Down;  ///< on which side of the feed Y is
    double radius_mm = 1;             ///< of the ball

    /// A place or direction of the frame, in radii, as one of the room, in radii.
    Vec3 turned(const Vec3& place) const;

    /// The same in mm.
    Vec3 in_room(const Vec3& place) const;

    /// A line of the frame, in radii, in the room, in mm.
    std::vector<Vec3> in_room(const std::vector<Vec3>& line) const;
};

/// The point of the unit ball at a latitude from the tip and an azimuth from Y towards X, rad.
Vec3 ball_point(double latitude, double azimuth);

/// The shorter arc around `centre` from direction `from` to direction `to`, unit vectors less
/// than a half turn apart.
std::vector<Vec3> arc_between(const Vec3& centre, const Vec3& from, const Vec3& to,
                              double radius);

/// The line of the unit ball at one latitude, between two azimuths, rad.
std::vector<Vec3> latitude_line(double latitude, double from, double to);

/// An arrow of the frame with its name beyond its head. Lengths in radii.
void add_named_arrow(AxonometricFigure& figure, const BallFrame& frame,
                     std::span<const Vec3, 2> ends, std::string_view name,
                     const LineStyle& style);

}  // namespace endmill
