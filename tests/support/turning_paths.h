// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/nurbs.h"
#include "endmill/surface/part.h"
#include "revolved_surfaces.h"

// Paths with a turning axis over parts whose deviation has a closed form.
namespace endmill::test {

/// The location of a cutter that touches a part: the axis leans from the normal by a lead,
/// forward along the feed.
/// \param feed unit, in the tangent plane. \param lead rad.
inline CutterLocation leaning(const Cutter& cutter, const CutterContact& contact,
                              const Vec3& feed, double lead)
{
    const Vec3 axis =
        (std::cos(lead) * contact.normal + std::sin(lead) * feed).normalized();
    return {control_point(cutter, contact, ControlPoint::Tip, axis), axis};
}

/// Adds a point to a path.
inline void add(ToolPath& path, Move move, const CutterLocation& location)
{
    path.points.push_back({.pass = 0,
                           .point = static_cast<int>(path.points.size()),
                           .move = move,
                           .location = location});
}

/// A zone of the sphere of this radius around the origin, above the xy plane.
/// \param polar rad from +z, both ends.
inline Part dome(double radius, Interval polar, double wide = 1)
{
    const double half_turn = std::numbers::pi / 2;
    return std::vector<Surface>{nurbs_surface(
        torus(0, radius, {0, wide, half_turn - polar.high, half_turn - polar.low, 1}))};
}

/// Rings around the z axis on a sphere around the origin, with a constant lead along them.
/// The tool is lifted along its axis between the rings.
struct DomeRings {
    double radius;        ///< of the sphere, mm
    double step;          ///< rad, polar angle between the rings
    Interval polar;       ///< rad, of the first and the last ring
    Interval azimuth;     ///< rad
    double lead = 0;      ///< rad
    double turn = 0.005;  ///< rad, azimuth between two points
    bool is_hollow =
        false;  ///< whether the tool is inside the sphere, below the xy plane
};

/// The path over a dome, or through a bowl.
inline ToolPath dome_rings(const Cutter& cutter, const DomeRings& rings)
{
    ToolPath path;
    const int count = static_cast<int>(std::lround(rings.polar.length() / rings.step));
    const int turns = static_cast<int>(std::lround(rings.azimuth.length() / rings.turn));
    const double side = rings.is_hollow ? -1 : 1;
    for (int i = 0; i <= count; ++i) {
        const double polar = rings.polar.low + i * rings.step;
        for (int k = 0; k <= turns; ++k) {
            const double a = rings.azimuth.low + k * rings.azimuth.length() / turns;
            const Vec3 out{std::sin(polar) * std::cos(a), std::sin(polar) * std::sin(a),
                           side * std::cos(polar)};
            const Vec3 feed{-std::sin(a), std::cos(a), 0};
            const CutterLocation here =
                leaning(cutter, {rings.radius * out, side * out}, feed, rings.lead);
            if (k == 0)
                add(path, i == 0 ? Move::Rapid : Move::Link,
                    {here.tip + 20 * here.axis, here.axis});
            add(path, Move::Cut, here);
            if (k == turns)
                add(path, Move::Retract, {here.tip + 20 * here.axis, here.axis});
        }
    }
    return path;
}

/// Passes along x over the plane z = 0 from x = 0 to `length`, `apart` mm apart around y =
/// 0, with a lead that changes evenly along each pass.
struct PlanePasses {
    double length = 20;  ///< mm
    double apart = 2;    ///< mm
    int count = 7;       ///< odd, so that one pass is at y = 0
    Interval lead = {0.2, 0.2};
    int points = 41;    ///< of a pass
    double sunk = 0;    ///< mm, by which the middle point of the middle pass is too low
    int left_out = -1;  ///< number of a pass that is not cut
};

/// The path over the plane.
inline ToolPath plane_passes(const Cutter& cutter, const PlanePasses& passes)
{
    ToolPath path;
    for (int i = 0; i < passes.count; ++i) {
        if (i == passes.left_out)
            continue;
        for (int k = 0; k < passes.points; ++k) {
            const double share = k / (passes.points - 1.0);
            const double y = (i - passes.count / 2) * passes.apart;
            CutterLocation here =
                leaning(cutter, {{share * passes.length, y, 0}, {0, 0, 1}}, {1, 0, 0},
                        passes.lead.low + share * passes.lead.length());
            if (i == passes.count / 2 && k == passes.points / 2)
                here.tip.z() -= passes.sunk;
            if (k == 0)
                add(path, path.points.empty() ? Move::Rapid : Move::Link,
                    {here.tip + Vec3{0, 0, 20}, here.axis});
            add(path, Move::Cut, here);
            if (k == passes.points - 1)
                add(path, Move::Retract, {here.tip + Vec3{0, 0, 20}, here.axis});
        }
    }
    return path;
}

}  // namespace endmill::test
