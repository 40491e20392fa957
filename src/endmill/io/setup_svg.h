// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/io/shown_setup.h"

namespace endmill {

/// What surrounds the picture of a setup.
struct SetupFigure {
    std::string title = "Setup";           ///< above it; at most 100 characters show
    std::vector<std::string> captions{};   ///< lines below the title; 150 characters show
    double width_px = 900;                 ///< of the whole picture, at least 300
    Angle azimuth = Angle::degrees(-60);   ///< where the viewer stands, from X towards Y
    Angle elevation = Angle::degrees(25);  ///< of the viewer over the XY plane
    std::size_t most_facets = 20'000;      ///< drawn; at least 1
};

/// A part as it is set up on a machine, as an SVG file: shaded by the light from behind the
/// viewer, in blue where the tool reaches it without a turn of the rotary axes, in yellow where
/// it must turn, grey where one looks at the back of a facet; the rotary axes and the tool axis
/// as lines through its middle, and below it the machine's X, Y and Z. What lies further back
/// is drawn first, by the middles of facets, so that facets that pass through each other may
/// show in the wrong order. Of more than `most_facets` a coarser mesh is drawn, and a line
/// below the title says so.
/// Source: [KangSuh, figure 11].
/// \param reached_at_zero one a facet, 1 or 0.
/// \throws DomainError if the mesh has no facet, `reached_at_zero` is not of its facets, or as
///         `machine_directions` and `AxonometricFigure`.
std::string setup_svg(const TriangleMesh& mesh,
                      std::span<const std::uint8_t> reached_at_zero,
                      const ShownSetup& setup, const SetupFigure& figure);

}  // namespace endmill
