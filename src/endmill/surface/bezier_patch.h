// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/surface/surface_jet.h"

/// \file
/// Bezier patches and conversions to them. Implemented in `bezier_patch.cpp` and
/// `ferguson.cpp` (FergusonPatch).

namespace endmill {

/// A Bezier patch over the unit square, of degree p in u and q in v, both up to 25; with
/// weights it is rational:
///
///     r(u, v) = sum_ij w_ij B_i(u) B_j(v) P_ij / sum_ij w_ij B_i(u) B_j(v),
///
/// with B_i(u) = C(p,i) u^i (1-u)^(p-i), and B_j(v) likewise. An immutable value. Outside
/// the unit square the polynomials are extrapolated.
/// Source: [KimChoi, section 2] for p = q = 3 without weights, with the binomial
/// coefficients that the print leaves out.
class BezierPatch {
public:
    /// A bicubic patch.
    /// \param net the 16 control points in mm, u varying fastest: P_ij at [4 j + i].
    /// \throws DomainError unless there are 16 points, all finite.
    explicit BezierPatch(std::span<const Vec3> net);

    /// A patch of any degree, rational if weights are given.
    /// \param degree_u 1 to 25.
    /// \param degree_v 1 to 25.
    /// \param net (degree_u + 1) (degree_v + 1) control points in mm, u varying fastest.
    /// \param weights none, or one for each control point.
    /// \throws DomainError if a degree is out of range, the sizes do not match, a point
    ///         is not finite, or a weight is not finite and positive.
    BezierPatch(int degree_u, int degree_v, std::span<const Vec3> net,
                std::span<const double> weights = {});

    /// A patch given by homogeneous control points (w x, w y, w z, w).
    /// \param degree_u 1 to 25.
    /// \param degree_v 1 to 25.
    /// \param net one point for each control point, u varying fastest.
    /// \param is_rational whether to keep the weights; if not, all w must be 1.
    /// \throws DomainError unless the degrees are in range, the size matches, and all
    ///         numbers are finite with w > 0.
    static BezierPatch from_homogeneous(int degree_u, int degree_v,
                                        std::span<const Eigen::Vector4d> net,
                                        bool is_rational);

    int degree(Parameter along) const  ///< 1 to 25
    {
        return along == Parameter::U ? degree_u_ : degree_v_;
    }

    bool is_rational() const { return is_rational_; }  ///< whether it has weights

    /// Control point P_ij in mm; for a rational patch accurate to one rounding.
    /// \pre 0 <= i <= degree(U), 0 <= j <= degree(V)
    Vec3 control_point(int i, int j) const
    {
        const Eigen::Vector4d point = homogeneous_point(i, j);
        return is_rational_ ? Vec3{point.head<3>() / point[3]} : Vec3{point.head<3>()};
    }

    /// Homogeneous control point (w x, w y, w z, w) of P_ij. All are scaled by the same
    /// power of two, so that the greatest w is between 1 and 2; w = 1 without weights.
    Eigen::Vector4d homogeneous_point(int i, int j) const
    {
        const double* at = nets_.data() + j * (degree_u_ + 1) + i;
        const int net = points();
        return {at[0], at[net], at[2 * net], is_rational_ ? at[3 * net] : 1};
    }

    /// Point and first partial derivatives at (u, v).
    SurfaceTangents tangents(double u, double v) const;

    /// Point and first partial derivatives on a grid of parameters: those at (u[i], v[j])
    /// are at [j * u.size() + i]. The results equal those of single calls except for
    /// rounding. This function is several times faster.
    std::vector<SurfaceTangents> tangents(std::span<const double> u,
                                          std::span<const double> v) const;

    /// The points alone on a grid of parameters; faster than `tangents`.
    std::vector<Vec3> places(std::span<const double> u, std::span<const double> v) const;

    /// Point, first and second partial derivatives at (u, v).
    SurfaceJet jet(double u, double v) const;

private:
    BezierPatch(int degree_u, int degree_v, bool is_rational);

    int points() const { return (degree_u_ + 1) * (degree_v_ + 1); }

    int degree_u_;
    int degree_v_;
    bool is_rational_;
    /// Nets of w x, w y, w z and, if rational, w; in each, u varies fastest.
    std::vector<double> nets_;
};

/// The same patch with u and v exchanged.
BezierPatch transposed(const BezierPatch& patch);

/// The same patch with u replaced by 1 - u.
BezierPatch reversed_in_u(const BezierPatch& patch);

/// A bicubic patch in Ferguson's form: points, first partial derivatives and twists at
/// the four corners. Ferguson's own patches have zero twists.
struct FergusonPatch {
    /// The patch at one corner.
    struct Corner {
        Vec3 point;  ///< mm
        Vec3 du;     ///< mm per unit of u
        Vec3 dv;     ///< mm per unit of v
        Vec3 twist;  ///< mm per unit of u and unit of v
    };
    std::array<Corner, 4> corners;  ///< at (u, v) = (0,0), (1,0), (0,1), (1,1)
};

/// The Bezier form of a Ferguson patch: the same surface, B = C Q C^T. A control point
/// next to a corner is a third of a partial derivative away; the inner one is a ninth of
/// the twist further.
/// Source: [KimChoi, section 1], which names the conversion without a formula.
/// \param patch parameters from 0 to 1.
/// \throws DomainError if a control point would not be finite. The error of a control
///         point is below 1e-15 of the greatest number in `patch`.
BezierPatch bezier_from_ferguson(const FergusonPatch& patch);

/// The Ferguson form of a Bezier patch: the same surface. In general its twists are not
/// zero. The error is below 1e-14 of the greatest coordinate of the control points;
/// converted back to Bezier form, below 2e-15.
/// \param patch bicubic and without weights.
/// \throws DomainError if it is not.
FergusonPatch ferguson_from_bezier(const BezierPatch& patch);

}  // namespace endmill
