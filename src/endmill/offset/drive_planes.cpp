// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/drive_planes.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/error.h"
#include "endmill/surface/extent.h"

namespace endmill {
namespace {

// A larger number is a mistake of the caller: the path would not fit into memory.
constexpr int most_planes = 10'000'000;
// A sine or cosine below this is a rounding error of a multiple of 90 degrees, up to
// several turns: an angle has an error of about 1e-16 per quarter turn.
constexpr double zero_sine = 4e-15;
// Share of a pitch by which rounding may enlarge the quotient of extent and pitch.
constexpr double pitch_rounding = 1e-9;

double snapped(double sine)
{
    return std::abs(sine) <= zero_sine ? 0 : sine;
}

}  // namespace

DriveFrame::DriveFrame(Angle direction)
    : cosine_{snapped(std::cos(direction.radians()))},
      sine_{snapped(std::sin(direction.radians()))}
{
    require(std::isfinite(direction.radians()), "DriveFrame: need a finite angle");
}

DrivePlanes drive_planes(const DriveFrame& frame, const Interval& across, int count)
{
    require(1 <= count && count <= most_planes,
            "drive_planes: need 1 <= count <= 10000000");
    require(std::isfinite(across.low) && std::isfinite(across.high) &&
                across.low <= across.high,
            "drive_planes: need a finite extent");
    DrivePlanes planes{frame, {}};
    planes.positions.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k)
        planes.positions.push_back(across.low + (k + 0.5) * across.length() / count);
    return planes;
}

DrivePlanes drive_planes_by_pitch(const DriveFrame& frame, const Interval& across,
                                  double pitch)
{
    require(pitch > 0, "drive_planes_by_pitch: need 0 < pitch");
    const double count =
        std::max(1.0, std::ceil(across.length() / pitch - pitch_rounding));
    require(count <= most_planes, "drive_planes_by_pitch: more than 10000000 planes");
    return drive_planes(frame, across, static_cast<int>(count));
}

Interval extent_across(std::span<const Surface> surfaces, const DriveFrame& frame)
{
    return extent(surfaces, frame.point(0, 1, 0));
}

Interval extent_across(const TriangleMesh& mesh, const DriveFrame& frame)
{
    require(!mesh.points().empty(), "extent_across: need a point");
    Interval across{frame.across(mesh.points().front()),
                    frame.across(mesh.points().front())};
    for (const Vec3& point : mesh.points()) {
        across.low = std::min(across.low, frame.across(point));
        across.high = std::max(across.high, frame.across(point));
    }
    return across;
}

}  // namespace endmill
