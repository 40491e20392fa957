// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/files/detail/strict_json.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A surface file whose format and keys are already checked.
struct SurfaceNumbers {
    const JsonValue& root;
    double unit;         ///< mm per unit of the file
    ToolSide tool_side;  ///< of all its surfaces
    const std::string& file;
    const ReadLimits& limits;
};

/// The surface of type "bezier": a composite bicubic net.
/// \throws FormatError and LimitError as `read_surface`; so do the functions below.
std::vector<Surface> read_bezier(const SurfaceNumbers& numbers);

/// The surface of type "nurbs".
std::vector<Surface> read_nurbs(const SurfaceNumbers& numbers);

/// The surfaces of type "bezier-patches", one a patch, each over 0 … 1 by 0 … 1.
std::vector<Surface> read_bezier_patches(const SurfaceNumbers& numbers);

/// The surface of type "height-grid".
std::vector<Surface> read_height_grid(const SurfaceNumbers& numbers);

}  // namespace endmill
