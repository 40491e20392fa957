// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/process/ball_engagement.h"
#include "endmill/process/cutting_force.h"

/// \file
/// Figures of ball-end milling: the engaged part of the ball, and the frame of the
/// cutting forces on an element of the edge. Both draw in the frame of BallEngagement,
/// whose lengths are in radii of the ball.
///
/// Implemented in `engagement_svg.cpp` and `force_frame_svg.cpp`.

namespace endmill {

/// The position of the frame of BallEngagement in a figure. In the figure, x is the feed
/// seen from above, y points to the left of it and z upwards. Y of the frame is to the
/// left of the feed in up milling and to the right of it in down milling.
/// Source: docs/methods/ball-end-milling.md, section 1.
struct BallFrame {
    Milling milling = Milling::Down;  ///< selects the side of Y
    double radius_mm = 1;             ///< radius of the ball, in mm

    /// A point or direction of the frame, in the axes of the figure; lengths in radii.
    Vec3 turned(const Vec3& place) const;

    /// Converts a point of the frame, in radii, to the axes of the figure, in mm.
    Vec3 in_room(const Vec3& place) const;

    /// Converts the points of a line of the frame, in radii, to the axes of the figure,
    /// in mm.
    std::vector<Vec3> in_room(const std::vector<Vec3>& line) const;
};

/// A border of the engaged part of the ball.
struct EngagementBorder {
    /// "front", "previous pass", "wall of the previous pass", "edge" or "stock's top".
    std::string name;
    std::vector<Vec3> points;  ///< of the unit ball, in the frame of BallEngagement
};

/// All borders of the engaged part of the ball; those at the stock's top are last.
/// \throws DomainError if `engagement` is invalid or nothing is cut.
std::vector<EngagementBorder> engagement_borders(const BallEngagement& engagement);

/// The engaged ball as an SVG file: the engaged part E, the groove of the previous pass,
/// the feed T, the surface normal N, the pick feed F_p, the frame X, Y, Z and the angles
/// mu and lambda.
/// Source: after [ParkMaeng, fig. 2].
/// \param captions lines below the title.
/// \throws DomainError as `engagement_borders`.
std::string engagement_svg(const BallEngagement& engagement, const BallFrame& frame,
                           const std::vector<std::string>& captions);

/// An element of a straight edge (without helix) that is cutting.
struct EdgeElement {
    BallEngagement engagement;  ///< of a horizontal move: mu = lambda = 0
    double latitude;            ///< delta, in rad from the tip
    double azimuth;  ///< theta, in rad from Y towards X; within an engaged range
};

/// Unit directions of the force components at an element, in the axes of the figure. They
/// are computed by `force_profile` with material constants that make all other components
/// zero. Without helix, all elements of the edge then contribute in the same direction.
struct ForceDirections {
    Vec3 tangential;  ///< F_T, on the work
    Vec3 radial;      ///< F_R, on the work
    Vec3 axial;       ///< F_z; in the paper the thrust on the cutter
};

/// The directions of the force components at an element.
/// \throws DomainError if the edge does not cut at the element's azimuth.
ForceDirections force_directions(const EdgeElement& element, const BallFrame& frame);

/// The frame, the edge with its element, and the force components as an SVG file.
/// Source: after [ParkMaeng, fig. A.1].
/// \param title above the figure.
/// \throws DomainError as `force_directions`.
std::string force_frame_svg(const EdgeElement& element, const BallFrame& frame,
                            const std::string& title);

}  // namespace endmill
