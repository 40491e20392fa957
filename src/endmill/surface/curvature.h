// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/surface/surface_jet.h"

namespace endmill {

/// First and second fundamental form of a surface at a point.
/// Curvatures computed from them are positive where the part is convex seen from the side
/// that `normal` points to, as everywhere in this project.
struct FundamentalForms {
    double E;     ///< du . du, mm^2
    double F;     ///< du . dv, mm^2
    double G;     ///< dv . dv, mm^2
    double e;     ///< N . duu, mm
    double f;     ///< N . duv, mm
    double g;     ///< N . dvv, mm
    Vec3 normal;  ///< N, unit
};

/// Forms at `jet` with respect to `side` (du x dv) / |du x dv|.
/// \param side +1 or -1.
/// \throws GeometryError where `is_singular`.
FundamentalForms fundamental_forms(const SurfaceJet& jet, double side);

/// Forms at `jet` with respect to the unit normal `normal`, which at a pole is a limit.
FundamentalForms fundamental_forms(const SurfaceJet& jet, const Vec3& normal);

/// A tangent vector by its components: a du + b dv.
struct TangentVector {
    double a;  ///< units of u per mm
    double b;  ///< units of v per mm
};

/// Components of the tangent vector nearest to `direction`, by the first form.
/// Source: the first fundamental form, (a, b) = [E F; F G]^-1 (T.du, T.dv).
TangentVector tangent_components(const FundamentalForms& forms, const SurfaceJet& jet,
                                 const Vec3& direction);

/// Normal curvature in 1/mm along a tangent vector of unit length, positive where convex:
/// -(e a^2 + 2 f a b + g b^2), the negative of the paper's KN1.
/// Source: second fundamental form; [KimChoi, eq. (8)] converges to it.
double normal_curvature(const FundamentalForms& forms, const TangentVector& unit_tangent);

/// Principal curvatures in 1/mm, positive where convex.
struct PrincipalCurvatures {
    double least;
    double greatest;
};

/// Eigenvalues of the shape operator, H -+ sqrt(H^2 - K); equal at an umbilic.
/// Their error is a few roundings of the larger one, divided by the squared sine of the
/// angle between the partials.
PrincipalCurvatures principal_curvatures(const FundamentalForms& forms);

/// Curvature |r' x r''| / |r'|^3 of a space curve in 1/mm, never negative.
/// \pre `first` is not zero.
double curve_curvature(const Vec3& first, const Vec3& second);

}  // namespace endmill
