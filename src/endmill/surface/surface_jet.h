// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "endmill/core/vec.h"

namespace endmill {

/// One of the two parameters of a surface.
enum class Parameter { U, V };

/// A place on a surface by its global parameters.
struct SurfacePoint {
    double u;
    double v;
};

/// "u = 1.5, v = 0 (30, 0, 12 mm)": the place and its point, for a message.
std::string place_text(const SurfacePoint& at, const Vec3& point);

/// A closed interval of a parameter, or of a length in mm.
struct Interval {
    double low;
    double high;

    double length() const { return high - low; }  ///< in the interval's own unit
};

/// A point of a parametric surface with its first partial derivatives.
struct SurfaceTangents {
    Vec3 point;  ///< mm
    Vec3 du;     ///< mm per unit of u
    Vec3 dv;     ///< mm per unit of v
};

/// A point of a parametric surface with its first and second partial derivatives.
struct SurfaceJet {
    Vec3 point;  ///< mm
    Vec3 du;     ///< mm per unit of u
    Vec3 dv;     ///< mm per unit of v
    Vec3 duu;    ///< mm per unit of u squared
    Vec3 duv;    ///< mm per units of u and v
    Vec3 dvv;    ///< mm per unit of v squared
};

/// Partials of r from those of w r, `homogeneous`, and of the weight w: entry (m, n) of
/// `weight` is its m-th partial in u and n-th in v.
/// Source: Leibniz' rule on w r, solved for the highest partial of r.
SurfaceTangents projected(const SurfaceTangents& homogeneous,
                          const Eigen::Matrix2d& weight);
/// The same with the second partials.
SurfaceJet projected(const SurfaceJet& homogeneous, const Eigen::Matrix3d& weight);

/// Whether du and dv are parallel to rounding, or one of them vanishes: a pole, a cusp,
/// a collapsed edge. The surface has no normal there but as a limit.
/// Source: |du x dv| < 1e-10 |du| |dv|, the convention of this project.
bool is_singular(const SurfaceTangents& tangents);
/// The same where du x dv is known already.
bool is_singular(const SurfaceTangents& tangents, const Vec3& across);

/// Unit normal du x dv / |du x dv|; its side is the parametrisation's, not the tool's.
/// \throws GeometryError where `is_singular`.
Vec3 unit_normal(const SurfaceTangents& tangents);

/// To which side of a point the surface goes on: +1 towards larger parameters, -1 towards
/// smaller ones (at the upper end of a range).
struct InwardSigns {
    int u;
    int v;
};

/// Unit normal at `jet`, of the parametrisation's side, or its limit along the parameter
/// line that leaves a collapsed edge (one partial vanishes, and with it the area): there
/// du is to first order a multiple of duv, and duv x dv has the normal's direction.
/// \return nothing where that limit does not exist either.
std::optional<Vec3> limit_normal(const SurfaceJet& jet, const InwardSigns& inward);

}  // namespace endmill
