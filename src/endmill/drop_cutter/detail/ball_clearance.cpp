// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/ball_clearance.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// Halvings of a move: more seldom help, and then the exact test is as quick.
constexpr int most_halvings = 4;
// Share of the radius by which the ball is enlarged, for rounding errors. Coordinates may
// be a thousand times the radius.
constexpr double rounding_share = 1e-12;

// The plane of a triangle and a circle around it.
class CircledTriangle {
public:
    CircledTriangle(const std::array<Vec3, 3>& corners, double radius)
        : middle_{(corners[0] + corners[1] + corners[2]) / 3},
          normal_{(corners[1] - corners[0]).cross(corners[2] - corners[0])},
          radius_{radius * (1 + rounding_share)}
    {
        const double length = normal_.norm();
        is_flat_ = length > 0;
        if (is_flat_)
            normal_ /= normal_.z() < 0 ? -length : length;
        double square = 0;
        for (const Vec3& corner : corners)
            square = std::max(square, (corner - middle_).squaredNorm());
        size_ = std::sqrt(square);
    }

    // Whether the ball is proved to be clear, from two centres relative to the middle.
    bool is_clear(const Vec3& from, const Vec3& to, int halvings) const
    {
        const double height_from = normal_.dot(from);
        const double height_to = normal_.dot(to);
        const double height = std::min(height_from, height_to);
        if (height >= radius_)
            return true;
        if (height > 0) {
            const double circle = std::sqrt(radius_ * radius_ - height * height);
            const double needed = circle + size_;
            const double square =
                squared_distance(from - height_from * normal_, to - height_to * normal_);
            if (square > needed * needed)
                return true;
        }
        if (halvings == 0)
            return false;
        const Vec3 middle = (from + to) / 2;
        return is_clear(from, middle, halvings - 1) && is_clear(middle, to, halvings - 1);
    }

    const Vec3& middle() const { return middle_; }
    bool is_flat() const { return is_flat_; }

private:
    // Square of the distance of the middle from a segment.
    static double squared_distance(const Vec3& from, const Vec3& to)
    {
        const Vec3 way = to - from;
        const double square = way.squaredNorm();
        const double share =
            square > 0 ? std::clamp(-from.dot(way) / square, 0.0, 1.0) : 0.0;
        return (from + share * way).squaredNorm();
    }

    Vec3 middle_;
    Vec3 normal_;
    double radius_;
    double size_ = 0;
    bool is_flat_ = false;
};

}  // namespace

bool is_ball_proved_clear(const std::array<Vec3, 3>& corners, const Vec3& from,
                          const Vec3& to, double radius)
{
    const double highest = std::max({corners[0].z(), corners[1].z(), corners[2].z()});
    if (highest > std::min(from.z(), to.z()))
        return false;  // the cylinder may meet it
    const CircledTriangle triangle{corners, radius};
    return triangle.is_flat() && triangle.is_clear(from - triangle.middle(),
                                                   to - triangle.middle(), most_halvings);
}

}  // namespace endmill
