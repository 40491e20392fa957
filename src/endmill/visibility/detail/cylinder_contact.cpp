// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/cylinder_contact.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// A corner in cylinder coordinates.
struct Corner {
    double height;  // along the axis
    Vec3 across;    // offset from the axis, perpendicular to it
};

// A convex polygon. A triangle that is cut at two heights has at most five corners.
class Polygon {
public:
    void add(const Corner& corner) { corners_[count_++] = corner; }

    std::size_t size() const { return count_; }
    const Corner& operator[](std::size_t k) const { return corners_[k]; }

private:
    std::array<Corner, 5> corners_;
    std::size_t count_ = 0;
};

// The part of a polygon with sign * height >= sign * limit.
Polygon cut_off(const Polygon& polygon, double limit, double sign)
{
    Polygon rest;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Corner& corner = polygon[k];
        const Corner& next = polygon[(k + 1) % polygon.size()];
        const double over = sign * (corner.height - limit);
        const double next_over = sign * (next.height - limit);
        if (over >= 0)
            rest.add(corner);
        if ((over > 0 && next_over < 0) || (over < 0 && next_over > 0)) {
            const double share = over / (over - next_over);
            rest.add({limit, corner.across + share * (next.across - corner.across)});
        }
    }
    return rest;
}

// Squared distance of a side from the axis.
double square_from_axis(const Vec3& a, const Vec3& b)
{
    const Vec3 side = b - a;
    const double square = side.squaredNorm();
    const double share = square > 0 ? std::clamp(-a.dot(side) / square, 0.0, 1.0) : 0;
    return (a + share * side).squaredNorm();
}

// Tests whether the axis passes through the polygon: all sides turn about it in the same
// sense.
bool surrounds_axis(const Polygon& polygon, const Vec3& axis)
{
    bool turns_left = true;
    bool turns_right = true;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const double turn =
            axis.dot(polygon[k].across.cross(polygon[(k + 1) % polygon.size()].across));
        turns_left = turns_left && turn > 0;
        turns_right = turns_right && turn < 0;
    }
    return polygon.size() > 2 && (turns_left || turns_right);
}

// Error bound of `may_meet` and `meets` together, relative to the largest coordinate: at
// most a hundred roundings of 1.1e-16, with a margin.
constexpr double all_roundings = 1e-13;

}  // namespace

bool meets(const SolidCylinder& cylinder, const std::array<Vec3, 3>& corners)
{
    Polygon polygon;
    for (const Vec3& corner : corners) {
        const Vec3 offset = corner - cylinder.start;
        const double height = offset.dot(cylinder.axis);
        polygon.add({height, offset - height * cylinder.axis});
    }
    polygon = cut_off(cut_off(polygon, cylinder.from, 1), cylinder.to, -1);
    const double square = cylinder.radius * cylinder.radius;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        if (square_from_axis(polygon[k].across,
                             polygon[(k + 1) % polygon.size()].across) <= square)
            return true;
    return surrounds_axis(polygon, cylinder.axis);
}

bool may_meet(const SolidCylinder& cylinder, const Vec3& low, const Vec3& high)
{
    const Vec3 half = (high - low) / 2;
    const Vec3 offset = low + half - cylinder.start;
    const double doubt = all_roundings * (offset.cwiseAbs().maxCoeff() + half.maxCoeff() +
                                          cylinder.start.cwiseAbs().maxCoeff());
    const double height = offset.dot(cylinder.axis);
    const double reach = half.dot(cylinder.axis.cwiseAbs()) + doubt;
    if (height + reach < cylinder.from || height - reach > cylinder.to)
        return false;
    const double across = cylinder.radius + half.norm() + doubt;
    return (offset - height * cylinder.axis).squaredNorm() <= across * across;
}

}  // namespace endmill
