// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/solid_shapes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int sides = 36;        // facets of a cylinder
constexpr double seam_px = 0.7;  // outline that hides anti-aliased gaps between faces

// Light comes from above and from the left of the viewer.
std::string_view shade(const AxonometricView& view, const SolidColours& colours,
                       const Vec3& normal)
{
    if (normal.z() > 0.5)
        return colours.light;
    return normal.dot(view.right) < 0.3 ? colours.middle : colours.dark;
}

// Draws a face if the viewer sees its outer side.
void add_face(AxonometricFigure& figure, std::span<const Vec3> corners,
              const Vec3& normal, const SolidColours& colours)
{
    if (normal.dot(figure.view().toward) <= 0)
        return;
    const std::string_view colour = shade(figure.view(), colours, normal);
    figure.add_polygon(corners, colour, {colour, seam_px, ""});
}

// Points of a circle around `axis`.
std::vector<Vec3> circle(const Vec3& middle, const Vec3& axis, double radius)
{
    const Vec3 across = axis.unitOrthogonal();
    const Vec3 other = axis.cross(across);
    std::vector<Vec3> points;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * pi * k / sides;
        points.emplace_back(
            middle + radius * (std::cos(angle) * across + std::sin(angle) * other));
    }
    return points;
}

}  // namespace

// Each of the six faces is drawn if the viewer sees its outer side; a convex solid needs
// no sorting.
void add_box(AxonometricFigure& figure, const Vec3& middle, const Vec3& half_size,
             const SolidColours& colours)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            const Vec3 normal = side * Vec3::Unit(axis);
            const Vec3 out = half_size[axis] * normal;
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            const Vec3 along = half_size[u] * Vec3::Unit(u);
            const Vec3 across = half_size[v] * Vec3::Unit(v);
            const std::array<Vec3, 4> corners{
                middle + out - along - across, middle + out + along - across,
                middle + out + along + across, middle + out - along + across};
            add_face(figure, corners, normal, colours);
        }
}

// The side is drawn as narrow facets, then the two ends.
void add_cylinder(AxonometricFigure& figure, const Vec3& from, const Vec3& to,
                  double radius, const SolidColours& colours)
{
    const Vec3 axis = (to - from).normalized();
    const std::vector<Vec3> first = circle(from, axis, radius);
    const std::vector<Vec3> last = circle(to, axis, radius);
    for (std::size_t k = 0; k < first.size(); ++k) {
        const std::size_t next = (k + 1) % first.size();
        const std::array<Vec3, 4> corners{first[k], first[next], last[next], last[k]};
        add_face(figure, corners, (first[k] + first[next]) / 2 - from, colours);
    }
    add_face(figure, first, -axis, colours);
    add_face(figure, last, axis, colours);
}

// The arc starts and ends symmetrically to the point nearest to the viewer. Its last
// pieces are drawn as a straight arrow, which gives the head.
void add_turn_arrow(AxonometricFigure& figure, const TurnArrow& arrow,
                    const LineStyle& style)
{
    // Cosine between the axis and the line of sight, beyond which the whole circle is
    // visible.
    constexpr double seen_along_axis = 0.45;
    const Vec3& toward = figure.view().toward;
    const bool is_whole = std::abs(arrow.axis.dot(toward)) > seen_along_axis;
    const Vec3 near = (toward - toward.dot(arrow.axis) * arrow.axis).normalized();
    const Vec3 beside = arrow.axis.cross(near);
    const double half = is_whole ? 0.75 * pi : 0.5 * pi;
    std::vector<Vec3> points;
    for (int k = 0; k <= sides; ++k) {
        const double angle = half * (2.0 * k / sides - 1);
        points.emplace_back(arrow.middle + arrow.radius * (std::cos(angle) * near +
                                                           std::sin(angle) * beside));
    }
    figure.add_curve(points, style);
    constexpr std::size_t head_pieces = 4;  // pieces of the arc that carry the arrow head
    figure.add_arrow(points[points.size() - 1 - head_pieces], points.back(), style);
}

void add_double_arrow(AxonometricFigure& figure, const Vec3& from, const Vec3& to,
                      const LineStyle& style)
{
    const Vec3 middle = (from + to) / 2;
    figure.add_arrow(middle, from, style);
    figure.add_arrow(middle, to, style);
}

}  // namespace endmill
