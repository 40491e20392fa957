// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "endmill/core/angle.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/read_file.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/visibility.h"

/// \file
/// Visibility files (.bsm): a visibility map and all inputs of its computation. A later
/// run can use the map instead of computing it again.

namespace endmill {

/// A visibility map and the inputs that it depends on.
struct StoredVisibility {
    std::string grid;  ///< name of the grid, as `sphere_grid` reads it
    Angle incidence = Angle::degrees(90);  ///< largest angle between tool axis and normal
    VisibilityKind kind = VisibilityKind::Global;  ///< local or global
    std::string tool;  ///< word of the tool whose body was tested; empty: none
    std::uint64_t part_checksum = 0;  ///< of the part, see `part_checksum`
    PartVisibility visibility;        ///< the map and the facets without area
};

/// Checksum of a part: of the coordinates of the points and the triangles, in order. A
/// change of one coordinate or one corner always changes it; two different parts have
/// equal checksums with a probability of about 2^-64.
std::uint64_t part_checksum(const TriangleMesh& part);

/// Writes the file to `sink`, piece by piece. Numbers are little-endian, in this order:
///
///     8 bytes  "EMILLBSM"
///     uint32   version, 1
///     uint32   0 local, 1 global
///     uint64   n, facets                uint64   m, cells
///     float64  incidence in rad         uint64   checksum of the part
///     uint32   bytes of the grid's name uint32   bytes of the tool's
///     uint32   facets without area      uint32   0
///     the grid's name and the tool's, then zeros to a multiple of 8 bytes
///     uint32   each facet without area, rising; then zeros to a multiple of 8 bytes
///     uint64   ceil(n / 64) for each cell: bit j % 64 of word j / 64 is 0 where facet
///              j is accessible, as in [KangSuh], and 0 beyond the last facet
///     uint64   checksum of all preceding bytes (`visibility_checksum`)
///
/// \throws DomainError if the grid's name is invalid or has another number of cells, or
///         if the tool's name is longer than 1000 bytes.
void write_visibility(const StoredVisibility& stored, const OutputFolder::Sink& sink);

/// Checksum of the content of a visibility file: of its 64-bit words in order. A change
/// of any one word changes it. It detects damage; it is not cryptographic.
/// \throws DomainError unless the number of bytes is a multiple of 8.
std::uint64_t visibility_checksum(std::string_view bytes);

/// Parses the content of a file that `write_visibility` wrote.
/// \param file name of the file for messages.
/// \throws FormatError E_BSM with the byte for a damaged or truncated file, a newer
///         version, or a header that contradicts itself or the length of the file.
/// \throws LimitError if it needs more memory than the limit.
StoredVisibility parse_visibility(std::string_view content, const std::string& file,
                                  const ReadLimits& limits = {});

/// Reads the visibility of `part` from a file.
/// \throws FormatError, LimitError as `read_file` and `parse_visibility`; FormatError
///         E_BSM also if the file is of another part.
StoredVisibility read_visibility(const std::filesystem::path& path,
                                 const TriangleMesh& part, const ReadLimits& limits = {});

}  // namespace endmill
