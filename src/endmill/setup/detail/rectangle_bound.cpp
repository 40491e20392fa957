// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_bound.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numbers>

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Lower limit of z. It keeps s / z finite at z = 0, where alpha is +-90 degrees.
constexpr double least_height = 1e-200;

// Directions with a smaller z are split points. Their alpha passes so quickly through 0
// where R1 has their azimuth that even the narrowest interval would miss the certified
// accuracy.
constexpr double steep_height = 1e-3;

void add_sides(double& plus, double& minus, double value)
{
    plus = std::max(plus, value);
    minus = std::max(minus, -value);
}

double arc_sine(double sine)
{
    return std::asin(std::min(sine, 1.0));
}

}  // namespace

bool RectangleNeeds::HighPoint::is_along_r1(double across) const
{
    return inverse_z * equal_angles >= 1 &&
           std::hypot(across, 1 / inverse_z) <= equal_angles;
}

bool RectangleNeeds::LowPoint::is_along_r1(double across) const
{
    return depth <= equal_angles && std::hypot(across, depth) <= equal_angles;
}

// The largest extents to either side, as tangents and sines. Low points have |alpha| > 90
// degrees; the smaller |s| / depth, the larger |alpha|.
struct RectangleNeeds::Extents {
    double tangent_plus = 0;
    double tangent_minus = 0;
    double ratio_plus = infinity;
    double ratio_minus = infinity;
    double sine_plus = 0;
    double sine_minus = 0;
};

// Values of a function at both ends of an interval.
struct RectangleNeeds::Ends {
    double left;
    double right;
};

// The tangent or sine, of all directions to one side, whose smaller end value is the
// largest. All values are 0 if no direction stays on that side over the interval.
struct RectangleNeeds::Support {
    double least = 0;
    double left = 0;
    double right = 0;

    void offer(double at_left, double at_right)
    {
        const double lesser = std::min(at_left, at_right);
        if (lesser > least)
            *this = {lesser, at_left, at_right};
    }
};

// The low point, of those to one side, whose largest |s| / depth over the interval is the
// least.
struct RectangleNeeds::LowSupport {
    double ratio = infinity;
    const LowPoint* point = nullptr;
};

// Lower bounds of the extents over an interval, with the directions that give them.
struct RectangleNeeds::Supports {
    Support tangent_plus{};
    Support tangent_minus{};
    Support sine_plus{};
    Support sine_minus{};
    LowSupport low_plus{};
    LowSupport low_minus{};
};

RectangleNeeds::RectangleNeeds(const PolePoints& points)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = points.x[i];
        const double y = points.y[i];
        const double z = points.z[i];
        const double azimuth = points.azimuth(i);
        const double half_turn = azimuth < 0 ? azimuth + pi : azimuth;
        if (z >= 0) {
            high_.push_back({x, y, 1 / std::max(z, least_height)});
            if (z < steep_height)
                splits_.push_back(half_turn);
            continue;
        }
        const double rho = std::hypot(x, y);
        if (rho < equal_angles) {
            has_opposite_ = true;
            continue;
        }
        low_.push_back({x, y, rho, -z});
        splits_.push_back(half_turn);
    }
}

RectangleExtents RectangleNeeds::ranges(const Extents& extents)
{
    const auto alpha = [](double ratio, double tangent) {
        return ratio < infinity ? pi - std::atan(ratio) : std::atan(tangent);
    };
    return {{0 - alpha(extents.ratio_minus, extents.tangent_minus),
             alpha(extents.ratio_plus, extents.tangent_plus)},
            {0 - arc_sine(extents.sine_minus), arc_sine(extents.sine_plus)}};
}

RectangleExtents RectangleNeeds::at(const R1Azimuth& azimuth,
                                    const R1Azimuth& beside) const
{
    Extents extents;
    for (const HighPoint& p : high_) {
        const double s = azimuth.across(p.x, p.y);
        if (!p.is_along_r1(s))
            add_sides(extents.tangent_plus, extents.tangent_minus, s * p.inverse_z);
        add_sides(extents.sine_plus, extents.sine_minus, azimuth.along(p.x, p.y));
    }
    for (const LowPoint& p : low_) {
        add_sides(extents.sine_plus, extents.sine_minus, azimuth.along(p.x, p.y));
        const double s = azimuth.across(p.x, p.y);
        if (p.is_along_r1(s))
            continue;
        const bool is_plus = beside.across(p.x, p.y) > 0;
        double& ratio = is_plus ? extents.ratio_plus : extents.ratio_minus;
        ratio = std::min(ratio, std::max(is_plus ? s : -s, 0.0) / p.depth);
    }
    return ranges(extents);
}

