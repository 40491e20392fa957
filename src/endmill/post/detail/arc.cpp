// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace endmill {
namespace {

using std::numbers::pi;

// Ends of an arc closer than this, in mm, coincide. The last digits of a program are much
// coarser, and the rounding of a million sums of numbers up to 1e3 mm is smaller.
constexpr double same_point_mm = 1e-8;

// Components along the two axes of the plane of an arc.
struct InPlane {
    double first;
    double second;
};

// The vector from `from` to `to`, projected on the plane.
InPlane difference(const Vec3& from, const Vec3& to, const PlaneAxes& axes)
{
    return {to[axes.first] - from[axes.first], to[axes.second] - from[axes.second]};
}

double length(const InPlane& vector)
{
    return std::hypot(vector.first, vector.second);
}

double direction(const InPlane& vector)
{
    return std::atan2(vector.second, vector.first);
}

}  // namespace

PlaneAxes plane_axes(ArcPlane plane)
{
    switch (plane) {
        case ArcPlane::Zx:
            return {2, 0, 1};
        case ArcPlane::Yz:
            return {1, 2, 0};
        case ArcPlane::Xy:
            break;
    }
    return {0, 1, 2};
}

ArcRadii arc_radii(const Arc& arc)
{
    const PlaneAxes axes = plane_axes(arc.plane);
    return {length(difference(arc.centre, arc.start, axes)),
            length(difference(arc.centre, arc.end, axes))};
}

double arc_angle(const Arc& arc)
{
    const PlaneAxes axes = plane_axes(arc.plane);
    const double further_turns = 2 * pi * (arc.turns - 1);
    if (length(difference(arc.start, arc.end, axes)) <= same_point_mm)
        return 2 * pi + further_turns;
    const double counterclockwise = direction(difference(arc.centre, arc.end, axes)) -
                                    direction(difference(arc.centre, arc.start, axes));
    const double angle = arc.clockwise ? -counterclockwise : counterclockwise;
    return (angle > 0 ? angle : angle + 2 * pi) + further_turns;
}

std::optional<Vec3> centre_of_radius(const Arc& arc, double radius, double tolerance_mm)
{
    const PlaneAxes axes = plane_axes(arc.plane);
    const InPlane chord = difference(arc.start, arc.end, axes);
    const double half_chord = length(chord) / 2;
    const double size = std::abs(radius);
    if (half_chord - size > tolerance_mm)
        return std::nullopt;
    // The centre of a counterclockwise arc below half a turn lies to the left of its
    // chord. A clockwise arc, or an arc of more than half a turn, has it on the right;
    // both together put it on the left again.
    const double left = arc.clockwise == (radius < 0) ? 1 : -1;
    const double height =
        std::sqrt(std::max(0.0, (size - half_chord) * (size + half_chord)));
    const double along = left * height / (2 * half_chord);
    Vec3 centre = (arc.start + arc.end) / 2;
    centre[axes.first] -= along * chord.second;
    centre[axes.second] += along * chord.first;
    return centre;
}

ArcChords::ArcChords(const Arc& arc, double tolerance_mm)
    : arc_{arc},
      radii_{arc_radii(arc)}
{
    const PlaneAxes axes = plane_axes(arc.plane);
    start_angle_ = direction(difference(arc.centre, arc.start, axes));
    const double angle = arc_angle(arc);
    angle_ = arc.clockwise ? -angle : angle;
    // acos(1 - q) = 2 asin(sqrt(q / 2)) is accurate also for small q.
    const double sagitta = std::min(1.0, tolerance_mm / radii_.larger());
    const double step = 4 * std::asin(std::sqrt(sagitta / 2));
    count_ = std::max(1.0, std::ceil(angle / step));
}

Vec3 ArcChords::end(std::size_t number) const
{
    if (static_cast<double>(number) >= count_)
        return arc_.end;
    const PlaneAxes axes = plane_axes(arc_.plane);
    const double part = static_cast<double>(number) / count_;
    const double radius = radii_.start + part * (radii_.end - radii_.start);
    const double angle = start_angle_ + part * angle_;
    Vec3 point;
    point[axes.first] = arc_.centre[axes.first] + radius * std::cos(angle);
    point[axes.second] = arc_.centre[axes.second] + radius * std::sin(angle);
    point[axes.normal] = arc_.start[axes.normal] +
                         part * (arc_.end[axes.normal] - arc_.start[axes.normal]);
    return point;
}

}  // namespace endmill
