// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/rectangle_candidate.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// Tests whether a direction is low: its cosine with the tool axis is below 1e-6. The
/// gnomonic image of such a direction is so far away that rounding would decide the hull.
bool has_low_direction(const PolePoints& points);

/// The arc of a great circle through the tool axis that contains all directions, to 1e-9
/// rad. A direction opposite to the tool axis gets alpha = 180 degrees on the side where
/// alpha is larger.
/// \return nothing if there is no such arc.
std::optional<RectangleCandidate> great_circle_arc(const PolePoints& points);

/// Planar images of directions, from which the rectangles about a tool axis are measured.
///
/// Let R1 have the azimuth psi, d = (cos psi, sin psi) and e = (sin psi, -cos psi). A
/// direction with the gnomonic image g and the orthographic image o has tan alpha = g . e
/// and sin beta = o . d. So the extents of alpha are decided by the hull of the gnomonic
/// images, those of beta by the hull of the orthographic images.
/// Source: [KangSuh, eq. (17), (18)], in closed form. Why edges and limits suffice:
/// paper/notes/rectangle-about-an-axis.md, sections 1 to 3.
class RectangleImages {
public:
    /// \param points directions in the frame of the tool axis. \param directions the
    ///         same, unit.
    /// \param mode decides which hulls are used. \pre no direction is low.
    RectangleImages(const PolePoints& points, std::span<const Vec3> directions,
                    SetupMode mode);

    /// Rectangles with a meridian through an edge of the gnomonic hull, then, if the mode
    /// uses both hulls, with a parallel through an edge of the orthographic hull.
    std::vector<RectangleCandidate> at_edges() const;

    /// Rectangles such that a vertex of a hull lies at an end of `limits`.
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
