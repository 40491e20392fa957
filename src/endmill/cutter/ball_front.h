// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace endmill {

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
