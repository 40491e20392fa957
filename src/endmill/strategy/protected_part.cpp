// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/protected_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// Shares of the tolerance: by how much the mesh may deviate from surfaces; the distance that
// contacts keep from the mesh; and by how much the ball of moves is larger than the cutter.
// A move is clear if this ball rises by at most that last share along the axis: the cutter
// lies within the larger ball at its raised place.
constexpr double chord_share = 0.1;
constexpr double distance_share = 0.25;
constexpr double move_share = 0.05;
// The same for a path that is checked again, so that rounding does not matter.
constexpr double checked_share = 0.1;
// Most triangles of the mesh of surfaces. They need about 1 GB.
constexpr std::size_t most_triangles = 10'000'000;
// The distance at which a contact is held off is found to this share of the greatest one.
constexpr double holding_share = 1.0 / 4096;
// A height of remaining stock that no part exceeds, mm.
constexpr double no_scallop_limit = 1e9;

ProtectedMesh mesh_of(const Part& part, double chord_error)
{
    if (const auto* mesh = std::get_if<TriangleMesh>(&part))
        return {std::make_shared<const TriangleMesh>(*mesh), 0};
    const auto& surfaces = std::get<std::vector<Surface>>(part);
    SampledSurface found = sampled(surfaces, tool_side_signs(surfaces, Vec3::UnitZ()),
                                   chord_error, most_triangles);
    return {std::make_shared<const TriangleMesh>(std::move(found.mesh)),
            found.max_chord_error_mm};
}

// The part of a stretch, as shares from 0 to 1.
struct Shares {
    double from = 0;
    double to = 1;
};

// Limits the shares to those at which a coordinate that runs from a to b lies in a range.
// \return whether some are left.
bool clip(Shares& shares, double a, double b, double low, double high)
{
    if (a == b)
        return low <= a && a <= high;
    const double at_low = (low - a) / (b - a);
    const double at_high = (high - a) / (b - a);
    shares.from = std::max(shares.from, std::min(at_low, at_high));
    shares.to = std::min(shares.to, std::max(at_low, at_high));
    return shares.from <= shares.to;
}

std::string place_of(const Vec3& point)
{
    return to_text(point.x()) + ", " + to_text(point.y()) + ", " + to_text(point.z());
}

}  // namespace

ProtectedPart::ProtectedPart(const Part& part, const BallCutter& cutter, double tolerance)
    : ProtectedPart{part, cutter, tolerance, mesh_of(part, chord_share * tolerance)}
{
}

ProtectedPart::ProtectedPart(const Part& part, const BallCutter& cutter, double tolerance,
                             ProtectedMesh mesh)
    : part_{&part},
      cutter_{cutter},
      tolerance_{tolerance},
      mesh_{std::move(mesh)},
      low_{Vec3::Constant(std::numeric_limits<double>::infinity())},
      high_{-low_},
      seat_{*mesh_.mesh, Cutter::ball(cutter.radius() + mesh_.chord_error +
                                      distance_share * tolerance)},
      moved_{*mesh_.mesh,
             Cutter::ball(cutter.radius() + mesh_.chord_error + move_share * tolerance)}
{
    require(0 < tolerance && tolerance < cutter.radius(),
            "ProtectedPart: need 0 < tolerance < cutter radius");
    for (const Vec3& point : mesh_.mesh->points()) {
        low_ = low_.cwiseMin(point);
        high_ = high_.cwiseMax(point);
    }
}

bool ProtectedPart::is_clear(const Vec3& centre) const
{
    return depth(centre) <= 0;
}

// How far the ball would have to rise to keep its distance, mm; at most 0 where it does.
double ProtectedPart::depth(const Vec3& centre) const
{
    constexpr double never = -std::numeric_limits<double>::infinity();
    const double radius = seat_.cutter().radius();
    const bool is_beside = ((centre - low_).head<2>().array() < -radius).any() ||
                           ((centre - high_).head<2>().array() > radius).any();
    if (is_beside || centre.z() - radius >= high_.z())
        return never;
    const auto found = seat_.contact(centre.head<2>());
    return found ? found->tip_z - (centre.z() - radius) : never;
}

bool ProtectedPart::is_clear(const Vec3& from, const Vec3& to) const
{
    return is_clear(from, to, move_share * tolerance_);
}

