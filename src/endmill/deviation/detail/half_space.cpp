// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/half_space.h"

#include <algorithm>
#include <cmath>

// A cutter is a level disc of the flat radius c, thickened by the corner radius r, and
// open above. All that it clears from reference points y lies in the half space w . z >=
// min(w . y) - c |w_xy| - r for any unit vector w with w_z >= 0. The functions choose w.
// Source: paper/notes/deviation-bounds.md, eq. (f).

namespace endmill {
namespace {

// Length in mm by which a half space may lie closer than necessary before another
// direction is tried.
constexpr double small_loss = 1e-9;

// Returns the half space with this normal, whose z is not negative, for reference points
// at `at` and above.
HalfSpace supported(const Cutter& cutter, const Vec3& normal, const Vec3& at)
{
    const double flat = cutter.flat_radius();
    const double beside = flat > 0 ? flat * normal.head<2>().norm() : 0;
    return {normal, normal.dot(at) - beside - cutter.corner_radius()};
}

// Returns the distance of `place` from the half space; negative inside.
double gap(const HalfSpace& half, const Vec3& place)
{
    return half.least - half.normal.dot(place);
}

}  // namespace

HalfSpace half_space(const Cutter& cutter, const Vec3& place, const Vec3& nearest)
{
    Vec3 way = nearest - place;
    const double flat = cutter.flat_radius();
    if (flat > 0)
        if (const double distance = way.head<2>().norm(); distance > 0)
            way.head<2>() *= std::max(0.0, 1 - flat / distance);
    way.z() = std::max(way.z(), 0.0);  // the swept volume is open above
    const double length = way.norm();
    if (length > 0)
        return supported(cutter, way / length, nearest);
    const double distance = (nearest - place).head<2>().norm();
    // The place lies in the disc or below its rim. The shorter way out leads through the
    // bottom or the side.
    HalfSpace below = supported(cutter, Vec3::UnitZ(), nearest);
    if (!(distance > 0))
        return below;
    Vec3 inwards = nearest - place;
    inwards.z() = 0;
    HalfSpace beside = supported(cutter, inwards / distance, nearest);
    return gap(below, place) >= gap(beside, place) ? below : beside;
}

Vec3 nearest_reference(const StraightSweep& sweep, const Vec3& place)
{
    const Vec3 from = sweep.from() + Vec3{0, 0, sweep.cutter().corner_radius()};
    const Vec3 move = sweep.to() - sweep.from();
    const double length2 = move.squaredNorm();
    const double share =
        length2 > 0 ? std::clamp(move.dot(place - from) / length2, 0.0, 1.0) : 0;
    Vec3 nearest = from + share * move;
    const double level2 = move.head<2>().squaredNorm();
    if (nearest.z() >= place.z() || !(level2 > 0))
        return nearest;
    // The segment above its reference points is nearest: use the nearest point in plan.
    const double in_plan = move.head<2>().dot((place - from).head<2>()) / level2;
    return from + std::clamp(in_plan, 0.0, 1.0) * move;
}

HalfSpace half_space_beyond(const StraightSweep& sweep, const Vec3& place)
{
    const Vec3 nearest = nearest_reference(sweep, place);
    HalfSpace found = half_space(sweep.cutter(), place, nearest);
    // The direction to the nearest point need not be perpendicular to the move: not above
    // a flat bottom, nor beyond an end. The far end of the move then limits the half
    // space.
    const Vec3 lift{0, 0, sweep.cutter().corner_radius()};
    const double lost =
        found.normal.dot(nearest - lift) -
        std::min(found.normal.dot(sweep.from()), found.normal.dot(sweep.to()));
    found.least -= lost;
    if (lost <= small_loss)
        return found;
    const Vec3 move = sweep.to() - sweep.from();
    const Vec3 square = found.normal - found.normal.dot(move) / move.squaredNorm() * move;
    const double size = square.norm();
    if (!(square.z() >= 0 && size > 0))
        return found;
    const HalfSpace along = supported(sweep.cutter(), square / size, nearest);
    return gap(along, place) > gap(found, place) ? along : found;
}

}  // namespace endmill
