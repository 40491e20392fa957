// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "endmill/core/tolerance.h"
#include "endmill/core/vec.h"

namespace endmill {

/// A right-handed frame whose z axis, the pole, is a tool axis. For the tool axis +Z it
/// is the frame of the part.
struct PoleFrame {
    Vec3 pole;  ///< unit: z
    Vec3 x;     ///< unit: azimuth 0
    Vec3 y;     ///< unit: azimuth 90 degrees

    /// \pre `tool_axis` has unit length.
    explicit PoleFrame(const Vec3& tool_axis);

    /// The unit vector 90 degrees from the pole at `azimuth`, rad.
    Vec3 equator(double azimuth) const;
};

/// Coordinates of directions in the frame of a tool axis, in arrays for fast loops.
struct PolePoints {
    PoleFrame frame;        ///< of the tool axis
    std::vector<double> x;  ///< one for each direction
    std::vector<double> y;  ///< one for each direction
    std::vector<double> z;  ///< one for each direction

    /// \pre `tool_axis` and `directions` have unit length.
    PolePoints(const Vec3& tool_axis, std::span<const Vec3> directions);

    std::size_t size() const { return x.size(); }  ///< number of directions
    double polar(std::size_t i) const;             ///< polar angle, rad, within [0, pi]
    double azimuth(std::size_t i) const;  ///< rad, about the pole, within (-pi, pi]
};

/// Shifts an angle by whole turns into [0, 2 pi), rad. Rounding may give 2 pi itself.
double full_turn(double angle);

/// Square radians in a square degree.
inline constexpr double square_degree =
    (std::numbers::pi / 180) * (std::numbers::pi / 180);

}  // namespace endmill
