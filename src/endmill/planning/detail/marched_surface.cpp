// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/marched_surface.h"

namespace endmill {

MarchedSurface marched_surface(const Surface& surface, double side, Parameter direction)
{
    if (direction == Parameter::U)
        return {surface, side};
    // Exchanging the parameters reverses du x dv.
    return {transposed(surface), -side};
}

SurfacePoint in_surface_order(const SurfacePoint& at, Parameter direction)
{
    return direction == Parameter::U ? at : SurfacePoint{at.v, at.u};
}

}  // namespace endmill
