// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace endmill {

/// A range of azimuths about the cutter's axis.
struct AzimuthInterval {
    double from;  ///< rad, from the direction of the feed over the xy plane,
    double to;    ///< counter-clockwise seen from above; -pi <= from < to <= pi

    /// Whether both are the same range.
    friend bool operator==(const AzimuthInterval&, const AzimuthInterval&) = default;
};

/// A narrow ring of the cutter's surface and the part of it that is in the material.
struct EngagedRing {
    double latitude;  ///< rad, of its normal from straight down: 0 at the bottom, pi/2
                      ///< on the cylinder
    double radius;    ///< mm, distance from the axis
    double above;     ///< mm, from the tip
    double width;     ///< mm, along the cutter's profile
    std::vector<AzimuthInterval> engaged;  ///< rising, apart from each other
};

/// Which region of a cutter is in the material, from the tip upwards. A plain value that
/// says nothing of how it was found.
struct Engagement {
    std::vector<EngagedRing> rings;  ///< those of which some part is engaged
};

/// Area of the engaged region in mm^2, each ring taken for a strip of its width.
inline double engaged_area(const Engagement& engagement)
{
    double area = 0;
    for (const EngagedRing& ring : engagement.rings)
        for (const AzimuthInterval& interval : ring.engaged)
            area += ring.radius * (interval.to - interval.from) * ring.width;
    return area;
}

/// Which part of the front of a ball-end mill on a straight move is in the material: a plain
/// value that says nothing of how it was found.
///
/// In radii of the ball, from its centre: X horizontal along the feed, Z up, Y across it
/// towards the side on which there is more stock. A place of the ball is told by y and its
/// angle chi about the Y axis: x = sqrt(1 - y^2) cos(chi), z = sqrt(1 - y^2) sin(chi); equal
/// steps of both have equal areas. The front below the centre is lambda - pi/2 < chi < 0.
struct BallFront {
    double lambda = 0;               ///< rise of the feed, rad, below pi/2 either way
    bool is_stock_right = true;      ///< Y is to the right of the feed, else to its left
    int rows = 0;                    ///< equal steps of y, from -1 to 1
    int columns = 0;                 ///< equal steps of chi, from lambda - pi/2 to 0
    std::vector<char> engaged = {};  ///< 1 where the middle of a cell is in the material;
                                     ///< cell (row, column) at [row * columns + column]
    std::vector<double> shank = {};  ///< in equal steps of the azimuth from Y by X to -Y:
                                     ///< how far up the centre the material goes, from 0
    double rim_angle = 0;  ///< rad, over which the highest engaged ring is engaged
};

}  // namespace endmill
