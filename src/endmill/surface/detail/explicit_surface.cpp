// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/explicit_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/nurbs.h"

namespace endmill {
namespace {

std::vector<double> nodes(const Interval& range, int intervals)
{
    std::vector<double> nodes;
    nodes.reserve(static_cast<std::size_t>(intervals) + 1);
    for (int i = 0; i <= intervals; ++i)
        nodes.push_back(range.low + range.length() * i / intervals);
    return nodes;
}

// A function of x alone, with its derivatives.
struct Profile {
    double value;
    double first;
    double second;
};

// b of the saddle: distance from the ridge at which the flanks begin.
Profile half_width(double x)
{
    const double s = (x / 90 + 1) / 2;
    const double rate = 1.0 / 180;  // ds / dx
    return {8 + 10 * s * s * (3 - 2 * s), 10 * 6 * s * (1 - s) * rate,
            10 * (6 - 12 * s) * rate * rate};
}

// Ratio of the area of the surface to that of its projection onto the xy plane.
double stretch(const HeightJet& jet)
{
    return std::sqrt(1 + jet.zx * jet.zx + jet.zy * jet.zy);
}

// Smallest radius of principal curvature.
double least_radius(const HeightJet& jet)
{
    const Vec3 du{1, 0, jet.zx};
    const Vec3 dv{0, 1, jet.zy};
    const SurfaceJet surface{.point = {0, 0, jet.z},
                             .du = du,
                             .dv = dv,
                             .duu = {0, 0, jet.zxx},
                             .duv = {0, 0, jet.zxy},
                             .dvv = {0, 0, jet.zyy}};
    const auto [least, greatest] =
        principal_curvatures(fundamental_forms(surface, du.cross(dv).normalized()));
    return 1 / std::max(std::abs(least), std::abs(greatest));
}

}  // namespace

HeightJet ball_end_test_surface(double x, double y)
{
    constexpr double unit = 40;  // mm
    const double a = x / unit;
    const double b = y / unit;
    // g = p / q; the quotient rule gives each partial derivative from those of lower
    // order.
    const double p = a * b * (a * a - b * b);
    const double q = a * a + b * b + 0.25;
    const double g = p / q;
    const double ga = (3 * a * a * b - b * b * b - 2 * a * g) / q;
    const double gb = (a * a * a - 3 * a * b * b - 2 * b * g) / q;
    const double gaa = (6 * a * b - 4 * a * ga - 2 * g) / q;
    const double gbb = (-6 * a * b - 4 * b * gb - 2 * g) / q;
    const double gab = (3 * a * a - 3 * b * b - 2 * a * gb - 2 * b * ga) / q;
    return {unit * g, ga, gb, gaa / unit, gab / unit, gbb / unit};
}

HeightJet bicycle_saddle(double x, double y)
{
    constexpr double sag = 10.0 / (90 * 90);  // 1/mm
    constexpr double steepness = 3;           // limit slope of the flanks
    const auto [b, b1, b2] = half_width(x);
    const double q = std::hypot(b, y);
    const double qx = b * b1 / q;
    const double qy = y / q;
    const double qxx = (b1 * b1 + b * b2 - qx * qx) / q;
    const double qxy = -qx * qy / q;
    const double qyy = (1 - qy * qy) / q;
    return {sag * x * x - steepness * (q - b),
            2 * sag * x - steepness * (qx - b1),
            -steepness * qy,
            2 * sag - steepness * (qxx - b2),
            -steepness * qxy,
            -steepness * qyy};
}

ExplicitSurface explicit_surface(Surface grid)
{
    return [grid = std::move(grid)](double x, double y) {
        const SurfaceJet jet = grid.jet(x, y);
        return HeightJet{jet.point.z(), jet.du.z(),  jet.dv.z(),
                         jet.duu.z(),   jet.duv.z(), jet.dvv.z()};
    };
}

Surface gridded(const ExplicitSurface& surface, const XyRectangle& extent,
                int intervals_x, int intervals_y)
{
    require(intervals_x > 0 && intervals_y > 0, "gridded: need at least one cell");
    const std::vector<double> x = nodes(extent.x, intervals_x);
    const std::vector<double> y = nodes(extent.y, intervals_y);
    std::vector<double> z;
    for (const double at_y : y)
        for (const double at_x : x)
            z.push_back(surface(at_x, at_y).z);
    return height_grid(x, y, z);
}

double farthest_apart(const ExplicitSurface& one, const ExplicitSurface& other,
                      const XyRectangle& extent, int steps)
{
    double farthest = 0;
    for (const double x : nodes(extent.x, steps))
        for (const double y : nodes(extent.y, steps))
            farthest = std::max(farthest, std::abs(one(x, y).z - other(x, y).z));
    return farthest;
}

SurfaceFacts surface_facts(const ExplicitSurface& surface, const XyRectangle& extent,
                           double level_mm, int steps)
{
    SurfaceFacts facts{.least_z_mm = std::numeric_limits<double>::infinity(),
                       .greatest_z_mm = -std::numeric_limits<double>::infinity(),
                       .area_mm2 = 0,
                       .steepest_deg = 0,
                       .least_radius_mm = std::numeric_limits<double>::infinity(),
                       .share_above = 0};
    const double half_x = extent.x.length() / steps / 2;
    const double half_y = extent.y.length() / steps / 2;
    std::size_t above = 0;
    const std::vector<double> all_x = nodes(extent.x, steps);
    const std::vector<double> all_y = nodes(extent.y, steps);
    for (const double x : all_x)
        for (const double y : all_y) {
            const HeightJet jet = surface(x, y);
            facts.least_z_mm = std::min(facts.least_z_mm, jet.z);
            facts.greatest_z_mm = std::max(facts.greatest_z_mm, jet.z);
            facts.steepest_deg =
                std::max(facts.steepest_deg,
                         Angle::radians(std::acos(1 / stretch(jet))).degrees());
            facts.least_radius_mm = std::min(facts.least_radius_mm, least_radius(jet));
            if (x == extent.x.high || y == extent.y.high)
                continue;
            const HeightJet middle = surface(x + half_x, y + half_y);
            facts.area_mm2 += 4 * half_x * half_y * stretch(middle);
            above += middle.z > level_mm ? 1 : 0;
        }
    facts.share_above = static_cast<double>(above) / (static_cast<double>(steps) * steps);
    return facts;
}

}  // namespace endmill
