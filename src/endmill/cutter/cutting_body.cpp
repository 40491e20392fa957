// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/cutting_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"

// The search of `searched` keeps the tangents of the convex function at the ends of a
// bracket around the minimum. Where they meet is a lower bound; the weights with which
// they are combined there make a plane without slope along the segment, which bounds the
// distances of a moved segment too.

namespace endmill {
namespace {

// Accuracy of the least distance in mm, far below every tolerance.
constexpr double least_accuracy = 1e-8;
// The bracket halves at least every other step; the accuracy is reached long before.
constexpr int most_steps = 100;

}  // namespace

CuttingBody::CuttingBody(const Cutter& cutter, double length)
    : cutter_{cutter},
      length_{length}
{
    require(length > 0 && length >= cutter.corner_radius(),
            "CuttingBody: need 0 < length and corner radius <= length");
}

CuttingBody CuttingBody::of_cylinder(const ToolCylinder& cylinder)
{
    require(cylinder.from >= 0, "CuttingBody: need 0 <= from");
    CuttingBody body{Cutter::flat(cylinder.diameter / 2), cylinder.to - cylinder.from};
    body.base_ = cylinder.from;
    body.length_ = cylinder.to;
    return body;
}

CuttingBody::Distance CuttingBody::distance(const Vec3& place) const
{
    Distance found = endless_distance(place);
    if (place.z() - length_ > found.value)
        return {place.z() - length_, Vec3::UnitZ()};
    return found;
}

// The distance without the upper end.
CuttingBody::Distance CuttingBody::endless_distance(const Vec3& place) const
{
    const double r = cutter_.corner_radius();
    const double h = place.z() - base_ - r;
    const double d = std::sqrt(place.x() * place.x() + place.y() * place.y());
    const double out = d - cutter_.flat_radius();
    const auto across = [&](double share) -> Vec3 {
        return d > 0 ? Vec3{share / d * place.x(), share / d * place.y(), 0}
                     : Vec3{Vec3::Zero()};
    };
    if (out > 0 && h < 0) {
        const double length = std::sqrt(out * out + h * h);
        Vec3 gradient = across(out / length);
        gradient.z() = h / length;
        return {length - r, gradient};
    }
    if (out >= -h)
        return {out - r, across(1)};
    return {-h - r, -Vec3::UnitZ()};
}

CuttingBody::Least CuttingBody::searched(const Vec3& from, const Vec3& to,
                                         double enough) const
{
    const Vec3 way = to - from;
    double low = 0;
    double high = 1;
    Distance at_low = distance(from);
    double slope_low = at_low.gradient.dot(way);
    if (!(slope_low < 0))
        return {at_low.value, 0, at_low.value, at_low.gradient};
    Distance at_high = distance(to);
    double slope_high = at_high.gradient.dot(way);
    if (!(slope_high > 0))
        return {at_high.value, 1, at_high.value, at_high.gradient};
    Least least{};
    for (int step = 0;; ++step) {
        // Tangents at both ends, and where they meet.
        const double width = high - low;
        const double share = slope_high / (slope_high - slope_low);
        const double meet =
            std::clamp((at_low.value - at_high.value + slope_high * width) /
                           (slope_high - slope_low),
                       0.0, width);
        const bool low_is_less = at_low.value <= at_high.value;
        least.value = low_is_less ? at_low.value : at_high.value;
        least.at = low_is_less ? low : high;
        least.lower = std::min(at_low.value + slope_low * meet, least.value);
        if (least.value - least.lower <= least_accuracy || least.lower >= enough ||
            step == most_steps) {
            least.gradient = share * at_low.gradient + (1 - share) * at_high.gradient;
            return least;
        }
        // In turn: where the tangents meet, where the slope would vanish if it were
        // linear, the middle.
        const double secant = -slope_low / (slope_high - slope_low) * width;
        const std::array<double, 3> candidates{meet, secant, width / 2};
        const double next = candidates[static_cast<std::size_t>(step % 3)];
        const double u = low + (next > 0 && next < width ? next : width / 2);
        const Distance here = distance(from + u * way);
        const double slope = here.gradient.dot(way);
        if (slope == 0)
            return {here.value, u, here.value, here.gradient};
        if (slope < 0) {
            low = u;
            at_low = here;
            slope_low = slope;
        } else {
            high = u;
            at_high = here;
            slope_high = slope;
        }
    }
}

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Share of the coordinates by which a near stretch is longer, for rounding.
constexpr double rounding_share = 1e-12;

// Returns where a + b s <= 0.
std::optional<CuttingBody::Stretch> below_zero(double a, double b)
{
    if (b == 0)
        return a <= 0 ? std::optional{CuttingBody::Stretch{-infinite, infinite}}
                      : std::nullopt;
    const double root = -a / b;
    return b > 0 ? CuttingBody::Stretch{-infinite, root}
                 : CuttingBody::Stretch{root, infinite};
}

// Returns where a s^2 + 2 b s + c <= 0, for a >= 0 that vanishes only with b.
std::optional<CuttingBody::Stretch> below_zero(double a, double b, double c)
{
    if (!(a > 0))
        return below_zero(c, 2 * b);
    const double under_root = b * b - a * c;
    if (under_root < 0)
        return std::nullopt;
    const double root = std::sqrt(under_root);
    return CuttingBody::Stretch{(-b - root) / a, (-b + root) / a};
}

std::optional<CuttingBody::Stretch> common(const std::optional<CuttingBody::Stretch>& a,
                                           const std::optional<CuttingBody::Stretch>& b)
{
    if (!a || !b)
        return std::nullopt;
    const CuttingBody::Stretch both{std::max(a->from, b->from), std::min(a->to, b->to)};
    return both.from <= both.to ? std::optional{both} : std::nullopt;
}

}  // namespace

std::optional<CuttingBody::Stretch> CuttingBody::near_stretch(const Vec3& start,
                                                              const Vec3& direction,
                                                              double within) const
{
    const double grown = within + rounding_share * (1 + start.cwiseAbs().maxCoeff());
    const double radius = cutter_.radius() + grown;
    const double level = direction.x() * direction.x() + direction.y() * direction.y();
    const double towards = start.x() * direction.x() + start.y() * direction.y();
    const double outside =
        start.x() * start.x() + start.y() * start.y() - radius * radius;
    const auto beside = below_zero(level, towards, outside);
    if (!beside)
        return std::nullopt;
    auto near = beside;
    if (cutter_.is_ball()) {
        const double h = start.z() - cutter_.radius();
        near = common(beside, below_zero(-h, -direction.z()));
        const auto in_ball = below_zero(level + direction.z() * direction.z(),
                                        towards + h * direction.z(), outside + h * h);
        if (!near) {
            near = in_ball;
        } else if (in_ball) {
            near = Stretch{std::min(near->from, in_ball->from),
                           std::max(near->to, in_ball->to)};
        }
    } else {
        near = common(beside, below_zero(base_ - grown - start.z(), -direction.z()));
    }
    if (std::isinf(length_))
        return near;
    return common(near, below_zero(start.z() - length_ - grown, direction.z()));
}

double CuttingBody::support(const Vec3& direction) const
{
    const double beside = direction.head<2>().norm();
    const double top = std::isinf(length_) ? -std::numeric_limits<double>::infinity()
                                           : direction.z() * length_;
    if (direction.z() < 0)
        return top - cutter_.radius() * beside;
    const double r = cutter_.corner_radius();
    return (base_ + r) * direction.z() - r - cutter_.flat_radius() * beside;
}

}  // namespace endmill
