// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/surface_jet.h"

#include "endmill/core/text.h"

namespace endmill {

std::string place_text(const SurfacePoint& at, const Vec3& point)
{
    return "u = " + to_text(at.u) + ", v = " + to_text(at.v) + " (" + to_text(point.x()) +
           ", " + to_text(point.y()) + ", " + to_text(point.z()) + " mm)";
}

}  // namespace endmill
