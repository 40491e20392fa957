// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/detail/cutter_core.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// Halvings of a triangle: 2^-30 of its sides is below any resolution.
constexpr int most_halvings = 60;

// A lower bound of the distances of the corners from the core, by the plane with the
// given normal.
double facet_distance(const CutterCore& core, const Vec3& normal,
                      const std::array<Vec3, 3>& corners)
{
    const double least = std::min(
        {normal.dot(corners[0]), normal.dot(corners[1]), normal.dot(corners[2])});
    return core.distance_beyond(normal, least);
}

}  // namespace

CutterCore::CutterCore(const Cutter& cutter, const Vec3& reference)
    : reference_{reference},
      flat_radius_{cutter.flat_radius()},
      r_{cutter.corner_radius()},
      is_ball_{cutter.is_ball()}
{
}

SupportingPlane CutterCore::nearest_plane(const Vec3& point) const
{
    const Vec3 from = point - reference_;
    if (is_ball_) {
        const double distance = from.norm();
        return distance > 0 ? SupportingPlane{from / distance, distance}
                            : SupportingPlane{-Vec3::UnitZ(), 0};
    }
    return nearest_plane_below(point);
}

// For a ball, these are the planes of the ray upwards from its centre, which never faces
// upwards.
SupportingPlane CutterCore::nearest_plane_below(const Vec3& point) const
{
    const Vec3 from = point - reference_;
    const double across = from.head<2>().norm();
    Vec3 out{1, 0, 0};
    if (across > 0)
        out.head<2>() = from.head<2>() / across;
    const double beside = across - flat_radius_;
    const double below = -from.z();
    if (beside > 0 && below > 0) {
        const double distance = std::hypot(beside, below);
        return {(beside * out - below * Vec3::UnitZ()) / distance, distance};
    }
    if (beside > below)
        return {out, beside};
    return {-Vec3::UnitZ(), below};
}

double CutterCore::distance_beyond(const Vec3& normal, double least) const
{
    const double level = normal.head<2>().norm();
    const double distance = least - normal.dot(reference_) - flat_radius_ * level;
    return is_ball_ || distance >= 0 ? distance
                                     : distance / (level + std::abs(normal.z()));
}

Vec3 CutterCore::turned_away(const Vec3& normal, const Vec3& point) const
{
    const double length = normal.norm();
    if (!(length > 0))
        return nearest_plane(point).normal;
    const bool turns = is_ball_ ? normal.dot(point - reference_) < 0 : normal.z() > 0;
    return (turns ? -normal : normal) / length;
}

TriangleGap triangle_gap(const CutterCore& core, const std::array<Vec3, 3>& corners,
                         double resolution, double enough)
{
    struct Piece {
        std::array<Vec3, 3> corners;
        int halvings;
    };
    TriangleGap least{core.gap(corners[0]), corners[0]};
    const auto look_at = [&](const Vec3& point) {
        if (const double gap = core.gap(point); gap < least.gap)
            least = {gap, point};
    };
    look_at(corners[1]);
    look_at(corners[2]);
    const Vec3 side = corners[1] - corners[0];
    const Vec3 away = core.turned_away(side.cross(corners[2] - corners[0]), corners[0]);
    const double facet = facet_distance(core, away, corners) - core.corner_radius();
    std::vector<Piece> open{{corners, 0}};
    while (!open.empty()) {
        const auto [piece, halvings] = open.back();
        open.pop_back();
        const Vec3 middle = (piece[0] + piece[1] + piece[2]) / 3;
        const auto [normal, distance] = core.nearest_plane(middle);
        look_at(middle);
        double bound = distance;
        for (const Vec3& corner : piece)
            bound = std::min(bound, distance + normal.dot(corner - middle));
        bound = std::max(facet, bound - core.corner_radius());
        if (bound >= std::min(least.gap - resolution, enough) ||
            halvings == most_halvings)
            continue;
        int facing = 0;
        double longest = -1;
        for (int k = 0; k < 3; ++k) {
            const double length2 =
                (piece[(k + 2) % 3] - piece[(k + 1) % 3]).squaredNorm();
            if (length2 > longest) {
                longest = length2;
                facing = k;
            }
        }
        const Vec3& from = piece[(facing + 1) % 3];
        const Vec3& to = piece[(facing + 2) % 3];
        const Vec3 between = from + (to - from) / 2;
        look_at(between);
        open.push_back({{piece[facing], from, between}, halvings + 1});
        open.push_back({{piece[facing], between, to}, halvings + 1});
    }
    return least;
}

}  // namespace endmill
