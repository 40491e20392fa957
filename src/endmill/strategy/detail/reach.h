// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// The region that a vertical tool axis sweeps during a straight move: all points c + s z
/// with c on the way of the centre and s >= 0. It gives the square of the distance of a
/// point from that region, as SweptAxis does for any axis. A move of a ball covers the
/// points within its radius of the region.
class UprightSweep {
public:
    /// \param from start of the centre, mm.
    /// \param to   end of the centre, mm.
    UprightSweep(const Vec3& from, const Vec3& to) : from_{from}
    {
        const Vec3 way = to - from;
        length_ = std::hypot(way.x(), way.y());
        rise_ = way.z();
        if (length_ > 0) {
            feed_x_ = way.x() / length_;
            feed_y_ = way.y() / length_;
        } else {
            from_.z() = std::min(from.z(), to.z());
            rise_ = 0;
        }
        inverse_square_ = 1 / std::max(length_ * length_ + rise_ * rise_, 1e-300);
    }

    /// Square of the distance of `point` from the region, mm^2.
    double squared_distance(const Vec3& point) const
    {
        const double x = point.x() - from_.x();
        const double y = point.y() - from_.y();
        const double z = point.z() - from_.z();
        const double along = x * feed_x_ + y * feed_y_;
        const double across = length_ > 0 ? x * feed_y_ - y * feed_x_ : std::hypot(x, y);
        return across * across + squared_in_plane(along, z);
    }

private:
    friend class SweepRows;

    static double square(double a) { return a * a; }

    // The same in the vertical plane of the move, in which the region lies.
    double squared_in_plane(double along, double z) const
    {
        if (length_ == 0)
            return square(std::min(z, 0.0));
        if (along >= 0 && along <= length_ && z * length_ >= rise_ * along)
            return 0;
        const double share =
            std::clamp((along * length_ + z * rise_) * inverse_square_, 0.0, 1.0);
        const double to_move =
            square(along - share * length_) + square(z - share * rise_);
        const double to_start = square(std::min(along, 0.0)) + square(std::min(z, 0.0));
        const double to_end =
            square(std::max(along - length_, 0.0)) + square(std::min(z - rise_, 0.0));
        if (along < 0)
            return std::min(to_move, to_start);
        if (along > length_)
            return std::min(to_move, to_end);
        return to_move;
    }

    Vec3 from_;
    double feed_x_ = 0;
    double feed_y_ = 0;
    double length_ = 0;
    double rise_ = 0;
    double inverse_square_ = 0;
};

/// How far a point lies beyond the reach of a ball of `radius`, from the square of its
/// distance: (d^2 - R^2) / 2R, which is the distance to first order where it is small.
inline double beyond_reach(double squared_distance, double radius)
{
    return (squared_distance - radius * radius) / (2 * radius);
}

/// Several sweeps, arranged so that their distances from a point are computed at once.
class SweepRows {
public:
    std::size_t size() const { return size_; }  ///< number of sweeps

    /// Removes all sweeps.
    void clear()
    {
        size_ = 0;
        upright_.clear();
    }
    /// Adds a sweep at the end.
    void add(const UprightSweep& sweep);

    /// Computes beyond_reach of a ball of `radius` on each sweep for a point, in mm. The
    /// numbers are those for the sweeps one by one.
    /// \param gaps results, one for each sweep.
    void gaps_at(const Vec3& point, double radius, std::span<double> gaps) const;

private:
    void grow();

    // the members of UprightSweep, each in a row with room for `room_` sweeps
    std::vector<double> rows_;
    std::size_t room_ = 0;
    std::size_t size_ = 0;
    // sweeps of upright moves, which are few, with their numbers
    std::vector<std::pair<std::size_t, UprightSweep>> upright_;
};

/// The same as beyond_reach for a ball that rests at `centre` and a point.
inline double point_reach(const Vec3& centre, const Vec3& point, double radius)
{
    const double x = point.x() - centre.x();
    const double y = point.y() - centre.y();
    const double z = std::min(0.0, point.z() - centre.z());
    return beyond_reach(x * x + y * y + z * z, radius);
}

}  // namespace endmill
