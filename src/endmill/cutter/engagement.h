// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace endmill {

/// A range of azimuths about the cutter's axis. Azimuths are measured from the feed
/// direction projected on the xy plane, counter-clockwise seen from above.
struct AzimuthInterval {
    double from;  ///< rad, at least -pi
    double to;    ///< rad, above `from` and at most pi

    /// Whether both ranges are equal.
    friend bool operator==(const AzimuthInterval&, const AzimuthInterval&) = default;
};

/// A narrow ring of the cutter's surface, and the part of it that is in the material.
struct EngagedRing {
    /// In rad: angle of the surface normal from -z: 0 at the bottom, pi/2 on the
    /// cylinder.
    double latitude;
    double radius;                         ///< mm, distance from the axis
    double above;                          ///< mm, height above the tip
    double width;                          ///< mm, along the cutter's profile
    std::vector<AzimuthInterval> engaged;  ///< in rising order, disjoint
};

/// The region of a cutter that is in the material, ring by ring from the tip upwards.
/// Geometric and simulated engagements use the same type.
struct Engagement {
    std::vector<EngagedRing> rings;  ///< the rings that are engaged somewhere
};

/// A side of a move, seen along the feed from above.
enum class FeedSide { Left, Right };

/// The region of the front of a ball-end mill that is in the material on a straight move,
/// cell by cell. Geometric and simulated engagements use the same type.
///
/// Coordinates are in radii of the ball, from its centre: X is horizontal along the feed,
/// Z points up, and Y is across the feed towards the side with more stock. A point of the
/// ball is given by y and by its angle chi about the Y axis: x = sqrt(1 - y^2) cos(chi),
/// z = sqrt(1 - y^2) sin(chi). Equal steps of y and chi cover equal areas. The part of
/// the front below the centre has lambda - pi/2 < chi < 0.
struct BallFront {
    /// In rad: angle of the feed above the horizontal, between -pi/2 and pi/2.
    double lambda = 0;
    FeedSide stock_side = FeedSide::Right;  ///< the side to which Y points
    int rows = 0;                           ///< number of equal steps of y, from -1 to 1
    int columns = 0;  ///< number of equal steps of chi, from lambda - pi/2 to 0
    /// 1 for each cell whose middle is in the material, else 0. Cell (row, column) is at
    /// [row * columns + column].
    std::vector<char> engaged = {};
    /// Height of the material above the centre along the shank, at least 0, sampled at
    /// equal steps of the azimuth from Y over X to -Y.
    std::vector<double> shank = {};
    /// rad, angle about the axis over which the rim, the highest engaged ring, is in the
    /// material.
    double rim_angle = 0;
};

}  // namespace endmill
