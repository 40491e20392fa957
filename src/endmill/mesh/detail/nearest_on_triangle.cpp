// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/nearest_on_triangle.h"

#include <algorithm>

namespace endmill {
namespace {

// The ends are taken in one order, so that triangles which share an edge find the same.
Vec3 nearest_on_segment(const Vec3& place, const Vec3& end_a, const Vec3& end_b)
{
    const bool in_order = !std::ranges::lexicographical_compare(end_b, end_a);
    const Vec3& a = in_order ? end_a : end_b;
    const Vec3& b = in_order ? end_b : end_a;
    const Vec3 along = b - a;
    const double share = along.dot(place - a);
    const double square = along.squaredNorm();
    if (!(share > 0))
        return a;
    return share < square ? Vec3{a + share / square * along} : b;
}

Vec3 nearer(const Vec3& place, const Vec3& a, const Vec3& b)
{
    return (a - place).squaredNorm() <= (b - place).squaredNorm() ? a : b;
}

}  // namespace

// In the frame of the longest side and the height over it, whose digits do not suffer if
// the triangle is thin: s counts along that side a-b, h along the height to c. The angles
// at a and b are acute, so that a place below the side is nearest to it.
Vec3 nearest_on_triangle(const Vec3& place, const std::array<Vec3, 3>& corners)
{
    const std::array<double, 3> squares{(corners[1] - corners[0]).squaredNorm(),
                                        (corners[2] - corners[1]).squaredNorm(),
                                        (corners[0] - corners[2]).squaredNorm()};
    const auto longest = std::ranges::max_element(squares) - squares.begin();
    const Vec3& a = corners[longest];
    const Vec3& b = corners[(longest + 1) % 3];
    const Vec3& c = corners[(longest + 2) % 3];
    const Vec3 side = b - a;
    const double top = side.dot(c - a) / squares[longest];
    const Vec3 height = c - a - top * side;
    const double s = side.dot(place - a) / squares[longest];
    const double h = height.dot(place - a - s * side) / height.squaredNorm();
    if (!(h > 0))  // or the triangle has no height
        return nearest_on_segment(place, a, b);
    if (h * top <= s && s <= 1 - h * (1 - top))
        return a + s * side + h * height;
    return nearer(place, nearest_on_segment(place, a, c),
                  nearest_on_segment(place, b, c));
}

}  // namespace endmill
