// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/detail/swept_axis.h"

#include <algorithm>
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
      rise_{(to - from).dot(axis)},
      inverse_square_{0}
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
    const double square = length_ * length_ + rise_ * rise_;
    inverse_square_ = square > 0 ? 1 / square : 0;
}

double SweptAxis::farthest_along(const Vec3& direction) const
{
    if (direction.dot(axis_) > 0)
        return std::numeric_limits<double>::infinity();
    const double along_move = direction.dot(length_ * feed_ + rise_ * axis_);
    return direction.dot(base_) + std::max(along_move, 0.0);
}

}  // namespace endmill
