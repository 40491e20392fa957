// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "endmill/core/vec.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// Bicubic Bezier patch r(u, v) = sum_ij C(3,i) u^i (1-u)^(3-i) C(3,j) v^j (1-v)^(3-j)
/// B_ij over the unit square. An immutable value.
/// Source: [KimChoi, section 2], with the binomials that its print leaves out.
class BezierPatch {
public:
    /// \param net the 16 control points in mm, u running fastest: B_ij at [4 j + i].
    /// \throws DomainError unless there are 16 of them, all finite.
    explicit BezierPatch(std::span<const Vec3> net);

    /// Control point B_ij in mm.
    /// \pre 0 <= i, j <= 3
    Vec3 control_point(int i, int j) const
    {
        return {coordinate_nets_[0](i, j), coordinate_nets_[1](i, j),
                coordinate_nets_[2](i, j)};
    }

    /// Point and first partials. Outside the unit square the polynomial goes on.
    SurfaceTangents tangents(double u, double v) const;

    /// Point, first and second partials. Outside the unit square the polynomial goes on.
    SurfaceJet jet(double u, double v) const;

private:
    std::array<Eigen::Matrix4d, 3> coordinate_nets_;  ///< x, y, z of B_ij at (i, j)
};

/// The same patch with u and v exchanged.
BezierPatch transposed(const BezierPatch& patch);

/// The same patch with u turned round to 1 - u.
BezierPatch reversed_in_u(const BezierPatch& patch);

}  // namespace endmill
