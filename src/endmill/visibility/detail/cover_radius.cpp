// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/cover_radius.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace endmill {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

// A centre at 60 degrees or more does not bound a cell within 30 degrees.
constexpr double neighbour_cosine = 0.5;

// Half the side of the initial square. It contains the image of the cap of 30 degrees,
// whose radius in the tangent plane is tan 30 = 0.577.
constexpr double half_square = 0.6;

// The part of a convex polygon where line . (u, v, 1) >= 0.
Polygon clipped(const Polygon& polygon, const Vec3& line)
{
    Polygon kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Eigen::Vector2d& from = polygon[k];
        const Eigen::Vector2d& to = polygon[(k + 1) % polygon.size()];
        const double start = line.dot(from.homogeneous());
        const double end = line.dot(to.homogeneous());
        if (start >= 0)
            kept.push_back(from);
        if ((start >= 0) != (end >= 0))
            kept.push_back(from + start / (start - end) * (to - from));
    }
    return kept;
}

// The Voronoi cell of `centre` in the gnomonic projection onto its tangent plane.
Polygon voronoi_cell(const Vec3& centre, std::span<const Vec3> centres)
{
    const Vec3 u = centre.unitOrthogonal();
    const Vec3 v = centre.cross(u);
    Polygon cell{{-half_square, -half_square},
                 {half_square, -half_square},
                 {half_square, half_square},
                 {-half_square, half_square}};
    for (const Vec3& other : centres) {
        const Vec3 nearer = centre - other;
        if (centre.dot(other) > neighbour_cosine && !nearer.isZero(0))
            cell = clipped(cell, {nearer.dot(u), nearer.dot(v), nearer.dot(centre)});
    }
    return cell;
}

}  // namespace

double cover_radius(std::span<const Vec3> centres)
{
    double tangent = 0;
    for (const Vec3& centre : centres)
        for (const Eigen::Vector2d& corner : voronoi_cell(centre, centres))
            tangent = std::max(tangent, corner.norm());
    return std::atan(tangent);
}

}  // namespace endmill
