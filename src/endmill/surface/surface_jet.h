// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "endmill/core/vec.h"

namespace endmill {

/// One of the two parameters of a surface.
enum class Parameter { U, V };

/// A place on a surface, by its global parameters.
struct SurfacePoint {
    double u;  ///< global parameter
    double v;  ///< global parameter
};

/// A place and its point as text for a message: "u = 1.5, v = 0 (30, -0.1, 12 mm)".
/// Parameters are rounded to 1e-4, coordinates to 0.001 mm.
std::string place_text(const SurfacePoint& at, const Vec3& point);

/// A closed interval of a parameter or of a length in mm.
struct Interval {
    double low;   ///< lower end
    double high;  ///< upper end

    double length() const { return high - low; }  ///< in the unit of the interval
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
    Vec3 duv;    ///< mm per unit of u and unit of v
    Vec3 dvv;    ///< mm per unit of v squared
};

/// The partial derivatives of r, from those of w r and of the weight w.
/// They follow from Leibniz' rule for w r, solved for the highest derivative of r.
/// \param homogeneous of w r.
/// \param weight entry (m, n) is the m-th partial derivative of w in u and the n-th in v.
SurfaceTangents projected(const SurfaceTangents& homogeneous,
                          const Eigen::Matrix2d& weight);
/// The same including the second partial derivatives.
SurfaceJet projected(const SurfaceJet& homogeneous, const Eigen::Matrix3d& weight);

/// Whether a surface has no normal at a point, except as a limit. This is so if du and dv
/// are parallel up to rounding, |du x dv| <= 1e-10 |du| |dv|, or if one of them vanishes,
/// as at poles, cusps and collapsed edges.
bool is_singular(const SurfaceTangents& tangents);
/// The same for a known product `across` = du x dv.
bool is_singular(const SurfaceTangents& tangents, const Vec3& across);

/// Unit normal du x dv / |du x dv|. Its side depends on the parametrisation, not on the
/// tool.
/// \throws GeometryError where `is_singular` holds.
Vec3 unit_normal(const SurfaceTangents& tangents);

/// The directions in which the surface continues from a point: +1 towards larger
/// parameters, or -1 towards smaller ones, as at the upper end of a range.
struct InwardSigns {
    int u;  ///< +1 or -1
    int v;  ///< +1 or -1
};

/// The unit normal at `jet` on the side of du x dv. At a collapsed edge it is the limit
/// of the normal along the parameter line that leaves the edge. There one partial
/// derivative vanishes, such as du. Near the edge du is to first order a multiple of duv,
/// so that duv x dv has the direction of the normal.
/// \return nothing where this limit does not exist either.
std::optional<Vec3> limit_normal(const SurfaceJet& jet, const InwardSigns& inward);

}  // namespace endmill
