// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "endmill/core/vec.h"

namespace endmill {

/// The region that the axis of a ball and its shank sweeps during a straight move: all
/// points c + s P with c on the way of the centre, s >= 0, and P the direction of the
/// axis. The ball and its shank of the same radius R sweep exactly the points within R of
/// it. The region is convex and plane. It is a ray if the move is along P, or if the move
/// across P is shorter than 1e-9 of its coordinates and length.
class SweptAxis {
public:
    /// \param from start of the centre, mm, finite.
    /// \param to end of the centre, mm, finite.
    /// \param axis P, unit.
    SweptAxis(const Vec3& from, const Vec3& to, const Vec3& axis);

    /// The point of the region that is nearest to `point`, accurate to a few roundings.
    Vec3 nearest(const Vec3& point) const
    {
        const Vec3 from_base = point - base_;
        const double along = from_base.dot(feed_);
        const double up = from_base.dot(axis_);
        if (length_ > 0 && 0 <= along && along <= length_ &&
            up * length_ >= rise_ * along)
            return base_ + along * feed_ + up * axis_;
        const auto squared_to = [&](double x, double z) {
            return (x - along) * (x - along) + (z - up) * (z - up);
        };
        const double share =
            std::clamp((along * length_ + up * rise_) * inverse_square_, 0.0, 1.0);
        double best_along = share * length_;
        double best_up = share * rise_;
        // beside the move, a shank at one of its ends may be nearer
        if (along <= 0 || along >= length_) {
            const double end = along <= 0 ? 0 : length_;
            const double height = std::max(up, along <= 0 ? 0 : rise_);
            if (squared_to(end, height) < squared_to(best_along, best_up)) {
                best_along = end;
                best_up = height;
            }
        }
        return base_ + best_along * feed_ + best_up * axis_;
    }

    /// The greatest `direction` . p over the points p of the region, accurate to a few
    /// roundings: everything beyond it along `direction` lies outside the region.
    /// Infinite if the direction rises along the axis.
    double farthest_along(const Vec3& direction) const;

private:
    Vec3 base_;              // start of the move
    Vec3 axis_;              // unit
    Vec3 feed_;              // unit, perpendicular to the axis
    double length_;          // length of the move along feed_
    double rise_;            // length of the move along axis_
    double inverse_square_;  // of the move's length in mm, or 0
};

}  // namespace endmill
