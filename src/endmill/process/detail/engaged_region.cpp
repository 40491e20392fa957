// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/engaged_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "endmill/core/error.h"

// The borders of the engaged region below the stock's top are found per kind (`borders`):
// - Front: the great circle is split where it meets the top, the wall and the previous
//   pass, and the parts that the previous pass has left are kept.
// - PreviousBall: `sign_changes` gives the parts of the curve below the top, and
//   optionally the places where the curve crosses X = 0.
// - Wall: a circle, whose ends are closed formulas.
// `ranges_at` proceeds likewise on a circle of latitude: it collects all places where a
// border may cross the circle, sorts them, and tests the middle of each range.

namespace endmill {
namespace {

using std::numbers::pi;

// The condition P_z + cosine > 0 on the curve of the previous pass.
PassCondition above(const EngagedRegion& region, double cosine)
{
    return {cosine - region.pass.rise * region.cos_lambda, -region.cos_lambda,
            region.sin_lambda};
}

// The condition P_x > 0 on the curve of the previous pass.
PassCondition in_front_of_axis(const EngagedRegion& region)
{
    return {region.pass.rise * region.sin_lambda, region.sin_lambda, region.cos_lambda};
}

// The parameter p of an angle with this sine and cosine.
double half_tangent(double sine, double cosine)
{
    return sine / (1 + cosine);
}

// The second leg of a right triangle; 0 if rounding makes the leg longer than the
// hypotenuse.
double other_leg(double hypotenuse, double leg)
{
    return std::sqrt(std::max(0.0, (hypotenuse - leg) * (hypotenuse + leg)));
}

// Adds the parts of the front plane below the top that the previous pass has left. Its
// candidates for end points split it; the middle of each part decides.
void add_front(const EngagedRegion& region, std::vector<BorderArc>& arcs)
{
    if (region.top_cosine >= region.cos_lambda)
        return;
    const double low_cosine = region.top_cosine / region.cos_lambda;
    const double end = half_tangent(other_leg(1, low_cosine), low_cosine);
    std::array<double, 6> knots{-end, end};
    int count = 2;
    const auto add = [&](double p) {
        if (std::abs(p) < end)
            knots[count++] = p;
    };
    if (region.previous == PreviousPass::Edge)
        add(0);
    if (std::abs(region.wall) < 1)
        add(-half_tangent(region.wall, other_leg(1, region.wall)));
    if (region.previous == PreviousPass::Beside && region.pass.pick_feed < 2) {
        const double half_chord = other_leg(1, region.pass.pick_feed / 2);
        for (const double side : {-half_chord, half_chord}) {
            const double y = -region.pass.across / 2 - side * region.pass.sin_mu;
            const double w = -region.pass.rise / 2 + side * region.pass.cos_mu;
            add(half_tangent(-y, -w));
        }
    }
    std::sort(knots.begin(), knots.begin() + count);
    for (int k = count - 1; k > 0; --k) {
        const double middle = (knots[k - 1] + knots[k]) / 2;
        if (!region.previous_left(region.point(BorderKind::Front, middle)))
            continue;
        if (!arcs.empty() && arcs.back().to == knots[k])
            arcs.back().to = knots[k - 1];
        else
            arcs.push_back({BorderKind::Front, knots[k], knots[k - 1]});
    }
}

// Adds the parts of the previous pass's curve below the top.
void add_previous_ball(const EngagedRegion& region, BorderSplit split,
                       std::vector<BorderArc>& arcs)
{
    const SignChanges& top = region.below_top;
    SignChanges axis;
    if (split == BorderSplit::AtAxis && region.sin_lambda < 0)
        axis = sign_changes(region.pass, in_front_of_axis(region));
    for (int k = 0; k <= top.count; ++k) {
        if (top.is_positive == (k % 2 == 0))
            continue;
        double from = k > 0 ? top.at[k - 1] : region.pass.first;
        const double to = k < top.count ? top.at[k] : 1;
        for (int j = 0; j < axis.count; ++j)
            if (axis.at[j] > from && axis.at[j] < to) {
                arcs.push_back({BorderKind::PreviousBall, from, axis.at[j]});
                from = axis.at[j];
            }
        if (from < to)
            arcs.push_back({BorderKind::PreviousBall, from, to});
    }
}

// Lower end in p of the wall, where the previous pass or the front plane bounds it.
// std::nullopt if no part of the wall is engaged.
std::optional<double> wall_begin(const EngagedRegion& region)
{
    const double front = half_tangent(region.sin_lambda, region.cos_lambda);
    if (region.previous != PreviousPass::Beside)
        return front;
    const double tau2 =
        2 * region.pass.across - region.pass.pick_feed * region.pass.pick_feed;
    if (tau2 <= 0)
        return region.pass.rise > 0 ? std::optional{front} : std::nullopt;
    const double tau = std::sqrt(tau2);
    const double x = tau * region.cos_lambda + region.pass.rise * region.sin_lambda;
    const double z = tau * region.sin_lambda - region.pass.rise * region.cos_lambda;
    if (z >= 0)
        return std::nullopt;
    return x / (other_leg(1, region.wall) - z);
}

// Adds the part of the wall below the top.
void add_wall(const EngagedRegion& region, BorderSplit split,
              std::vector<BorderArc>& arcs)
{
    const double rho = other_leg(1, region.wall);
    if (std::abs(region.wall) >= 1 || rho <= region.top_cosine)
        return;
    const std::optional<double> begin = wall_begin(region);
    if (!begin)
        return;
    const double cosine = region.top_cosine / rho;
    const double high = half_tangent(other_leg(1, cosine), cosine);
    const double low = std::max(-high, *begin);
    if (split == BorderSplit::AtAxis && low < 0 && high > 0) {
        arcs.push_back({BorderKind::Wall, high, 0});
        arcs.push_back({BorderKind::Wall, 0, low});
    } else if (low < high) {
        arcs.push_back({BorderKind::Wall, high, low});
    }
}

}  // namespace

EngagedRegion::EngagedRegion(const BallEngagement& engagement)
    : previous{engagement.previous},
      pass{engagement},
      cos_lambda{std::cos(engagement.lambda)},
      sin_lambda{std::sin(engagement.lambda)},
      top_cosine{std::max(0.0, 1 - engagement.depth_ratio)},
      top_sine{engagement.depth_ratio < 1
                   ? std::sqrt(engagement.depth_ratio * (2 - engagement.depth_ratio))
                   : 1},
      depth{std::min(1.0, engagement.depth_ratio)},
      wall{previous == PreviousPass::Beside
               ? 1 - pass.across
               : (previous == PreviousPass::Edge ? 0.0 : 1.0)},
      below_top{sign_changes(pass, above(*this, top_cosine))}
{
}

bool EngagedRegion::previous_left(const Vec3& point) const
{
    if (previous == PreviousPass::None)
        return true;
    if (previous == PreviousPass::Edge)
        return point.y() > 0;
    const double from_axis = point.y() + pass.across;
    if (std::abs(from_axis) >= 1)
        return true;
    const double w = cos_lambda * point.z() - sin_lambda * point.x();
    return w <= -pass.rise - std::sqrt((1 - from_axis) * (1 + from_axis));
}

bool EngagedRegion::has(const Vec3& point) const
{
    return cos_lambda * point.x() + sin_lambda * point.z() > 0 && previous_left(point);
}

Vec3 EngagedRegion::point(BorderKind kind, double p) const
{
    const double sine = 2 * p / (1 + p * p);
    const double cosine = (1 - p) * (1 + p) / (1 + p * p);
    if (kind == BorderKind::Front)
        return {cosine * sin_lambda, -sine, -cosine * cos_lambda};
    if (kind == BorderKind::Wall) {
        const double rho = other_leg(1, wall);
        return {rho * sine, wall, -rho * cosine};
    }
    const PassPoint at_pass = pass_point(pass, p);
    const double w = -pass.rise - at_pass.cosine;
    return {at_pass.tau * cos_lambda - w * sin_lambda, at_pass.sine - pass.across,
            w * cos_lambda + at_pass.tau * sin_lambda};
}

BorderPoint EngagedRegion::moving_point(BorderKind kind, double p) const
{
    const double angle_rate = 2 / (1 + p * p);
    const double sine = p * angle_rate;
    const double cosine = (1 - p) * (1 + p) / (1 + p * p);
    const Vec3 at = point(kind, p);
    if (kind == BorderKind::Front)
        return {at, sin_lambda * angle_rate, sine * cos_lambda * angle_rate};
    if (kind == BorderKind::Wall) {
        const double rho = other_leg(1, wall);
        return {at, wall * rho * cosine * angle_rate, rho * sine * angle_rate};
    }
    const PassPoint at_pass = pass_point(pass, p);
    const double w_rate = at_pass.sine * at_pass.phi_by_x;
    const double x_rate = at_pass.tau_by_x * cos_lambda - w_rate * sin_lambda;
    const double y_rate = at_pass.cosine * at_pass.phi_by_x;
    const double z_rate = w_rate * cos_lambda + at_pass.tau_by_x * sin_lambda;
    return {at, (at.y() * x_rate - at.x() * y_rate) * angle_rate, z_rate * angle_rate};
}

double EngagedRegion::beside_axis() const
{
    return pass.across < 1 ? pass_parameter(pass, half_tangent(pass.across,
                                                               other_leg(1, pass.across)))
                           : pass.first;
}

bool EngagedRegion::is_radial(BorderKind kind) const
{
    return (kind == BorderKind::Front && sin_lambda == 0) ||
           (kind == BorderKind::Wall && wall == 0);
}

std::vector<AzimuthRange> EngagedRegion::ranges_at(double sine, double cosine) const
{
    std::array<double, 14> ends{-pi / 2, 3 * pi / 2};
    int count = 2;
    const auto add = [&](double x, double y) {
        const double azimuth = std::atan2(x, y);
        ends[count++] = azimuth < -pi / 2 ? azimuth + 2 * pi : azimuth;
    };
    if (cosine < cos_lambda) {
        const double low = cosine / cos_lambda;
        const double y = other_leg(1, low);
        add(low * sin_lambda, y);
        add(low * sin_lambda, -y);
    }
    if (std::abs(wall) < sine) {
        const double x = other_leg(sine, wall);
        add(x, wall);
        add(-x, wall);
    }
    const SignChanges crossings =
        cosine == top_cosine ? below_top : sign_changes(pass, above(*this, cosine));
    for (int k = 0; k < crossings.count; ++k) {
        const Vec3 crossing = point(BorderKind::PreviousBall, crossings.at[k]);
        add(crossing.x(), crossing.y());
    }
    std::sort(ends.begin(), ends.begin() + count);
    std::vector<AzimuthRange> ranges;
    for (int k = 0; k + 1 < count; ++k) {
        const double middle = (ends[k] + ends[k + 1]) / 2;
        if (ends[k] == ends[k + 1] ||
            !has({sine * std::sin(middle), sine * std::cos(middle), -cosine}))
            continue;
        if (!ranges.empty() && ranges.back().to == ends[k])
            ranges.back().to = ends[k + 1];
        else
            ranges.push_back({ends[k], ends[k + 1]});
    }
    return ranges;
}

std::vector<BorderArc> EngagedRegion::borders(BorderSplit split) const
{
    constexpr int usual_arcs = 8;
    std::vector<BorderArc> arcs;
    arcs.reserve(usual_arcs);
    add_front(*this, arcs);
    add_previous_ball(*this, split, arcs);
    add_wall(*this, split, arcs);
    return arcs;
}

bool is_engaged(const BallEngagement& engagement, double latitude, double azimuth)
{
    if (is_air(engagement))
        return false;
    const EngagedRegion region{engagement};
    const double sine = std::sin(latitude);
    const double cosine = std::cos(latitude);
    return cosine >= region.top_cosine &&
           region.has({sine * std::sin(azimuth), sine * std::cos(azimuth), -cosine});
}

std::vector<AzimuthRange> engaged_ranges(const BallEngagement& engagement,
                                         double latitude)
{
    require_sound(engagement);
    require(latitude > 0 && latitude <= pi / 2,
            "engaged_ranges: need a latitude above 0, at most a right angle");
    if (is_air(engagement))
        return {};
    const EngagedRegion region{engagement};
    const double cosine = std::cos(latitude);
    if (cosine < region.top_cosine)
        return {};
    return region.ranges_at(std::sin(latitude), cosine);
}

}  // namespace endmill
