// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/machine_path_options.h"

#include <cmath>

#include "endmill/core/error.h"

namespace endmill {

void require_sound(const MachinePathOptions& options)
{
    constexpr double least_tolerance = 1e-6;  // mm, of positions in a double
    constexpr Angle widest_cone = Angle::degrees(10);
    require(options.frame != Interpolation::Linear,
            "machine_path: need the frame Tcp or Joint");
    require(std::isfinite(options.tolerance) && options.tolerance >= least_tolerance,
            "machine_path: need a tolerance of at least 1e-6 mm");
    require(options.singular_cone.radians() >= 0 &&
                options.singular_cone.radians() < widest_cone.radians(),
            "machine_path: need a singular cone from 0, below 10 degrees");
    require(!options.retract || (std::isfinite(*options.retract) && *options.retract > 0),
            "machine_path: need a retract above 0");
    require(options.singular != SingularRule::Retract || options.retract,
            "machine_path: need a retract for SingularRule::Retract");
    require(!options.rapid_feed ||
                (std::isfinite(*options.rapid_feed) && *options.rapid_feed > 0),
            "machine_path: need a feed of rapids above 0");
}

}  // namespace endmill
