// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/csv.h"
#include "support/ball_drawing.h"

namespace endmill {

/// An element of a straight edge on its way through the cut, in the frame of BallEngagement.
struct EdgeElement {
    BallEngagement engagement;  ///< level: mu = lambda = 0
    double latitude;            ///< delta, rad from the tip
    double azimuth;             ///< theta, rad, from Y towards X; engaged
};

/// Unit directions of the parts of the force at an element, in the room of BallFrame: what
/// `force_profile` gives for an edge without helix if only that part bears, so that all its
/// elements pull one way.
struct ForceDirections {
    Vec3 tangential;  ///< F_T, on the work
    Vec3 radial;      ///< F_R, on the work
    Vec3 axial;       ///< F_z, in the paper the thrust on the cutter
};

/// \throws DomainError unless the element's edge cuts.
ForceDirections force_directions(const EdgeElement& element, const BallFrame& frame);

/// Adds rows "NAME, X", "…, Y", "…, Z", "…, P" (the element, in mm), "…, F_T", "…, F_R",
/// "…, F_z" with x, y, z in the room, and "…, theta" with from_deg, to_deg (the engaged range at
/// the element's latitude) and at_deg. `along_motion` is the cosine of a force against the way
/// in which a spindle that turns clockwise seen from above moves the element, `outwards` that
/// against the horizontal radius to it.
void add_frame_rows(CsvTable& table, const std::string& name, const EdgeElement& element,
                    const BallFrame& frame);

/// The frame, the element and its forces as an SVG file.
/// Source: the manner of [ParkMaeng, fig. A.1].
std::string force_frame_svg(const EdgeElement& element, const BallFrame& frame,
                            const std::string& title);

}  // namespace endmill
