// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_edges.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>

#include <Eigen/Geometry>

#include "endmill/setup/detail/setup_rules.h"
#include "endmill/setup/detail/spherical_hull.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

// Least cosine of a direction with the tool axis. Closer to 90 degrees, gnomonic images
// are a million times farther out than those of other directions, and rounding decides
// their hull.
constexpr double lowest_cosine = 1e-6;

RotaryRange with_opposite(const RotaryRange& alpha)
{
    return alpha.to >= -alpha.from ? RotaryRange{alpha.from, pi}
                                   : RotaryRange{-pi, alpha.to};
}

// Calls `take` with the two ends of each edge of a closed polygon. A polygon of two
// vertices has one edge.
template <class Take>
void for_each_edge(const std::vector<Vec3>& hull, const Take& take)
{
    if (hull.size() < 2)
        return;
    for (std::size_t i = hull.size() == 2 ? 1 : 0; i < hull.size(); ++i)
        take(hull[i], hull[(i + 1) % hull.size()]);
}

// Calls `take` with the magnitude of each end of a range that is below 90 degrees.
// Directions that are not low never reach the other ends.
template <class Take>
void for_each_limit(const RotaryRange& range, const Take& take)
{
    for (const double limit : {range.to, -range.from}) {
        if (limit < pi / 2)
            take(limit);
    }
}

}  // namespace

bool has_low_direction(const PolePoints& points)
{
    return std::any_of(points.z.begin(), points.z.end(),
                       [](double z) { return z < lowest_cosine; });
}

std::optional<RectangleCandidate> great_circle_arc(const PolePoints& points)
{
    std::size_t farthest = 0;
    double rho = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double next = std::hypot(points.x[i], points.y[i]);
        if (next > rho) {
            rho = next;
            farthest = i;
        }
    }
    // R1 is perpendicular to the direction farthest from the tool axis. If all directions
    // lie along the tool axis, every R1 fits.
    const bool is_point = rho <= equal_angles;
    const double dx = is_point ? 1 : points.y[farthest] / rho;
    const double dy = is_point ? 0 : -points.x[farthest] / rho;
    RotaryRange alpha{0, 0};
    bool has_opposite = false;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double off = points.x[i] * dx + points.y[i] * dy;
        if (std::abs(off) > equal_angles)
            return std::nullopt;
        if (std::hypot(points.x[i], points.y[i]) <= equal_angles) {
            has_opposite = has_opposite || points.z[i] < 0;
            continue;
        }
        const double turn = std::atan2(points.x[i] * dy - points.y[i] * dx, points.z[i]);
        alpha = {std::min(alpha.from, turn), std::max(alpha.to, turn)};
    }
    if (has_opposite)
        alpha = with_opposite(alpha);
    return RectangleCandidate{dx * points.frame.x + dy * points.frame.y,
                              alpha,
                              {0, 0},
                              RectangleOrigin::GreatCircle};
}

RectangleImages::RectangleImages(const PolePoints& points,
                                 std::span<const Vec3> directions, SetupMode mode)
    : frame_{points.frame},
      gnomonic_hull_{spherical_hull(frame_.pole, directions, HullProjection::Gnomonic)}
{
    const SetupRules& rules = setup_rules(mode);
    if (rules.has_both_hulls)
        orthographic_hull_ =
            spherical_hull(frame_.pole, directions, HullProjection::Orthographic);
    for (const Vec3& v : gnomonic_hull_) {
        const double z = frame_.pole.dot(v);
        gnomonic_.push_back({frame_.x.dot(v) / z, frame_.y.dot(v) / z});
    }
    if (rules.takes_hull_vertices_only || rules.has_both_hulls) {
        for (const Vec3& v : rules.has_both_hulls ? orthographic_hull_ : gnomonic_hull_)
            orthographic_.push_back({frame_.x.dot(v), frame_.y.dot(v)});
    } else {
        for (std::size_t i = 0; i < points.size(); ++i)
            orthographic_.push_back({points.x[i], points.y[i]});
    }
}

std::vector<RectangleCandidate> RectangleImages::at_edges() const
{
    std::vector<RectangleCandidate> found;
    const auto add = [&](const Vec3& axis, RectangleOrigin origin) {
        const double length = axis.norm();
        if (length > 0)
            found.push_back(rectangle(axis / length, origin));
    };
    // V x (V' - V) equals V x V', and is accurate for vertices close to each other.
    for_each_edge(gnomonic_hull_, [&](const Vec3& a, const Vec3& b) {
        add(frame_.pole.cross(a.cross(b - a)), RectangleOrigin::GnomonicEdge);
    });
    for_each_edge(orthographic_hull_, [&](const Vec3& a, const Vec3& b) {
        add(frame_.pole.cross(b - a), RectangleOrigin::OrthographicEdge);
    });
    return found;
}

std::vector<RectangleCandidate> RectangleImages::at_limits(
    const RotaryLimits& limits) const
{
    std::vector<RectangleCandidate> found;
    // An image at the distance r has g . e = r sin(psi - azimuth), o . d = r cos(psi -
    // azimuth). Only positive limits are solved for; a negative one gives the same
    // rectangle with R1 reversed.
    for_each_limit(limits.phi, [&](double limit) {
        for (const Image& g : gnomonic_) {
            const double ratio = std::tan(limit) / std::hypot(g.x, g.y);
            if (!(ratio <= 1))
                continue;
            add_at(std::atan2(g.y, g.x) + std::asin(ratio), found);
            add_at(std::atan2(g.y, g.x) + pi - std::asin(ratio), found);
        }
    });
    for_each_limit(limits.theta, [&](double limit) {
        for (const Image& o : orthographic_) {
            const double ratio = std::sin(limit) / std::hypot(o.x, o.y);
            if (!(ratio <= 1))
                continue;
            add_at(std::atan2(o.y, o.x) + std::acos(ratio), found);
            add_at(std::atan2(o.y, o.x) - std::acos(ratio), found);
        }
    });
    return found;
}

void RectangleImages::add_at(double azimuth, std::vector<RectangleCandidate>& found) const
{
    found.push_back(rectangle(frame_.equator(azimuth), RectangleOrigin::Limit));
}

RectangleCandidate RectangleImages::rectangle(const Vec3& r1_axis,
                                              RectangleOrigin origin) const
{
    const double dx = frame_.x.dot(r1_axis);
    const double dy = frame_.y.dot(r1_axis);
    RotaryRange tangent{0, 0};
    for (const Image& g : gnomonic_) {
        const double value = g.x * dy - g.y * dx;
        tangent = {std::min(tangent.from, value), std::max(tangent.to, value)};
    }
    RotaryRange sine{0, 0};
    for (const Image& o : orthographic_) {
        const double value = o.x * dx + o.y * dy;
        sine = {std::min(sine.from, value), std::max(sine.to, value)};
    }
    return {r1_axis,
            {std::atan(tangent.from), std::atan(tangent.to)},
            {std::asin(std::max(sine.from, -1.0)), std::asin(std::min(sine.to, 1.0))},
            origin};
}

}  // namespace endmill
