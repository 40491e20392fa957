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

namespace endmill {

/// A visibility map with all that it depends on.
struct StoredVisibility {
    std::string grid;  ///< as `sphere_grid` reads it
    Angle incidence = Angle::degrees(90);
    VisibilityKind kind = VisibilityKind::Global;
    std::string tool;                 ///< whose body must pass, as given; empty: none
    std::uint64_t part_checksum = 0;  ///< see `part_checksum`
    PartVisibility visibility;
};

/// A number that tells parts apart: of the points' coordinates and the triangles, in their
/// order. A change of any one coordinate or corner changes it; parts at random share it once
/// in 2^64 pairs.
std::uint64_t part_checksum(const TriangleMesh& part);

/// Writes the file to `sink`, piece by piece. Little-endian, in this order:
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
///     uint64   ceil(n / 64) for each cell: bit j % 64 of word j / 64 is 0 where facet j is
///              accessible, as in [KangSuh], and 0 beyond the last facet
///     uint64   checksum of all before
///
/// \throws DomainError if the grid's name is none or has another number of cells, or the
///         tool's is longer than 1000 bytes.
void write_visibility(const StoredVisibility& stored, const OutputFolder::Sink& sink);

/// The number that stands at the end of a file for all before. A change of any one word of 8
/// bytes changes it. \throws DomainError unless there is a multiple of 8 bytes.
std::uint64_t visibility_checksum(std::string_view bytes);

/// Reads what `write_visibility` writes. \param file the name for messages.
/// \throws FormatError E_BSM with the byte for a damaged or truncated file, one of a newer
///         version, or a header that contradicts itself or the file's length.
/// \throws LimitError if it needs more memory than the limit.
StoredVisibility parse_visibility(std::string_view content, const std::string& file,
                                  const ReadLimits& limits = {});

/// The same from a file, which must be of this part.
/// \throws FormatError also as `read_file`, and if it is another part's.
StoredVisibility read_visibility(const std::filesystem::path& path,
                                 const TriangleMesh& part, const ReadLimits& limits = {});

}  // namespace endmill
