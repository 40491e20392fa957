// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// Bezier patch over the unit square, of degree p in u and q in v up to 25, rational if
/// it has weights:
///
///     r(u, v) = sum_ij w_ij B_i(u) B_j(v) P_ij / sum_ij w_ij B_i(u) B_j(v),
///
/// B_i(u) = C(p,i) u^i (1-u)^(p-i). An immutable value.
/// Source: [KimChoi, section 2] for p = q = 3 without weights, with the binomials that
/// its print leaves out.
class BezierPatch {
public:
    /// A bicubic patch.
    /// \param net the 16 control points in mm, u running fastest: P_ij at [4 j + i].
    /// \throws DomainError unless there are 16 of them, all finite.
    explicit BezierPatch(std::span<const Vec3> net);

    /// \param net     (degree_u + 1) (degree_v + 1) control points in mm, u fastest.
    /// \param weights none, or one a control point.
    /// \throws DomainError if a degree is not in 1 … 25, the sizes disagree, a point is
    /// not finite, or a weight is not finite and above zero.
    BezierPatch(int degree_u, int degree_v, std::span<const Vec3> net,
                std::span<const double> weights = {});

    /// From homogeneous control points (w x, w y, w z, w), u running fastest.
    /// \param is_rational if not, all w must be 1 and are forgotten.
    /// \throws DomainError unless the degrees are in 1 … 25, the size is theirs, and all
    /// is finite with w > 0.
    static BezierPatch from_homogeneous(int degree_u, int degree_v,
                                        std::span<const Eigen::Vector4d> net,
                                        bool is_rational);

    int degree(Parameter along) const  ///< 1 … 25
    {
        return along == Parameter::U ? degree_u_ : degree_v_;
    }

    bool is_rational() const { return is_rational_; }  ///< whether it has weights

    /// Control point P_ij in mm; of a rational patch to a rounding.
    /// \pre 0 <= i <= degree(U), 0 <= j <= degree(V)
    Vec3 control_point(int i, int j) const
    {
        const Eigen::Vector4d point = homogeneous_point(i, j);
        return is_rational_ ? Vec3{point.head<3>() / point[3]} : Vec3{point.head<3>()};
    }

    /// (w x, w y, w z, w) of P_ij and its weight, all scaled by one power of two so that
    /// the greatest w is in 1 … 2; w = 1 without weights.
    Eigen::Vector4d homogeneous_point(int i, int j) const
    {
        const double* at = nets_.data() + j * (degree_u_ + 1) + i;
        const int net = points();
        return {at[0], at[net], at[2 * net], is_rational_ ? at[3 * net] : 1};
    }

    /// Point and first partials. Outside the unit square the polynomials go on.
    SurfaceTangents tangents(double u, double v) const;

    /// The same at all (u[i], v[j]), at [j * u.size() + i]: as one by one but for rounding,
    /// and several times as fast.
    std::vector<SurfaceTangents> tangents(std::span<const double> u,
                                          std::span<const double> v) const;

    /// Only the points of these, sooner still.
    std::vector<Vec3> places(std::span<const double> u, std::span<const double> v) const;

    /// Point, first and second partials. Outside the unit square the polynomials go on.
    SurfaceJet jet(double u, double v) const;

private:
    BezierPatch(int degree_u, int degree_v, bool is_rational);

    int points() const { return (degree_u_ + 1) * (degree_v_ + 1); }

    int degree_u_;
    int degree_v_;
    bool is_rational_;
    std::vector<double> nets_;  ///< of w x, w y, w z and, if rational, w; each u fastest
};

/// The same patch with u and v exchanged.
BezierPatch transposed(const BezierPatch& patch);

/// The same patch with u turned round to 1 - u.
BezierPatch reversed_in_u(const BezierPatch& patch);

/// The same patch written with higher degrees.
/// \throws DomainError unless degree(U) <= degree_u <= 25, and the same for v.
/// Control points are right to a few roundings.
BezierPatch elevated(const BezierPatch& patch, int degree_u, int degree_v);

/// A bicubic patch by its corners, the partials there and the twists: Ferguson's form,
/// whose own patches have zero twists.
struct FergusonPatch {
    /// What the patch is at one corner.
    struct Corner {
        Vec3 point;  ///< mm
        Vec3 du;     ///< mm per unit of u
        Vec3 dv;     ///< mm per unit of v
        Vec3 twist;  ///< mm per units of u and v
    };
    std::array<Corner, 4> corners;  ///< at (u, v) = (0,0), (1,0), (0,1), (1,1)
};

/// The Bezier form of `patch`: the same surface, B = C Q C^T. Next to a corner lie the
/// points a third of a partial inwards, and the inner one a ninth of the twist further.
/// Source: [KimChoi, section 1], which names the conversion without a formula.
///
/// \param patch in mm and units of the patch's own u and v, from 0 to 1.
/// \throws DomainError if a control point would not be finite.
/// Error of a control point below 1e-15 of the greatest number in `patch`.
BezierPatch bezier_from_ferguson(const FergusonPatch& patch);

/// The Ferguson form of `patch`: the same surface. A bicubic Bezier patch in general has
/// twists that are not zero.
///
/// \param patch in mm and units of its own u and v, from 0 to 1.
/// \throws DomainError unless the patch is bicubic and without weights.
/// Error below 1e-14 of the greatest coordinate of its control points; back in Bezier
/// form, below 2e-15 of it.
FergusonPatch ferguson_from_bezier(const BezierPatch& patch);

}  // namespace endmill
