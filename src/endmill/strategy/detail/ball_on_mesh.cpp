// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/ball_on_mesh.h"

#include <algorithm>
#include <optional>

#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"
#include "endmill/drop_cutter/clearance.h"

namespace endmill {
namespace {

// Shares of the tolerance: by how much a contact may enter the mesh, so that the rest is
// left for the chords of moves; by how much the core is smaller than the ball; and what the
// test of the core adds.
constexpr double seat_share = 0.5;
constexpr double core_share = 0.9;
constexpr double core_tolerance_share = 0.05;
// A ball this far from the mesh, in mm, touches it.
constexpr double touching = 1e-7;
// Moves of the ball away from facets that it enters.
constexpr int most_pushes = 12;

}  // namespace

BallOnMesh::BallOnMesh(const TriangleMesh& mesh, const BallCutter& cutter,
                       double tolerance)
    : cutter_{cutter},
      tolerance_{tolerance},
      tree_{mesh},
      drop_{mesh, Cutter::ball(cutter.radius())},
      core_{mesh, Cutter::ball(cutter.radius() - core_share * tolerance)}
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
    const double radius = cutter_.radius();
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
    const Vec3 ideal = wanted.point + radius * wanted.normal;
    const double gap = tree_.nearest(ideal)->distance - radius;
    const bool is_in_place = -seat_share * tolerance_ <= gap && gap <= touching;
    if (is_in_place && !is_inside(ideal))
        return wanted;
    Vec3 centre = pushed_out(ideal, wanted.normal);
    const double core_radius = core_.cutter().radius();
    if (const auto found = core_.contact(centre.head<2>());
        found && found->tip_z > centre.z() - core_radius)
        centre.z() = drop_.contact(centre.head<2>())->tip_z + radius;
    const Vec3 point = nearest(centre);
    Vec3 normal = centre - point;
    // the shank may keep the ball off the mesh, and a wall is beside it at best
    normal = normal.norm() > touching ? normal.normalized() : wanted.normal;
    if (normal.z() < 0)
        normal = Vec3{normal.x(), normal.y(), 0}.normalized();
    return {centre - radius * normal, normal};
}

bool BallOnMesh::is_accessible(const CutterContact& contact, double distance) const
{
    return endmill::is_accessible(drop_, contact, distance);
}

bool BallOnMesh::is_clear(const Vec3& from, const Vec3& to) const
{
    const Vec3 to_tip = cutter_.radius() * Vec3::UnitZ();
    if (drop_.is_clear(from - to_tip, to - to_tip, tolerance_))
        return true;
    const Vec3 to_core_tip = core_.cutter().radius() * Vec3::UnitZ();
    return core_.is_clear(from - to_core_tip, to - to_core_tip,
                          core_tolerance_share * tolerance_);
}

}  // namespace endmill