RectangleNeeds::Supports RectangleNeeds::supports(const R1Azimuth& left,
                                                  const R1Azimuth& right,
                                                  const R1Azimuth& middle) const
{
    Supports found;
    for (const HighPoint& p : high_) {
        const double at_left = left.across(p.x, p.y) * p.inverse_z;
        const double at_right = right.across(p.x, p.y) * p.inverse_z;
        found.tangent_plus.offer(at_left, at_right);
        found.tangent_minus.offer(-at_left, -at_right);
        const double left_sine = left.along(p.x, p.y);
        const double right_sine = right.along(p.x, p.y);
        found.sine_plus.offer(left_sine, right_sine);
        found.sine_minus.offer(-left_sine, -right_sine);
    }
    for (const LowPoint& p : low_) {
        const double left_sine = left.along(p.x, p.y);
        const double right_sine = right.along(p.x, p.y);
        found.sine_plus.offer(left_sine, right_sine);
        found.sine_minus.offer(-left_sine, -right_sine);
        // |s| has its maximum rho where sin beta changes its sign.
        const bool has_peak = (left_sine > 0) != (right_sine > 0);
        const double most = has_peak ? p.rho
                                     : std::max(std::abs(left.across(p.x, p.y)),
                                                std::abs(right.across(p.x, p.y)));
        LowSupport& side = middle.across(p.x, p.y) > 0 ? found.low_plus : found.low_minus;
        if (most / p.depth < side.ratio)
            side = {most / p.depth, &p};
    }
    return found;
}

// Lower bounds of the area, rad^2, from one direction for each extent. The sums of both
// alphas and of both betas are at least linear between the ends of the interval: alpha
// and beta of a high direction are concave; |alpha| of a low direction is convex and is
// replaced by its tangent in the middle. The product of two such sums is least at an end.
std::array<double, 2> RectangleNeeds::areas_between(const Supports& supports,
                                                    const R1Azimuth& middle,
                                                    double half_width) const
{
    const auto alpha_ends = [&](const Support& high, const LowPoint* low) -> Ends {
        if (low == nullptr)
            return {std::atan(high.left), std::atan(high.right)};
        const double s = middle.across(low->x, low->y);
        const double ratio = std::abs(s) / low->depth;
        const double growth =
            (s > 0 ? 1 : -1) * middle.along(low->x, low->y) / low->depth;
        const double change = growth / (1 + ratio * ratio) * half_width;
        const double alpha = pi - std::atan(ratio);
        return {alpha + change, alpha - change};
    };
    const Ends plus = alpha_ends(supports.tangent_plus, supports.low_plus.point);
    const Ends minus = alpha_ends(supports.tangent_minus, supports.low_minus.point);
    const auto betas = [&](double Support::*end) {
        return arc_sine(supports.sine_plus.*end) + arc_sine(supports.sine_minus.*end);
    };
    const auto area = [&](const Ends& alpha) {
        if (alpha.left < 0 || alpha.right < 0)
            return 0.0;
        return std::min(alpha.left * betas(&Support::left),
                        alpha.right * betas(&Support::right));
    };
    if (has_opposite_)
        return {area({pi + minus.left, pi + minus.right}),
                area({pi + plus.left, pi + plus.right})};
    const double both = area({plus.left + minus.left, plus.right + minus.right});
    return {both, both};
}

RectangleBound RectangleNeeds::over(const R1Azimuth& left, const R1Azimuth& right) const
{
    const R1Azimuth middle{(left.angle + right.angle) / 2};
    const Supports found = supports(left, right, middle);
    const RectangleExtents least =
        ranges({found.tangent_plus.least, found.tangent_minus.least, found.low_plus.ratio,
                found.low_minus.ratio, found.sine_plus.least, found.sine_minus.least});
    const double half_width = (right.angle - left.angle) / 2;
    const std::array<double, 2> between = areas_between(found, middle, half_width);
    RectangleBound bound{least, {}};
    for (std::size_t side = 0; side < 2; ++side) {
        RectangleExtents whole = least;
        if (has_opposite_)
            (side == 0 ? whole.alpha.to : whole.alpha.from) = side == 0 ? pi : -pi;
        bound.areas.at(side) = std::max(whole.area(), between.at(side));
    }
    return bound;
}

}  // namespace endmill
