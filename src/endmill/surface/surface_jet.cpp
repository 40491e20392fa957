// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/surface_jet.h"

#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

// Sine of the angle between the partial derivatives up to which their cross product is
// rounding.
constexpr double parallel_sine = 1e-10;

// The number rounded to a multiple of 1 / `steps`, without a minus zero.
std::string rounded_text(double value, double steps)
{
    return to_text(std::round(value * steps) / steps + 0.0);
}

}  // namespace

SurfaceTangents projected(const SurfaceTangents& homogeneous,
                          const Eigen::Matrix2d& weight)
{
    const auto& w = weight;
    const Vec3 point = homogeneous.point / w(0, 0);
    return {point, (homogeneous.du - w(1, 0) * point) / w(0, 0),
            (homogeneous.dv - w(0, 1) * point) / w(0, 0)};
}

SurfaceJet projected(const SurfaceJet& homogeneous, const Eigen::Matrix3d& weight)
{
    const auto& [h, hu, hv, huu, huv, hvv] = homogeneous;
    const auto& w = weight;
    const Eigen::Matrix2d first = w.topLeftCorner<2, 2>();
    const auto [point, du, dv] = projected(SurfaceTangents{h, hu, hv}, first);
    return {point,
            du,
            dv,
            (huu - 2 * w(1, 0) * du - w(2, 0) * point) / w(0, 0),
            (huv - w(1, 0) * dv - w(0, 1) * du - w(1, 1) * point) / w(0, 0),
            (hvv - 2 * w(0, 1) * dv - w(0, 2) * point) / w(0, 0)};
}

bool is_singular(const SurfaceTangents& tangents)
{
    return is_singular(tangents, tangents.du.cross(tangents.dv));
}

bool is_singular(const SurfaceTangents& tangents, const Vec3& across)
{
    const double area2 = across.squaredNorm();
    const double sides2 = tangents.du.squaredNorm() * tangents.dv.squaredNorm();
    return !(area2 > parallel_sine * parallel_sine * sides2);
}

Vec3 unit_normal(const SurfaceTangents& tangents)
{
    if (is_singular(tangents))
        throw GeometryError{
            "unit_normal: the partial derivatives are parallel or vanish"};
    return tangents.du.cross(tangents.dv).normalized();
}

std::optional<Vec3> limit_normal(const SurfaceJet& jet, const InwardSigns& inward)
{
    SurfaceTangents tangents{jet.point, jet.du, jet.dv};
    const double du2 = jet.du.squaredNorm();
    const double dv2 = jet.dv.squaredNorm();
    if (du2 <= vanishing_partial_share * vanishing_partial_share * dv2)
        tangents.du = inward.v * jet.duv;
    else if (dv2 <= vanishing_partial_share * vanishing_partial_share * du2)
        tangents.dv = inward.u * jet.duv;
    if (is_singular(tangents))
        return std::nullopt;
    return tangents.du.cross(tangents.dv).normalized();
}

std::string place_text(const SurfacePoint& at, const Vec3& point)
{
    const auto parameter = [](double value) { return rounded_text(value, 1e4); };
    const auto mm = [](double value) { return rounded_text(value, 1e3); };
    return "u = " + parameter(at.u) + ", v = " + parameter(at.v) + " (" + mm(point.x()) +
           ", " + mm(point.y()) + ", " + mm(point.z()) + " mm)";
}

}  // namespace endmill
