// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "endmill/planning/detail/economy_scaling.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Travel of the passes along one direction, without links, in mm.
struct PassTravel {
    double planned;  ///< passes of the plan
    double uniform;  ///< equidistant passes, as near as the nearest two of the plan
};

/// The statements of the paper, measured on one surface. Arrays hold u, then v.
struct SurfaceStudy {
    EconomyTables tables;  ///< the 18 runs
    std::array<double, 2>
        tips_mm;  ///< travel of the tips for the middle ball and tolerance
    std::array<PassTravel, 2> travel;
    std::array<double, 2> iso_mm;    ///< idealised iso-parametric passes
    std::array<double, 2> local_mm;  ///< the same feed, each place with its own interval
    double planes_mm;  ///< idealised parallel planes in their best direction
    double
        tape_m;  ///< punched tape of the path along u for the smallest ball and tolerance
};

/// Measures one surface. The balls have the diameters of the paper's tables times `scale`, and so have
/// the tolerances. \pre all balls fit.
SurfaceStudy study_surface(const Surface& surface, double scale);

/// The direction with the smaller number, "u" or "v"; "either" if they differ by less than 1e-9 of the
/// greater, which is rounding.
std::string smaller(double u, double v);

}  // namespace endmill
