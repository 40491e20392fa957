// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/read_file.h"
#include "endmill/surface/nurbs.h"
#include "endmill/surface/surface.h"

/// \file
/// Surface files ("endmill-surface/1"): four types of free-form surface in JSON.

namespace endmill {

/// The surfaces of a file, and the notes of its reader.
struct SurfaceFile {
    std::string name;    ///< name in the file, or the file's stem
    std::string source;  ///< origin of the numbers; empty if the file does not state it
    std::vector<Surface> surfaces;  ///< in mm; several only for the type "bezier-patches"
    std::vector<std::string> notes;  ///< one sentence for a converted unit and each pole
};

/// Reads a file of format "endmill-surface/1" and checks every key. Texts of the file
/// (`name`, `source`) are made `printable`.
/// \throws FormatError as `read_file` and `JsonDocument`. E_FORMAT if the content is not
///         of this format; E_JSON for a wrong type, a missing or unknown key, a count
///         outside 1 … 10000, or a newer version of the format; E_RANGE for a coordinate
///         beyond the limit, after conversion to mm; E_SURFACE for rows of a wrong number
///         or length, a degree outside 1 … 25, invalid knots or grid lines, a weight that
///         is not positive, and a control net whose points are all equal.
/// \throws LimitError if the file needs more memory than the limit.
SurfaceFile read_surface(const std::filesystem::path& path,
                         const ReadLimits& limits = {});

/// Parses the content of a surface file as `read_surface` does.
/// \param path used in messages and for the default name.
SurfaceFile parse_surface(std::string_view content, const std::filesystem::path& path,
                          const ReadLimits& limits = {});

/// The content of a surface file of type "nurbs".
/// \param nurbs  with valid parameters and as many points as they require.
/// \param name   of the surface. \param source origin of the numbers.
std::string surface_text(const Nurbs& nurbs, ToolSide tool_side, const std::string& name,
                         const std::string& source);

}  // namespace endmill
