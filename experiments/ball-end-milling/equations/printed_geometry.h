// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/named_cells.h"

namespace endmill {

/// Cases for the printed equations on the geometry.
struct GeometryCases {
    double feed_turn_deg;  ///< direction of the feed from x towards y, seen from above
    double cylinder_radius_mm;  ///< of a cylinder along the feed, convex and concave
    double ball_radius_mm;      ///< r0
};

/// Adds a row with the deviation of each printed equation on the geometry, the largest
/// over a grid of points of the test surface:
///
/// - "eq. (8)": ||T| - 1| with C read as G = A^T A.
/// - "eq. (9)": |cos(lambda) - (Tx^2 + Ty^2)|, as printed without the root.
/// - "eq. (10)": |n_z - cos(mu) cos(lambda)|.
/// - "eq. (11)": |(Tx ny + Ty nx) - (T x N)_z|, as printed; "eq. (11), Ty = 0": the same
///   with the feed along x, as in the paper's frame.
/// - "mu and lambda": distance of the normal from the one that mu and lambda of the
///   corrected eq. (9) to (11) give.
/// - "eq. (13)": |f_p - distance of the ball centres| on cylinders along the feed, mm.
void add_geometry_equations(CsvTable& result, const GeometryCases& cases);

}  // namespace endmill
