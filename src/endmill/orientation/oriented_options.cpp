// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/oriented_options.h"

#include <cmath>

#include "endmill/core/error.h"

namespace endmill {

void require_sound(const OrientedOptions& options, const Cutter& cutter)
{
    require(options.scallop_height > 0 && options.scallop_height < cutter.radius(),
            "plan_oriented: need a scallop height above 0 and below the radius");
    require(options.inner_tolerance > 0 && options.inner_tolerance < cutter.radius(),
            "plan_oriented: need an inner tolerance above 0 and below the radius");
    require(std::isfinite(options.safe_height), "plan_oriented: need a safe height");
}

}  // namespace endmill
