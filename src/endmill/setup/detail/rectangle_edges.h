// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/rectangle_candidate.h"
#include "endmill/setup/setup_mode.h"

namespace endmill {

/// Whether a direction has a cosine below 1e-6 with the tool axis: its gnomonic image is so
/// far off that a hull of cells 0.1 rad wide would rest on rounding.
bool has_low_direction(const PolePoints& points);

/// The arc of a great circle through the tool axis that holds all directions, to 1e-9 rad, if
/// there is one. Opposite to the tool axis alpha is 180 degrees, on the side that has more.
std::optional<RectangleCandidate> great_circle_arc(const PolePoints& points);

/// The planar images by which the rectangles about a tool axis are measured: with R1 at
/// azimuth psi, d = (cos psi, sin psi) and e = (sin psi, -cos psi), a direction of gnomonic
/// image g and orthographic image o has tan alpha = g . e and sin beta = o . d.
/// Source: [KangSuh, eq. (17), (18)], in closed form; why edges and limits are enough:
/// paper/notes/rectangle-about-an-axis.md.
class RectangleImages {
public:
    /// \pre no direction is low.
    RectangleImages(const PolePoints& points, std::span<const Vec3> directions,
                    SetupMode mode);

    /// Those of `rectangle_candidates`, if the directions lie on no one great circle.
    std::vector<RectangleCandidate> at_edges() const;

    /// Rectangles with a vertex of a hull at an end of `limits`.
    std::vector<RectangleCandidate> at_limits(const RotaryLimits& limits) const;

private:
    struct Image {
        double x;
        double y;
    };

    RectangleCandidate rectangle(const Vec3& r1_axis, RectangleOrigin origin) const;
    void add_at(double azimuth, std::vector<RectangleCandidate>& found) const;

    PoleFrame frame_;
    std::vector<Vec3> gnomonic_hull_;
    std::vector<Vec3> orthographic_hull_;  // empty unless the mode has both
    std::vector<Image> gnomonic_;
    std::vector<Image> orthographic_;
};

}  // namespace endmill
