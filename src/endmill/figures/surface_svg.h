// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/figures/axonometric_figure.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Title, view and content of the figure of a surface.
struct SurfaceDrawing {
    FigureOptions figure{};    ///< title, captions, size and view
    int spaces_per_patch = 8;  ///< intervals between iso-parametric lines; at least 1
    bool control_net = false;  ///< whether the control net of every patch is drawn
};

/// A surface in parallel projection, as an SVG file: shaded, with iso-parametric lines at
/// equal steps in each patch and thicker patch borders. Nearer cells cover farther ones;
/// the control net covers everything.
/// Source: after [KimChoi, figs. 2 and 11].
/// \throws DomainError if `spaces_per_patch` is below 1, and as `AxonometricFigure`.
std::string surface_svg(const Surface& surface, const SurfaceDrawing& drawing = {});

}  // namespace endmill
