// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/contact_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "endmill/core/error.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/tool_side.h"

// The foot minimises the squared distance to the centre. `foot_from` runs Newton's
// method:
// 1. Take a Newton step on half the squared distance, with parameters held at their
//    bounds where the gradient points outwards.
// 2. Halve the step until the distance does not grow.
// 3. Stop if no step helps, or if the point moves by less than the tolerance.
// `foot` first tries the place of a neighbour, which usually converges in a few steps. If
// the distance found there is not the expected one, it starts again at the nearest
// sample.

namespace endmill {
namespace {

constexpr int most_samples_a_patch_side = 16;
constexpr int least_samples_a_patch_side = 3;
constexpr double most_samples = 300'000;

// Largest number of Newton steps. A search from a neighbouring place needs a few; the
// bound is for a search from a distant sample.
constexpr int most_steps = 60;
constexpr int most_halvings = 30;

// A step that moves the point by less than this share of the surface's diagonal ends the
// search.
constexpr double step_tolerance = 1e-12;

// Share of the trace of the first fundamental form that is added to its diagonal. It
// keeps the system solvable at a pole.
constexpr double damping = 1e-12;

// Share of the surface's diagonal. If the foot is nearer to the centre, the direction
// between them is dominated by rounding.
constexpr double coincidence = 1e-9;

// Relative rounding error of a squared distance. Near the foot the distance is
// stationary, so a step that does not reduce it by more than this may still bring the
// place nearer.
constexpr double distance_rounding = 1e-14;

struct PlaneVector {
    double u;
    double v;
};

// The step that minimises the quadratic model with gradient g and matrix [a b; b c]. The
// step is 0 along a parameter that is held at its bound.
PlaneVector model_step(PlaneVector g, const Eigen::Matrix2d& matrix, bool hold_u,
                       bool hold_v)
{
    const double a = matrix(0, 0);
    const double c = matrix(1, 1);
    if (hold_u || hold_v)
        return {hold_u ? 0 : -g.u / a, hold_v ? 0 : -g.v / c};
    const double b = matrix(0, 1);
    const double determinant = a * c - b * b;
    return {-(c * g.u - b * g.v) / determinant, -(a * g.v - b * g.u) / determinant};
}

// Hessian of half the squared distance if it is positive definite. Otherwise the first
// fundamental form alone, without the curvature of the surface.
Eigen::Matrix2d distance_hessian(const SurfaceJet& jet, const Vec3& offset)
{
    Eigen::Matrix2d first;
    first << jet.du.dot(jet.du), jet.du.dot(jet.dv), jet.du.dot(jet.dv),
        jet.dv.dot(jet.dv);
    Eigen::Matrix2d bend;
    bend << jet.duu.dot(offset), jet.duv.dot(offset), jet.duv.dot(offset),
        jet.dvv.dot(offset);
    Eigen::Matrix2d whole = first + bend;
    const double least = damping * first.trace();
    if (whole(0, 0) > least && whole(1, 1) > least &&
        whole.determinant() > least * first.trace())
        return whole;
    return first + Eigen::Matrix2d::Identity() * std::max(least, damping);
}

// Whether the parameter is at a bound and the gradient points outwards.
bool is_held(double at, double gradient, const Interval& range)
{
    return (at <= range.low && gradient > 0) || (at >= range.high && gradient < 0);
}

int samples_a_side(std::span<const Surface> surfaces)
{
    double patches = 0;
    for (const Surface& surface : surfaces)
        patches += static_cast<double>(surface.patches(Parameter::U)) *
                   surface.patches(Parameter::V);
    return static_cast<int>(std::clamp(std::sqrt(most_samples / patches),
                                       static_cast<double>(least_samples_a_patch_side),
                                       static_cast<double>(most_samples_a_patch_side)));
}

// Parameters of the samples: `count` per patch, in the middles of equal parts.
std::vector<double> sampled_parameters(std::span<const double> breaks, int count)
{
    std::vector<double> all;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int k = 0; k < count; ++k)
            all.push_back(std::lerp(breaks[i], breaks[i + 1], (k + 0.5) / count));
    return all;
}

}  // namespace

