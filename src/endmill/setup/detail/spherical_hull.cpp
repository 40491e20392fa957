// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/spherical_hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "endmill/core/error.h"
#include "endmill/setup/detail/spherical_turn.h"

namespace endmill {
namespace {

// Exact tests of the images of directions in a plane perpendicular to the tool axis.
class ImagePlane {
public:
    ImagePlane(const Vec3& tool_axis, HullProjection projection)
        : axis_{tool_axis},
          perpendiculars_{exact_perpendiculars(tool_axis)},
          is_gnomonic_{projection == HullProjection::Gnomonic}
    {
    }

    // 1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if they are collinear.
    int turn(const Vec3& a, const Vec3& b, const Vec3& c) const
    {
        return is_gnomonic_ ? turn_about(a, b, c) : turn_along(axis_, a, b, c);
    }

    // Orders images lexicographically: by the first perpendicular, then by the second.
    // This is the order in which a sweep line meets them that is tilted by an infinitely
    // small angle.
    bool is_before(const Vec3& a, const Vec3& b) const
    {
        const int across = sweep_order(perpendiculars_[0], a, b);
        return across != 0 ? across > 0 : sweep_order(perpendiculars_[1], a, b) > 0;
    }

private:
    // 1 if the parallel to `line` through a comes before the one through b, -1 if it
    // comes after. Gnomonic images satisfy z_a z_b (g_b - g_a) x line = det(line, a, b).
    int sweep_order(const Vec3& line, const Vec3& a, const Vec3& b) const
    {
        return is_gnomonic_ ? turn_about(line, a, b) : order_along(axis_, line, a, b);
    }

    Vec3 axis_;
    std::array<Vec3, 2> perpendiculars_;
    bool is_gnomonic_;
};

std::vector<Vec3> with_axis(const Vec3& tool_axis, std::span<const Vec3> directions)
{
    std::vector<Vec3> points{tool_axis};
    points.insert(points.end(), directions.begin(), directions.end());
    return points;
}

// Appends the convex chain from the first point to the last, such that all points lie to
// its left or on it. The last point is left out, because the next chain begins with it.
void append_chain(std::vector<Vec3>& hull, std::span<const Vec3> points,
                  const ImagePlane& plane)
{
    const std::size_t begin = hull.size();
    for (const Vec3& point : points) {
        while (hull.size() >= begin + 2 &&
               plane.turn(hull[hull.size() - 2], hull.back(), point) <= 0)
            hull.pop_back();
        hull.push_back(point);
    }
    hull.pop_back();
}

void require_open_hemisphere(const Vec3& tool_axis, std::span<const Vec3> directions)
{
    require(is_in_open_hemisphere(tool_axis, directions),
            "spherical hull: need directions less than 90 degrees from the tool axis");
}

// The two ends of collinear images, or one image if all are equal.
std::vector<Vec3> ends_of_line(std::span<const Vec3> points, const ImagePlane& plane)
{
    const auto before = [&plane](const Vec3& a, const Vec3& b) {
        return plane.is_before(a, b);
    };
    const auto [first, last] = std::minmax_element(points.begin(), points.end(), before);
    if (!plane.is_before(*first, *last))
        return {*first};
    return {*first, *last};
}

// Adds a point outside the hull. It replaces the vertices between the edges that face it.
// Edges collinear with the point count as facing it, so that only the farther of
// collinear vertices stays.
void add_to_hull(std::vector<Vec3>& hull, const Vec3& point, const ImagePlane& plane)
{
    const std::size_t count = hull.size();
    std::vector<int> sides(count);
    for (std::size_t i = 0; i < count; ++i)
        sides[i] = plane.turn(hull[i], hull[(i + 1) % count], point);
    if (*std::min_element(sides.begin(), sides.end()) >= 0)
        return;
    std::size_t first = 0;  // the first edge that faces the point
    while (sides[first] > 0 || sides[(first + count - 1) % count] <= 0)
        ++first;
    std::vector<Vec3> result{point};
    std::size_t edge = first;
    while (sides[edge % count] <= 0)
        ++edge;
    for (; edge <= first + count; ++edge)
        result.push_back(hull[edge % count]);
    hull = std::move(result);
}

}  // namespace

std::array<Vec3, 2> exact_perpendiculars(const Vec3& axis)
{
    int largest = 0;
    require(axis.cwiseAbs().maxCoeff(&largest) > 0, "spherical hull: the tool axis is 0");
    std::array<Vec3, 2> result{Vec3::Zero(), Vec3::Zero()};
    for (std::size_t i = 0; i < 2; ++i) {
        const int other = (largest + 1 + static_cast<int>(i)) % 3;
        result[i][other] = axis[largest];
        result[i][largest] = -axis[other];
    }
    return result;
}

bool is_in_open_hemisphere(const Vec3& axis, std::span<const Vec3> directions)
{
    return std::all_of(directions.begin(), directions.end(),
                       [&axis](const Vec3& v) { return side_of(axis, v) > 0; });
}

std::vector<Vec3> spherical_hull(const Vec3& tool_axis, std::span<const Vec3> directions,
                                 HullProjection projection)
{
    if (projection == HullProjection::Gnomonic)
        require_open_hemisphere(tool_axis, directions);
    const ImagePlane plane{tool_axis, projection};
    const auto before = [&plane](const Vec3& a, const Vec3& b) {
        return plane.is_before(a, b);
    };
    std::vector<Vec3> points = with_axis(tool_axis, directions);
    std::sort(points.begin(), points.end(), before);
    points.erase(
        std::unique(points.begin(), points.end(),
                    [&before](const Vec3& a, const Vec3& b) { return !before(a, b); }),
        points.end());
    if (points.size() < 2)
        return points;
    std::vector<Vec3> hull;
    append_chain(hull, points, plane);
    std::reverse(points.begin(), points.end());
    append_chain(hull, points, plane);
    return hull;
}

std::vector<Vec3> incremental_hull(const Vec3& tool_axis,
                                   std::span<const Vec3> directions)
{
    require_open_hemisphere(tool_axis, directions);
    const ImagePlane plane{tool_axis, HullProjection::Gnomonic};
    std::vector<Vec3> points{directions.begin(), directions.end()};
    std::stable_sort(points.begin(), points.end(),
                     [&tool_axis](const Vec3& a, const Vec3& b) {
                         return tool_axis.dot(a) > tool_axis.dot(b);
                     });
    // The hull begins with a triangle: the tool axis, the nearest other image, and the
    // nearest image that is not collinear with both.
    const auto second = std::find_if(points.begin(), points.end(), [&](const Vec3& v) {
        return plane.is_before(tool_axis, v) || plane.is_before(v, tool_axis);
    });
    const auto third = std::find_if(points.begin(), points.end(), [&](const Vec3& v) {
        return second != points.end() && plane.turn(tool_axis, *second, v) != 0;
    });
    if (third == points.end())
        return ends_of_line(with_axis(tool_axis, directions), plane);
    std::vector<Vec3> hull{tool_axis, *second, *third};
    if (plane.turn(tool_axis, *second, *third) < 0)
        std::swap(hull[1], hull[2]);
    for (const Vec3& point : points)
        add_to_hull(hull, point, plane);
    return hull;
}

}  // namespace endmill
