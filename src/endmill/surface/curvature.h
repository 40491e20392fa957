// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/surface/surface_jet.h"

namespace endmill {

/// The first and second fundamental form of a surface at a point. Curvatures computed
/// from them are positive where the part is convex, seen from the side to which `normal`
/// points. This sign convention holds in the whole project.
struct FundamentalForms {
    double E;     ///< du . du, mm^2
    double F;     ///< du . dv, mm^2
    double G;     ///< dv . dv, mm^2
    double e;     ///< N . duu, mm
    double f;     ///< N . duv, mm
    double g;     ///< N . dvv, mm
    Vec3 normal;  ///< N, unit
};

/// The forms at `jet` for the normal `side` (du x dv) / |du x dv|.
/// \param jet point and partial derivatives.
/// \param side +1 or -1.
/// \throws GeometryError where `is_singular` holds.
FundamentalForms fundamental_forms(const SurfaceJet& jet, double side);

/// The forms at `jet` for a given unit normal. At a pole this may be a limit.
FundamentalForms fundamental_forms(const SurfaceJet& jet, const Vec3& normal);

/// A tangent vector a du + b dv, by its components.
struct TangentVector {
    double a;  ///< units of u per mm
    double b;  ///< units of v per mm
};

/// The components of the tangent vector that is nearest to `direction`.
/// By the first fundamental form, (a, b) = [E F; F G]^-1 (T.du, T.dv).
TangentVector tangent_components(const FundamentalForms& forms, const SurfaceJet& jet,
                                 const Vec3& direction);

/// Normal curvature in 1/mm along a tangent vector of unit length: -(e a^2 + 2 f a b + g
/// b^2), the negative of the paper's KN1. It is positive where the part is convex.
/// Source: the second fundamental form; [KimChoi, eq. (8)] converges to it.
double normal_curvature(const FundamentalForms& forms, const TangentVector& unit_tangent);

/// Principal curvatures in 1/mm, positive where convex.
struct PrincipalCurvatures {
    double least;     ///< 1/mm
    double greatest;  ///< 1/mm
};

/// The principal curvatures: the eigenvalues of the shape operator, H -+ sqrt(H^2 - K).
/// They are equal at an umbilic. The error is a few roundings of the larger one, divided
/// by the squared sine of the angle between the partial derivatives.
PrincipalCurvatures principal_curvatures(const FundamentalForms& forms);

/// Curvature |r' x r''| / |r'|^3 of a space curve in 1/mm; it is never negative.
/// \param first r', the first derivative.
/// \param second r'', the second derivative.
/// \pre `first` is not zero.
double curve_curvature(const Vec3& first, const Vec3& second);

}  // namespace endmill
