// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/patch_offset.h"

#include <Eigen/Geometry>

#include "endmill/planning/detail/contact_line.h"

namespace endmill {

PatchOffset::PatchOffset(const MarchedSurface& marched, const SurfacePoint& inside,
                         double height)
    : marched_{marched},
      i_{marched.surface.patch_number(Parameter::U, inside.u)},
      j_{marched.surface.patch_number(Parameter::V, inside.v)},
      u_{marched.surface.breaks(Parameter::U).subspan(i_, 2)},
      v_{marched.surface.breaks(Parameter::V).subspan(j_, 2)},
      height_{height}
{
}

std::optional<Vec3> PatchOffset::at(double u, double v) const
{
    // The patch has its own parameters in [0, 1].
    const SurfaceTangents tangents = marched_.surface.patch(i_, j_).tangents(
        (u - u_[0]) / (u_[1] - u_[0]), (v - v_[0]) / (v_[1] - v_[0]));
    if (has_plain_normal(tangents))
        return tangents.point +
               marched_.side * height_ * tangents.du.cross(tangents.dv).normalized();
    const auto normal = limit_normal(marched_.surface.jet_in_patch(i_, j_, u, v),
                                     {u < u_[1] ? 1 : -1, v < v_[1] ? 1 : -1});
    if (!normal)
        return std::nullopt;
    return tangents.point + marched_.side * height_ * *normal;
}

}  // namespace endmill
