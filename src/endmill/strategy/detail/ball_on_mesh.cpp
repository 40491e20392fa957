// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/ball_on_mesh.h"

#include <algorithm>
#include <optional>

#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"
#include "endmill/drop_cutter/clearance.h"

namespace endmill {
namespace {

// Shares of the tolerance: by how much a contact may enter a smooth mesh, so that the rest
// is left for the chords of moves; by how much the core is smaller than the ball; and what
// the test of the core adds.
constexpr double seat_share = 0.5;
constexpr double core_share = 0.9;
constexpr double core_tolerance_share = 0.05;
// Share of the tolerance that the ball keeps from a mesh with sharp edges. Half of it is
// left for the chords of moves.
constexpr double distance_share = 0.25;
// A ball this far from the mesh, in mm, touches it.
constexpr double touching = 1e-7;
// Least z of the normal of a contact: on a vertical wall the ball touches this much, as a
// share of its radius, below its equator.
constexpr double least_normal_z = 1e-6;
// Moves of the ball away from facets that it enters.
constexpr int most_pushes = 12;

// The contact of a ball with this centre in the direction of the normal, kept below the
// equator.
CutterContact below_equator(const Vec3& centre, Vec3 normal, double radius)
{
    if (normal.z() < least_normal_z) {
        normal.z() = 0;
        normal = normal.norm() > 0 ? normal.normalized() : Vec3::UnitX();
        normal.z() = least_normal_z;
        normal.normalize();
    }
    return {centre - radius * normal, normal};
}

}  // namespace

BallOnMesh::BallOnMesh(const TriangleMesh& mesh, const BallCutter& cutter,
                       double tolerance, MeshEdges edges)
    : cutter_{cutter},
      tolerance_{tolerance},
      distance_{edges == MeshEdges::Sharp ? distance_share * tolerance : 0},
      entered_{cutter.radius() +
               (edges == MeshEdges::Sharp ? distance_ / 2 : -seat_share * tolerance)},
      tree_{mesh},
      drop_{mesh, Cutter::ball(cutter.radius())},
      core_{mesh, Cutter::ball(cutter.radius() + (edges == MeshEdges::Sharp
                                                      ? core_tolerance_share * tolerance
                                                      : -core_share * tolerance))}
{
}

Vec3 BallOnMesh::nearest(const Vec3& place) const
{
    return tree_.nearest(place)->point;
}

// Whether the first facet above a place is seen from below.
bool BallOnMesh::is_inside(const Vec3& place) const
{
    const auto hit = tree_.first_hit({place, Vec3::UnitZ()});
    if (!hit)
        return false;
    const auto [a, b, c] = drop_.mesh().corners(hit->triangle);
    return (b - a).cross(c - a).z() > 0;
}

// The centre moved until the ball touches the mesh.
Vec3 BallOnMesh::pushed_out(Vec3 centre, const Vec3& normal) const
{
    const double radius = cutter_.radius() + distance_;
    for (int push = 0; push < most_pushes; ++push) {
        const NearestPoint at = *tree_.nearest(centre);
        const bool is_inner = is_inside(centre);
        if (!is_inner && std::abs(at.distance - radius) <= touching)
            break;
        // later pushes only lead out
        if (!is_inner && push > 0 && at.distance > radius)
            break;
        const Vec3 away = is_inner ? Vec3{at.point - centre} : Vec3{centre - at.point};
        centre =
            at.point + radius * (at.distance > touching ? away.normalized() : normal);
    }
    return centre;
}

CutterContact BallOnMesh::seated(const CutterContact& wanted) const
{
    const double radius = cutter_.radius();
    const Vec3 ideal = wanted.point + (radius + distance_) * wanted.normal;
    if (!tree_.nearest(ideal, {}, entered_))
        return below_equator(ideal, wanted.normal, radius);
    Vec3 centre = pushed_out(ideal, wanted.normal);
    const double core_radius = core_.cutter().radius();
    if (const auto found = core_.contact(centre.head<2>());
        found && found->tip_z > centre.z() - core_radius)
        centre.z() = found->tip_z + core_radius;
    // the shank may keep the ball off the mesh; the contact is then below the mesh
    const Vec3 away = centre - nearest(centre);
    return below_equator(
        centre, away.norm() > touching ? away.normalized() : wanted.normal, radius);
}

bool BallOnMesh::is_accessible(const CutterContact& contact, double distance) const
{
    return endmill::is_accessible(drop_, contact, distance);
}

bool BallOnMesh::is_clear(const Vec3& from, const Vec3& to) const
{
    const double radius = core_.cutter().radius();
    const double tolerance = core_tolerance_share * tolerance_;
    const Vec3 to_core_tip = radius * Vec3::UnitZ();
    if (distance_ > 0) {
        const Vec3 to_tip = cutter_.radius() * Vec3::UnitZ();
        if (drop_.is_clear(from - to_tip, to - to_tip, tolerance_))
            return true;
    } else {
        // most moves that gouge do so in the middle
        const Vec3 middle = (from + to) / 2;
        const auto found = core_.contact(middle.head<2>());
        if (found && found->tip_z > middle.z() - radius + tolerance)
            return false;
    }
    return core_.is_clear(from - to_core_tip, to - to_core_tip, tolerance);
}

}  // namespace endmill
