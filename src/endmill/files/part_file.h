// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "endmill/files/mesh_file.h"
#include "endmill/surface/part.h"

namespace endmill {

/// A part and what its file says about it.
struct PartFile {
    std::string name;    ///< the file's, or else its path without folder and extension
    std::string source;  ///< where the numbers come from; empty if the file is silent
    Part part;           ///< in mm
    /// Of a mesh: numbers, rising from 0, of those left out when it was read.
    std::vector<std::size_t> degenerate_triangles;
    std::size_t welded_points;       ///< of a mesh, that were others' equal
    std::vector<std::string> notes;  ///< what a reader should know
};

/// Reads a surface file, told by its content or the extension .json, in capitals or not;
/// or else a mesh file. Pieces of a mesh that are turned over, or of which triangles are,
/// are put right (`oriented`); a note says so, and how many have one side only.
/// \throws FormatError, LimitError as `read_surface` and `read_mesh`; LimitError also if
/// putting right needs more memory than the limit.
/// \throws DomainError if units or an upward axis are given for a surface, whose file
/// speaks for itself.
PartFile read_part(const std::filesystem::path& path,
                   const MeshReadOptions& options = {});

}  // namespace endmill
