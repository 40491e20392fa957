// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/ball_path_stock.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Height of the cutter's tip relative to the ball's centre.
double tip_height(const Cutter& cutter, ControlPoint equated)
{
    return equated == ControlPoint::Reference ? -cutter.corner_radius()
                                              : -cutter.radius();
}

// Distance of sample `k` of the outline from the axis, from -R to R.
double sample(const Cutter& cutter, int k, int samples)
{
    return cutter.radius() * (2.0 * k / samples - 1);
}

// Largest extent of the cutter's body from the ball's centre against the normal.
double reach(const Cutter& cutter, ControlPoint equated, Angle slope, int samples)
{
    const double sine = std::sin(slope.radians());
    const double cosine = std::cos(slope.radians());
    double farthest = -infinity;
    for (int k = 0; k <= samples; ++k) {
        const double across = sample(cutter, k, samples);
        const double z = tip_height(cutter, equated) + cutter.profile(std::abs(across));
        farthest = std::max(farthest, across * sine - z * cosine);
    }
    return farthest;
}

}  // namespace

double stock_on_plane(const Cutter& cutter, ControlPoint equated, Angle slope,
                      int samples)
{
    const double cosine = std::cos(slope.radians());
    const double tangent = std::sin(slope.radians()) / cosine;
    double lowest = infinity;
    for (int k = 0; k <= samples; ++k) {
        const double across = sample(cutter, k, samples);
        const double centre = across * tangent + cutter.radius() / cosine;
        lowest = std::min(lowest, centre + tip_height(cutter, equated) +
                                      cutter.profile(std::abs(across)));
    }
    return lowest * cosine;
}

double stock_in_valley(const Cutter& cutter, ControlPoint equated, Angle slope,
                       double valley_radius, int samples)
{
    const double path = valley_radius - cutter.radius();
    const double sine = std::sin(slope.radians());
    const double cosine = std::cos(slope.radians());
    double farthest = -infinity;
    for (int k = 0; k <= samples; ++k) {
        const double at = Angle::degrees(180.0 * k / samples - 90).radians();
        farthest =
            std::max(farthest, path * (std::sin(at) * sine + std::cos(at) * cosine));
    }
    return valley_radius - farthest - reach(cutter, equated, slope, samples);
}

}  // namespace endmill
