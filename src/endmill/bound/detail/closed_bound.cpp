// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/closed_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using std::numbers::pi;

// Steps of the trapezoidal rule for the area of the disc on a cylinder. The integrand is
// periodic and analytic; the error is below rounding already at 48.
constexpr int area_steps = 128;

// The disc that a ball covers on a sphere or, across the axis, on a cylinder. rho is the
// radius, sigma the sign of the curvature.
struct RoundDisc {
    double radius;      // rho, mm
    double raised;      // rho + sigma h, of the raised surface, mm
    double centres;     // rho + sigma R, of the centres of balls, mm
    double half_angle;  // alpha, rad
};

// By the law of cosines (R + gamma)^2 = (R - h)^2 + 4 (rho + sigma h)(rho + sigma R)
// sin^2(alpha / 2), without cancellation for small alpha. Up to a quarter of a turn the
// disc is convex.
std::optional<RoundDisc> round_disc(const BoundProblem& problem, double curvature)
{
    require_valid(problem);
    require(std::isfinite(curvature) && curvature != 0,
            "round_disc: need a curvature that is finite and not zero");
    const double rho = 1 / std::abs(curvature);
    const double sigma = curvature > 0 ? 1 : -1;
    const double raised = rho + sigma * problem.scallop_height;
    const double centres = rho + sigma * problem.cutter.radius();
    if (centres <= 0)
        return std::nullopt;
    const double sine = plane_half_width(problem) / (2 * std::sqrt(raised * centres));
    if (sine > std::numbers::sqrt2 / 2)
        return std::nullopt;
    return RoundDisc{rho, raised, centres, 2 * std::asin(sine)};
}

// By how much tips that stray may be shorter: 1 - gamma |k / (1 + k R)|.
double stray_factor(const BoundProblem& problem, const RoundDisc& disc)
{
    return problem.length == BoundedLength::Tip ? 1 - problem.stray / disc.centres : 1;
}

// The area of the disc on the developed cylinder, with s = b sin t.
double cylinder_disc_area(const RoundDisc& disc)
{
    const double b = disc.radius * disc.half_angle;
    const double sine = std::sin(disc.half_angle / 2);
    double sum = 0;
    for (int k = 0; k < area_steps; ++k) {
        const double t = -pi / 2 + pi * (k + 0.5) / area_steps;
        const double inner = std::sin(disc.half_angle * std::sin(t) / 2);
        const double half =
            2 * std::sqrt(disc.raised * disc.centres * (sine - inner) * (sine + inner));
        sum += 2 * half * b * std::cos(t);
    }
    return sum * pi / area_steps;
}

// The area between a chord at `distance` from the centre of a circle and the arc beyond.
double segment_area(double radius, double distance)
{
    return radius * radius * std::acos(distance / radius) -
           distance * std::sqrt(radius * radius - distance * distance);
}

}  // namespace

// The covered set on a plane is the disc of radius a below the height of the centre. Above
// it is an ellipse: there the horizontal distance (R - h) sin + t cos of a point t mm
// uphill from the axis of the tool, and its distance s across, satisfy the circle of
// radius R + gamma.
ClosedDensity plane_density(const BoundProblem& problem, const Angle& slope)
{
    require_valid(problem);
    const double a = plane_half_width(problem);
    const double sine = std::sin(slope.radians());
    const double cosine = std::cos(slope.radians());
    const double reach = problem.cutter.radius() + problem.stray;
    const double level = problem.cutter.radius() - problem.scallop_height;
    if (problem.tool == CoveringTool::Ball || level >= reach * sine)
        return {1 / (2 * a), pi * a / 2};
    require(cosine > 0, "plane_density: need a slope below 90 degrees");
    const double uphill = (reach - level * sine) / cosine;
    const double area = pi * a * a - segment_area(a, level * cosine / sine) +
                        segment_area(reach, level / sine) / cosine;
    const double width = a + uphill;
    return {1 / width, area / width};
}

std::optional<ClosedDensity> sphere_density(const BoundProblem& problem, double curvature)
{
    const auto disc = round_disc(problem, curvature);
    if (!disc)
        return std::nullopt;
    const double alpha = disc->half_angle;
    double density = 1 / (2 * disc->radius * std::sin(alpha));
    if (problem.length == BoundedLength::Tip)
        density *= disc->centres / disc->radius;
    density *= stray_factor(problem, *disc);
    const double area =
        4 * pi * disc->radius * disc->radius * std::pow(std::sin(alpha / 2), 2);
    return ClosedDensity{density, density * area};
}

// The disc moves rigidly on the developed cylinder. The sum of the squares of its half
// chords along s and, times the square of the ratio of the speeds of contact and tip,
// across, is largest at one of both axes.
std::optional<ClosedDensity> cylinder_density(const BoundProblem& problem,
                                              double curvature)
{
    const auto disc = round_disc(problem, curvature);
    if (!disc)
        return std::nullopt;
    const double a = plane_half_width(problem);
    const double b = disc->radius * disc->half_angle;
    const double ratio =
        problem.length == BoundedLength::Tip ? disc->radius / disc->centres : 1;
    const double density = stray_factor(problem, *disc) / (2 * std::max(ratio * a, b));
    return ClosedDensity{density, density * cylinder_disc_area(*disc)};
}

// The highest raised point within reach is alpha uphill. It is as high as the centre at
// the slope where sigma (rho + sigma h) cos(theta - sigma alpha) = sigma (rho + sigma R)
// cos(theta).
std::optional<Angle> steepest_without_flank(const BoundProblem& problem, double curvature)
{
    const auto disc = round_disc(problem, curvature);
    if (!disc)
        return std::nullopt;
    const double across = disc->raised * std::sin(disc->half_angle);
    const double along = disc->centres - disc->raised * std::cos(disc->half_angle);
    const double sigma = curvature > 0 ? 1 : -1;
    return Angle::radians(std::max(0.0, std::atan2(sigma * along, across)));
}

std::optional<ClosedDensity> closed_density(const BoundProblem& problem,
                                            const SimpleShape& shape)
{
    if (shape.kind == ShapeKind::Plane) {
        if (problem.tool == CoveringTool::BallAndFlank &&
            shape.steepest.radians() >= pi / 2)
            return std::nullopt;
        return plane_density(problem, shape.steepest);
    }
    const auto steepest = steepest_without_flank(problem, shape.curvature);
    if (!steepest || (problem.tool == CoveringTool::BallAndFlank &&
                      shape.steepest.radians() > steepest->radians()))
        return std::nullopt;
    return shape.kind == ShapeKind::Sphere ? sphere_density(problem, shape.curvature)
                                           : cylinder_density(problem, shape.curvature);
}

}  // namespace endmill
