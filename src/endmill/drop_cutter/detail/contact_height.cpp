// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/contact_height.h"

#include <cmath>

namespace endmill {
namespace {

// Share of R^2 by which a point may lie beyond the rim of a flat cutter, because of
// rounding.
constexpr double rim_slack = 1e-12;

// A function of x and y with its first and second derivatives.
struct PlanFunction {
    double value;
    Eigen::Vector2d gradient;
    Eigen::Matrix2d hessian;
};

// The height of the cutter's surface above its tip at the offset `across` from the axis;
// nothing where the surface is vertical. With d = rho - (R - r) and w^2 = r^2 - d^2 the
// height is d^2 / (r + w), and its derivatives by rho are d / w and r^2 / w^3.
std::optional<PlanFunction> profile_at(const Cutter& cutter,
                                       const Eigen::Vector2d& across)
{
    const double rho = across.norm();
    const double beyond = rho - cutter.flat_radius();
    if (beyond <= 0 || cutter.is_flat())
        return PlanFunction{0, Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
    const double r = cutter.corner_radius();
    const double w2 = (r - beyond) * (r + beyond);
    if (!(w2 > 0))
        return std::nullopt;
    const double w = std::sqrt(w2);
    const Eigen::Vector2d out = across / rho;
    const double turn = cutter.is_ball() ? 1 / w : beyond / (w * rho);
    const double bend = r * r / (w2 * w);
    const Eigen::Matrix2d radial = out * out.transpose();
    return PlanFunction{beyond * beyond / (r + w), beyond / w * out,
                        bend * radial + turn * (Eigen::Matrix2d::Identity() - radial)};
}

}  // namespace

std::optional<ContactHeight> contact_height(const SurfaceJet& jet, const Cutter& cutter,
                                            const Eigen::Vector2d& axis)
{
    const Eigen::Vector2d across = jet.point.head<2>() - axis;
    const double R = cutter.radius();
    const double rim = (across.squaredNorm() - R * R) / 2;
    if (!(rim <= rim_slack * R * R))
        return std::nullopt;
    const auto profile = profile_at(cutter, across);
    if (!profile)
        return std::nullopt;
    Eigen::Matrix2d plan;  // derivatives of x and y by u and v
    plan << jet.du.head<2>(), jet.dv.head<2>();
    // The second partial derivatives by u and v of the point's component along a vector.
    // They belong to a function of x and y whose gradient is that vector.
    const auto bent = [&](const Vec3& along) {
        Eigen::Matrix2d second;
        second << along.dot(jet.duu), along.dot(jet.duv), along.dot(jet.duv),
            along.dot(jet.dvv);
        return second;
    };
    const Vec3 up{-profile->gradient.x(), -profile->gradient.y(), 1};
    const Vec3 out{across.x(), across.y(), 0};
    return ContactHeight{jet.point,
                         jet.point.z() + cutter.corner_radius() - profile->value,
                         {up.dot(jet.du), up.dot(jet.dv)},
                         bent(up) - plan.transpose() * profile->hessian * plan,
                         rim,
                         plan.transpose() * across,
                         bent(out) + plan.transpose() * plan,
                         profile->gradient,
                         {jet.du.norm(), jet.dv.norm()}};
}

}  // namespace endmill
