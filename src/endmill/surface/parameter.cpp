// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/parameter.h"

#include "endmill/core/numbers.h"

namespace endmill {

std::string place_text(const SurfacePoint& at, const Vec3& point)
{
    return "u = " + to_text(at.u) + ", v = " + to_text(at.v) + " (" + to_text(point.x()) +
           ", " + to_text(point.y()) + ", " + to_text(point.z()) + " mm)";
}

}  // namespace endmill
