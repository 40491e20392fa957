// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>

#include "endmill/figures/axonometric_figure.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/part.h"
#include "endmill/surface/surface.h"

/// \file
/// Figures of a tool path, of a surface, and of a density on a part. Implemented in
/// `tool_path_svg.cpp`, `surface_svg.cpp` and `density_svg.cpp`.

namespace endmill {

/// A tool path in parallel projection, as an SVG file: contact points (tips where there
/// is no contact) joined in the order of the path. Links have another colour; rapids,
/// plunges and retracts are dashed. A disc marks the first point, and arrows mark the
/// direction of a few cuts. If the tool axis turns, short lines show it at some cuts. Axes
/// with ticks are in mm.
/// Source: after [KimChoi, figs. 12 and 13].
/// \param path the path. \param options title, captions, size and view.
/// \param part surfaces that are drawn shaded under the path.
/// \throws DomainError if the path has no points or one that is not finite.
std::string tool_path_svg(const ToolPath& path, const FigureOptions& options = {},
                          std::span<const Surface> part = {});

/// What a figure of a path shows beside the path.
struct PathDrawing {
    const Part* part = nullptr;  ///< drawn shaded under the path; null: none
    /// For each point of the path, how much of its strip the cut to it uses, see strip_use
    /// of the module strategy. Cuts are coloured by it; without it all have one colour.
    std::span<const double> strip_use = {};
};

/// The same figure with any part, and with cuts coloured by their use of the strip in five
/// classes: below 25, 50, 75 and 100 per cent, and above.
/// \throws DomainError also unless there is a strip use for each point, or none at all.
std::string tool_path_svg(const ToolPath& path, const FigureOptions& options,
                          const PathDrawing& drawing);

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

/// A cell of a part with a density.
struct DensityPiece {
    std::array<Vec3, 4> corners;  ///< in order around the cell, mm
    double density_per_mm;        ///< 1/mm, mean over the cell
};

/// A density on a part in parallel projection, as an SVG file: cells coloured in five
/// classes of about as many cells each. Nearer cells cover farther ones.
/// \throws DomainError if there are no cells, and unless every number is finite.
std::string density_svg(std::span<const DensityPiece> pieces,
                        const FigureOptions& options = {});

}  // namespace endmill
