// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/detail/swept_axis.h"

#include <algorithm>
#include <array>
#include <limits>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// Share of the coordinates and of the move's length. A move that is shorter across the
// axis has a direction that consists of rounding errors.
constexpr double no_length = 1e-9;

}  // namespace

SweptAxis::SweptAxis(const Vec3& from, const Vec3& to, const Vec3& axis)
    : base_{from},
      axis_{axis},
      feed_{axis.unitOrthogonal()},
      length_{0},
      rise_{(to - from).dot(axis)}
{
    const Vec3 along = to - from;
    const Vec3 across = along - rise_ * axis;
    const double size =
        along.norm() + from.cwiseAbs().maxCoeff() + to.cwiseAbs().maxCoeff();
    if (across.norm() > no_length * size) {
        length_ = across.norm();
        feed_ = across / length_;
    } else {
        base_ += std::min(rise_, 0.0) * axis;
        rise_ = 0;
    }
}

Vec3 SweptAxis::nearest(const Vec3& point) const
{
    using Place = Eigen::Vector2d;  // coordinates along the feed and along the axis
    const Vec3 from_base = point - base_;
    const Place place{from_base.dot(feed_), from_base.dot(axis_)};
    const bool is_inside = 0 <= place[0] && place[0] <= length_ &&
                           place[1] * length_ >= rise_ * place[0] && length_ > 0;
    Place best = place;
    if (!is_inside) {
        const Place move{length_, rise_};
        const double square = move.squaredNorm();
        const double share =
            square > 0 ? std::clamp(place.dot(move) / square, 0.0, 1.0) : 0;
        best = share * move;  // the shanks at both ends of the move are tested next
        for (const Place& end : {Place{0, std::max(place[1], 0.0)},
                                 Place{length_, std::max(place[1], rise_)}})
            if ((end - place).squaredNorm() < (best - place).squaredNorm())
                best = end;
    }
    return base_ + best[0] * feed_ + best[1] * axis_;
}

double SweptAxis::farthest_along(const Vec3& direction) const
{
    if (direction.dot(axis_) > 0)
        return std::numeric_limits<double>::infinity();
    const double along_move = direction.dot(length_ * feed_ + rise_ * axis_);
    return direction.dot(base_) + std::max(along_move, 0.0);
}

}  // namespace endmill