// Whether the larger ball of moves rises by at most `rise` mm. The drop cutter takes moves
// near the mesh only.
bool ProtectedPart::is_clear(const Vec3& from, const Vec3& to, double rise) const
{
    const double radius = moved_.cutter().radius();
    if (std::min(from.z(), to.z()) - radius >= high_.z())
        return true;
    Shares near;
    for (int c = 0; c < 2; ++c)
        if (!clip(near, from[c], to[c], low_[c] - radius, high_[c] + radius))
            return true;
    const auto tip_at = [&](double share) -> Vec3 {
        return (1 - share) * from + share * to - radius * Vec3::UnitZ();
    };
    return moved_.is_clear(tip_at(near.from), tip_at(near.to), rise);
}

bool ProtectedPart::is_accessible(const CutterContact& place, double distance) const
{
    return is_clear(place.point + (cutter_.radius() + distance) * place.normal);
}

CutterContact ProtectedPart::held_off(const CutterContact& contact, double most) const
{
    const auto depth_at = [&](double distance) {
        return depth(contact.point + (cutter_.radius() + distance) * contact.normal);
    };
    double too_near = 0;
    double depth_near = depth_at(too_near);
    double far_enough = most;
    double depth_far = depth_near > 0 ? depth_at(far_enough) : 0;
    if (depth_near <= 0 || depth_far > 0)
        return contact;
    // The depth is nearly a line, so that its zero is found at once: a place just beyond the
    // zero of the chord is far enough, and one just before it is too near. Where the chord says
    // little, every third step halves the range.
    const double resolution = holding_share * most;
    constexpr std::array<double, 2> beside_zero{0.4, -0.4};  // in resolutions
    for (std::size_t step = 0; far_enough - too_near > resolution; ++step) {
        const double zero =
            too_near + (far_enough - too_near) * depth_near / (depth_near - depth_far);
        const std::size_t turn = step % (beside_zero.size() + 1);
        double distance = (too_near + far_enough) / 2;
        if (turn < beside_zero.size() && std::isfinite(depth_far))
            distance = std::clamp(zero + beside_zero[turn] * resolution,
                                  too_near + resolution / 2, far_enough - resolution / 2);
        const double found = depth_at(distance);
        if (found <= 0) {
            far_enough = distance;
            depth_far = found;
        } else {
            too_near = distance;
            depth_near = found;
        }
    }
    return {contact.point + far_enough * contact.normal, contact.normal};
}

void ProtectedPart::require_clear(const ToolPath& path) const
{
    const Vec3 to_centre = cutter_.radius() * Vec3::UnitZ();
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const Vec3& to = path.points[k].location.tip;
        const Vec3& from = path.points[k > 0 ? k - 1 : k].location.tip;
        if (!is_clear(from + to_centre, to + to_centre, checked_share * tolerance_))
            throw GeometryError{
                std::string{"the "} + std::string{move_name(path.points[k].move)} +
                (k > 0 ? " from " + place_of(from) : std::string{}) + " to " +
                place_of(to) + " would enter the protected part"};
    }
}

bool ProtectedPart::faces_tool() const
{
    const auto* surfaces = std::get_if<std::vector<Surface>>(part_);
    if (!surfaces)
        return true;
    const std::vector<double> sides = tool_side_signs(*surfaces, Vec3::UnitZ());
    for (std::size_t k = 0; k < surfaces->size(); ++k)
        if (find_unreachable_place((*surfaces)[k], Vec3::UnitZ(), sides[k]))
            return false;
    return true;
}

Deviation ProtectedPart::deviation(const ToolPath& path) const
{
    const PathDeviationOptions options{{tolerance_, no_scallop_limit}};
    const Cutter ball = Cutter::ball(cutter_.radius());
    if (faces_tool())
        return deviation_of_path(*part_, path, ball, options);
    Deviation found = deviation_of_path(Part{*mesh_.mesh}, path, ball, options);
    found.gouge_bound_mm += mesh_.chord_error;
    return found;
}

Verdict ProtectedPart::verdict(const Deviation& deviation, Verdict of_other) const
{
    const Verdict own = endmill::verdict(deviation, {tolerance_, no_scallop_limit});
    const bool decides = own == Verdict::Gouged ||
                         (own == Verdict::Undecided && of_other == Verdict::Clean);
    return decides ? own : of_other;
}

}  // namespace endmill
