// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/bezier_patch.h"

#include <algorithm>

#include "endmill/core/error.h"
#include "endmill/surface/cubic_bernstein.h"

namespace endmill {
BezierPatch::BezierPatch(std::span<const Vec3> net)
{
    require(net.size() == 16, "BezierPatch: a bicubic net has 16 control points");
    require(std::ranges::all_of(net, [](const Vec3& point) { return point.allFinite(); }),
            "BezierPatch: control points must be finite");
    for (int c = 0; c < 3; ++c)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
                coordinate_nets_[c](i, j) = net[4 * j + i][c];
}

SurfaceTangents BezierPatch::tangents(double u, double v) const
{
    const auto basis_u = cubic_bernstein<2>(u);
    const auto basis_v = cubic_bernstein<2>(v);
    SurfaceTangents tangents;
    for (int c = 0; c < 3; ++c) {
        // Entry (m, n) is the m-th derivative in u and n-th in v.
        const Eigen::Matrix2d partials =
            basis_u.transpose() * (coordinate_nets_[c] * basis_v);
        tangents.point[c] = partials(0, 0);
        tangents.du[c] = partials(1, 0);
        tangents.dv[c] = partials(0, 1);
    }
    return tangents;
}

SurfaceJet BezierPatch::jet(double u, double v) const
{
    const auto basis_u = cubic_bernstein<3>(u);
    const auto basis_v = cubic_bernstein<3>(v);
    SurfaceJet jet;
    for (int c = 0; c < 3; ++c) {
        // Entry (m, n) is the m-th derivative in u and n-th in v.
        const Eigen::Matrix3d partials =
            basis_u.transpose() * (coordinate_nets_[c] * basis_v);
        jet.point[c] = partials(0, 0);
        jet.du[c] = partials(1, 0);
        jet.dv[c] = partials(0, 1);
        jet.duu[c] = partials(2, 0);
        jet.duv[c] = partials(1, 1);
        jet.dvv[c] = partials(0, 2);
    }
    return jet;
}

BezierPatch transposed(const BezierPatch& patch)
{
    std::array<Vec3, 16> net;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            net[4 * j + i] = patch.control_point(j, i);
    return BezierPatch{net};
}

BezierPatch reversed_in_u(const BezierPatch& patch)
{
    std::array<Vec3, 16> net;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            net[4 * j + i] = patch.control_point(3 - i, j);
    return BezierPatch{net};
}

}  // namespace endmill
