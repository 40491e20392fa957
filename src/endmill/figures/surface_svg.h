// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/figures/axonometric_figure.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// How a surface is drawn.
struct SurfaceDrawing {
    FigureOptions figure{};    ///< what surrounds it
    int spaces_per_patch = 8;  ///< between iso-parametric lines, at least 1
    bool control_net = false;  ///< whether the Bezier net of every patch is drawn
};

/// A surface in parallel projection, as an SVG file: shaded, with iso-parametric lines of
/// equal steps in each patch and patch borders thicker; what is nearer to the viewer
/// covers what is behind. The control net lies over everything.
/// Source: the manner of [KimChoi, figs. 2 and 11].
/// \throws DomainError if `spaces_per_patch` is below 1.
std::string surface_svg(const Surface& surface, const SurfaceDrawing& drawing = {});

}  // namespace endmill
