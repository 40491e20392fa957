// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/surface/surface.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// Coordinates along and across a feed direction in the xy plane, at angle a from +x:
///
///     s = x cos a + y sin a,   t = -x sin a + y cos a.
///
/// At multiples of 90 degrees the sine and cosine are exact, and so are s and t.
class DriveFrame {
public:
    /// \param direction direction of the feed, counter-clockwise from +x.
    /// \throws DomainError unless the angle is finite.
    explicit DriveFrame(Angle direction);

    double along(const Vec3& point) const  ///< s in mm
    {
        return point.x() * cosine_ + point.y() * sine_;
    }
    double across(const Vec3& point) const  ///< t in mm
    {
        return point.y() * cosine_ - point.x() * sine_;
    }
    /// The point at (s, t) and height z, all in mm.
    Vec3 point(double s, double t, double z) const
    {
        return {s * cosine_ - t * sine_, s * sine_ + t * cosine_, z};
    }

private:
    double cosine_;
    double sine_;
};

/// Vertical planes t = positions[k], parallel to the feed.
struct DrivePlanes {
    /// The coordinates along and across the feed.
    DriveFrame frame;
    std::vector<double> positions;  ///< t in mm, ascending
};

/// Planes at lo + (k + 1/2) (hi - lo) / count for k = 0 … count - 1.
/// \param frame the coordinates of the feed.
/// \param across [lo, hi], the extent across the feed in mm.
/// \param count number of planes.
/// \throws DomainError unless 1 <= count <= 10^7, lo <= hi and both are finite.
DrivePlanes drive_planes(const DriveFrame& frame, const Interval& across, int count);

/// The planes of drive_planes with the smallest number, at least 1, for which their
/// distance is at most `pitch`.
/// \param frame the coordinates of the feed.
/// \param across the extent across the feed in mm.
/// \param pitch in mm.
/// \throws DomainError unless pitch > 0, or as drive_planes does.
DrivePlanes drive_planes_by_pitch(const DriveFrame& frame, const Interval& across,
                                  double pitch);

/// The extent of `surfaces` across the feed in mm, see extent.h.
/// \throws DomainError if there is no surface.
Interval extent_across(std::span<const Surface> surfaces, const DriveFrame& frame);

/// The extent of the points of a mesh across the feed in mm.
/// \throws DomainError if there is no point.
Interval extent_across(const TriangleMesh& mesh, const DriveFrame& frame);

}  // namespace endmill
