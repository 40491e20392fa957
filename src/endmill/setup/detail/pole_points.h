// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "endmill/core/tolerance.h"
#include "endmill/core/vec.h"

namespace endmill {

/// Axes about a tool axis, which is z. Along +Z they are those of the part.
struct PoleFrame {
    Vec3 pole;  ///< unit
    Vec3 x;     ///< unit: azimuth 0
    Vec3 y;     ///< unit: azimuth 90

    /// \pre `tool_axis` has unit length.
    explicit PoleFrame(const Vec3& tool_axis);

    /// The unit vector at `azimuth`, rad, 90 degrees from the pole.
    Vec3 equator(double azimuth) const;
};

/// Directions in a frame, by coordinates.
struct PolePoints {
    PoleFrame frame;
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;

    /// \pre `tool_axis` and `directions` have unit length.
    PolePoints(const Vec3& tool_axis, std::span<const Vec3> directions);

    std::size_t size() const { return x.size(); }  ///< number of directions
    double polar(std::size_t i) const;             ///< rad, from the pole, within [0, pi]
    double azimuth(std::size_t i) const;  ///< rad, about the pole, within (-pi, pi]
};

/// `angle` + 2 pi k within [0, 2 pi), rad; 2 pi itself where rounding gives it.
double full_turn(double angle);

/// rad^2 in a square degree.
inline constexpr double square_degree =
    (std::numbers::pi / 180) * (std::numbers::pi / 180);

}  // namespace endmill
