// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/straight_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Steps of a bracketed search. It halves the bracket at least every other step, which
// reaches neighbouring doubles long before.
constexpr int most_iterations = 200;

}  // namespace

StraightSweep::StraightSweep(const Cutter& cutter, const Vec3& from, const Vec3& to)
    : cutter_{cutter},
      from_{from},
      to_{to}
{
    require(from.allFinite() && to.allFinite(), "StraightSweep: a tip is not finite");
    const double dx = to.x() - from.x();
    const double dy = to.y() - from.y();
    length_ = std::hypot(dx, dy);
    direction_x_ = length_ > 0 ? dx / length_ : 1;
    direction_y_ = length_ > 0 ? dy / length_ : 0;
    slope_ = length_ > 0 ? (to.z() - from.z()) / length_ : 0;
    if (length_ == 0)
        from_.z() = to_.z() = std::min(from.z(), to.z());
}

// Let s and e be the place's coordinates along and across the move. A cutter that is
// `along` on the move covers the place if |s - along| <= w = sqrt(R^2 - e^2). The surface
// S is the least height of the cutter's bottom over these positions:
// 1. Ball: the envelope of the spheres touches where the cutter is s - slope w / sqrt(1 +
//    slope^2), or at an end of the range.
// 2. Level move: the cutter that is nearest to the place.
// 3. Flat cutter: the lower end of the range.
// 4. Bull-nose: a search, see `corner_along`.
StraightSweep::Height StraightSweep::at(double x, double y) const
{
    const double R = cutter_.radius();
    const double dx = x - from_.x();
    const double dy = y - from_.y();
    const double s = dx * direction_x_ + dy * direction_y_;
    const double e = dy * direction_x_ - dx * direction_y_;
    const double q = (R - e) * (R + e);
    if (!(q >= 0))
        return {infinite, 0};
    const double w = std::sqrt(q);
    const double low = std::max(0.0, s - w);
    const double high = std::min(length_, s + w);
    if (!(low <= high))
        return {infinite, 0};
    double along;
    if (cutter_.is_ball())
        along = std::clamp(s - slope_ * w / std::sqrt(1 + slope_ * slope_), low, high);
    else if (slope_ == 0)
        along = std::clamp(s, low, high);
    else if (cutter_.is_flat())
        along = slope_ > 0 ? low : high;
    else
        along = corner_along(s, e * e, low, high);
    // Rounding may put the ends of the range outside the rim.
    const double distance = std::min(std::sqrt((s - along) * (s - along) + e * e), R);
    return {from_.z() + slope_ * along + cutter_.profile(distance), along};
}

// Minimises slope u + profile(d(u)) over low <= u <= high, with d(u) = sqrt(e^2 + (u -
// s)^2). The function is convex, and its slope is infinite at the rim. Under the flat
// bottom it is linear, so the minimum lies on the torus or at an end of the range. It is
// found by Newton's method within a bracket.
double StraightSweep::corner_along(double s, double e2, double low, double high) const
{
    const double r = cutter_.corner_radius();
    const double c = cutter_.flat_radius();
    const double sign = slope_ > 0 ? -1 : 1;  // side of s on which the minimum lies
    // With t = sign (u - s) >= 0, the derivative g(t) = profile'(d) t / d - |m| rises
    // from -|m|.
    const double m = std::abs(slope_);
    const double t_low = std::max(0.0, sign > 0 ? low - s : s - high);
    const double t_high = sign > 0 ? high - s : s - low;
    if (t_high <= 0)  // the whole range lies on the other side of s
        return sign > 0 ? high : low;
    const auto slope_at = [&](double t, double& curvature) {
        const double d = std::sqrt(e2 + t * t);
        const double a = d - c;
        if (a <= 0) {
            curvature = 0;
            return -m;
        }
        const double root = std::sqrt(std::max(0.0, (r - a) * (r + a)));
        const double bend = a / root;  // derivative of the profile
        const double share = t / d;
        curvature =
            r * r / (root * root * root) * share * share + bend * e2 / (d * d * d);
        return bend * share - m;
    };
    double below = t_low;
    double above = t_high;
    double curvature = 0;
    // Where the torus has the slope of the move, at e = 0; it is a good first guess also
    // elsewhere. On a short move it mostly lies beyond an end of the range, which is then
    // the minimum.
    const double tube = c + r * m / std::sqrt(1 + m * m);
    const double guess = std::sqrt(std::max(0.0, tube * tube - e2));
    if (guess >= above && slope_at(above, curvature) <= 0)
        return s + sign * above;
    if (slope_at(below, curvature) >= 0)
        return s + sign * below;
    if (guess < above && slope_at(above, curvature) <= 0)
        return s + sign * above;
    double t = std::clamp(guess, below, above);
    for (int i = 0; i < most_iterations && below < above; ++i) {
        const double g = slope_at(t, curvature);
        if (g == 0)
            break;
        (g < 0 ? below : above) = t;
        double next = t - g / curvature;
        if (!(next > below && next < above))
            next = below + (above - below) / 2;
        const bool is_there = next == t || next == below || next == above;
        t = next;
        if (is_there)
            break;
    }
    return s + sign * t;
}

}  // namespace endmill