ContactSearch::ContactSearch(std::span<const Surface> surfaces)
    : surfaces_{surfaces},
      sides_{tool_side_signs(surfaces, Vec3::UnitZ())}
{
    require(!surfaces.empty(), "ContactSearch: need a surface");
    const int count = samples_a_side(surfaces);
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        for (const double v : sampled_parameters(surfaces[s].breaks(Parameter::V), count))
            for (const double u :
                 sampled_parameters(surfaces[s].breaks(Parameter::U), count)) {
                places_.push_back({s, u, v});
                samples_.push_back(surfaces[s].tangents(u, v).point);
            }
    tree_.emplace(samples_);
}

BallFoot ContactSearch::foot_from(const Vec3& centre, const FootPlace& start) const
{
    const Surface& surface = surfaces_[start.surface];
    const Interval range_u = surface.range(Parameter::U);
    const Interval range_v = surface.range(Parameter::V);
    FootPlace at{start.surface, std::clamp(start.u, range_u.low, range_u.high),
                 std::clamp(start.v, range_v.low, range_v.high)};
    SurfaceJet jet = surface.jet(at.u, at.v);
    const double enough = step_tolerance * surface.diagonal();
    for (int step = 0; step < most_steps; ++step) {
        const Vec3 offset = jet.point - centre;
        const PlaneVector gradient{jet.du.dot(offset), jet.dv.dot(offset)};
        const PlaneVector way = model_step(gradient, distance_hessian(jet, offset),
                                           is_held(at.u, gradient.u, range_u),
                                           is_held(at.v, gradient.v, range_v));
        const double before = offset.squaredNorm();
        double share = 1;
        bool is_better = false;
        FootPlace next = at;
        SurfaceJet there = jet;
        for (int halving = 0; halving < most_halvings && !is_better; ++halving) {
            next.u = std::clamp(at.u + share * way.u, range_u.low, range_u.high);
            next.v = std::clamp(at.v + share * way.v, range_v.low, range_v.high);
            there = surface.jet(next.u, next.v);
            is_better =
                (there.point - centre).squaredNorm() <= (1 + distance_rounding) * before;
            share /= 2;
        }
        if (!is_better)
            break;
        const double moved = (there.point - jet.point).norm();
        at = next;
        jet = there;
        if (moved <= enough)
            break;
    }
    const Vec3 offset = centre - jet.point;
    const double distance = offset.norm();
    const bool is_normal_known = !is_singular(SurfaceTangents{jet.point, jet.du, jet.dv});
    const Vec3 side = is_normal_known
                          ? Vec3{sides_[at.surface] *
                                 unit_normal(SurfaceTangents{jet.point, jet.du, jet.dv})}
                          : Vec3{Vec3::UnitZ()};
    const bool is_apart = distance > coincidence * surface.diagonal();
    const bool is_behind = offset.dot(side) < 0;
    const Vec3 normal = is_apart ? Vec3{(is_behind ? -1 : 1) * offset / distance} : side;
    return {at, jet.point, normal, is_behind ? -distance : distance};
}

BallFoot ContactSearch::foot(const Vec3& centre, const std::optional<FootPlace>& near,
                             double distance, double tolerance) const
{
    std::optional<BallFoot> close;
    if (near) {
        close = foot_from(centre, *near);
        if (std::abs(close->distance - distance) <= tolerance)
            return *close;
    }
    const auto sample =
        tree_->nearest_within(centre, std::numeric_limits<double>::infinity());
    BallFoot far = foot_from(centre, places_[sample.value_or(0)]);
    if (close && std::abs(close->distance - distance) < std::abs(far.distance - distance))
        return *close;
    return far;
}

std::optional<double> ContactSearch::curvature(const FootPlace& place,
                                               const Vec3& direction) const
{
    const SurfaceJet jet = surfaces_[place.surface].jet(place.u, place.v);
    if (is_singular(SurfaceTangents{jet.point, jet.du, jet.dv}))
        return std::nullopt;
    const FundamentalForms forms = fundamental_forms(jet, sides_[place.surface]);
    TangentVector tangent = tangent_components(forms, jet, direction);
    const double length = (tangent.a * jet.du + tangent.b * jet.dv).norm();
    if (!(length > 0))
        return std::nullopt;
    tangent.a /= length;
    tangent.b /= length;
    return normal_curvature(forms, tangent);
}

}  // namespace endmill
