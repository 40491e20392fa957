// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/bezier_patch.h"

#include "endmill/core/error.h"

namespace endmill {

BezierPatch bezier_from_ferguson(const FergusonPatch& patch)
{
    std::array<Vec3, 16> net;
    for (int corner = 0; corner < 4; ++corner) {
        const auto& [point, du, dv, twist] = patch.corners[corner];
        // Control points next to the corner are a third of a partial derivative inwards.
        const int i = corner % 2 == 0 ? 0 : 3;
        const int j = corner / 2 == 0 ? 0 : 3;
        const int inward_u = i == 0 ? 1 : -1;
        const int inward_v = j == 0 ? 1 : -1;
        const Vec3 step_u = inward_u * du / 3;
        const Vec3 step_v = inward_v * dv / 3;
        net[4 * j + i] = point;
        net[4 * j + i + inward_u] = point + step_u;
        net[4 * (j + inward_v) + i] = point + step_v;
        net[4 * (j + inward_v) + i + inward_u] =
            point + step_u + step_v + inward_u * inward_v * twist / 9;
    }
    return BezierPatch{net};
}

FergusonPatch ferguson_from_bezier(const BezierPatch& patch)
{
    require(patch.degree(Parameter::U) == 3 && patch.degree(Parameter::V) == 3 &&
                !patch.is_rational(),
            "ferguson_from_bezier: need a bicubic patch without weights");
    FergusonPatch ferguson;
    for (int corner = 0; corner < 4; ++corner) {
        const int u = corner % 2;
        const int v = corner / 2;
        const SurfaceJet jet = patch.jet(u, v);
        ferguson.corners[corner] = {jet.point, jet.du, jet.dv, jet.duv};
    }
    return ferguson;
}

}  // namespace endmill
