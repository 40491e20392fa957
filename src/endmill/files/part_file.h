// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "endmill/files/mesh_file.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/surface/part.h"

/// \file
/// The part of a machining task, read from a surface file or from a mesh file.

namespace endmill {

/// A part, and a report of every change to the content of its file.
struct PartFile {
    std::string name;    ///< name in the file, or the file's stem
    std::string source;  ///< origin of the numbers; empty if the file does not state it
    Part part;           ///< lengths in mm
    /// Indices, from 0 and rising, of the degenerate triangles of a mesh file that were
    /// left out; empty for a surface file.
    std::vector<std::size_t> degenerate_triangles;
    std::size_t welded_points;  ///< merged points of a mesh file; 0 for a surface file
    /// `mesh_report` of the mesh; nothing for a surface.
    std::optional<MeshReport> mesh_report;
    /// One sentence for each change and each peculiarity.
    std::vector<std::string> notes;
    /// For each triangle of a mesh the number of its face of a CAD model, from 1; empty if it
    /// has none.
    std::vector<std::int32_t> face_numbers = {};
};

/// Reads a surface file if the content is JSON or the extension is .json (in either
/// case), else a mesh file. In a mesh, `oriented` reverses triangles whose orientation
/// contradicts that of their neighbours, and closed pieces that are oriented inwards. A
/// note states how many triangles it reversed and how many pieces cannot be oriented.
/// \throws FormatError, LimitError as `read_surface` and `read_mesh`; LimitError also if
///         the orientation needs more memory than the limit.
/// \throws DomainError if `options` give units or an upward axis for a surface file,
///         which states its own unit.
PartFile read_part(const std::filesystem::path& path,
                   const MeshReadOptions& options = {});

/// The part that a mesh is, oriented as by `read_part`.
/// \param mesh   in mm. \param path of its file, for messages.
/// \throws LimitError if the orientation needs more memory than the limit.
PartFile part_of_mesh(MeshFile mesh, const std::filesystem::path& path,
                      const ReadLimits& limits = {});

}  // namespace endmill
