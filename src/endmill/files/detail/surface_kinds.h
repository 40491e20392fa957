// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/files/detail/control_net.h"
#include "endmill/files/detail/strict_json.h"
#include "endmill/files/read_file.h"
#include "endmill/surface/surface.h"

/// \file
/// Readers of the four types of surface files, one function for each.

namespace endmill {

/// A surface file whose format, type and keys have been checked.
struct SurfaceSource {
    const JsonValue& root;     ///< of the document
    LengthRule lengths;        ///< unit of the file and the limit on coordinates
    ToolSide tool_side;        ///< of all its surfaces
    const std::string& file;   ///< name of the file for messages
    const ReadLimits& limits;  ///< on memory
};

/// The surface of type "bezier": a composite bicubic control net.
/// \throws FormatError and LimitError as `read_surface`; so do the functions below.
std::vector<Surface> read_bezier(const SurfaceSource& source);

/// The surface of type "nurbs".
std::vector<Surface> read_nurbs(const SurfaceSource& source);

/// The surfaces of type "bezier-patches", one for each patch, each over 0 … 1 by 0 … 1.
std::vector<Surface> read_bezier_patches(const SurfaceSource& source);

/// The surface of type "height-grid".
std::vector<Surface> read_height_grid(const SurfaceSource& source);

}  // namespace endmill
