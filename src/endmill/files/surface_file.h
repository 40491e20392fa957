// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/read_file.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A surface and what its file says about it.
struct SurfaceFile {
    std::string name;    ///< the file's, or else its path without folder and extension
    std::string source;  ///< where the numbers come from; empty if the file is silent
    std::vector<Surface> surfaces;  ///< in mm; one, but for the type "bezier-patches"
    std::vector<std::string>
        notes;  ///< what a reader should know: a unit converted, a pole
};

/// Reads a file of format "endmill-surface/1"; every key of the format is checked, and
/// `name` and `source` come out as `printable` makes them.
/// \throws FormatError as `read_file` and `JsonDocument`, and
///         E_FORMAT if the content is something else;
///         E_JSON for a wrong type, a missing or unknown key, a count outside 1 … 10000
///         or a newer version of the format; E_RANGE for a coordinate beyond the limit,
///         after conversion to mm; E_SURFACE for rows of the wrong number or length, a
///         degree outside 1 … 25, unsound knots or grid lines, a weight that is not above
///         zero, and a net that is one point.
/// \throws LimitError if the file needs more memory than the limit.
SurfaceFile read_surface(const std::filesystem::path& path,
                         const ReadLimits& limits = {});

/// The same from `content`; `path` serves for messages and for the name.
SurfaceFile parse_surface(std::string_view content, const std::filesystem::path& path,
                          const ReadLimits& limits = {});

/// The text of a file of type "bezier" from which `read_surface` gets the same doubles
/// (minus zero excepted, which becomes zero). The notes are left out.
/// \throws DomainError unless the breaks are 0, 1, 2, …, and the patches are bicubic,
/// without weights, and share the control points of their borders.
std::string surface_json(const SurfaceFile& file);

}  // namespace endmill
