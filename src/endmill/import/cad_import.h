// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "endmill/files/read_file.h"
#include "endmill/import/cad_part.h"

/// \file
/// Reading of STEP and IGES files by the program `endmill-cad`.

namespace endmill {

/// The CAD formats.
enum class CadFormat { Step, Iges };

/// The format by the extension of a file: .step, .stp, .iges or .igs, in either case.
/// \return nothing for another extension.
std::optional<CadFormat> cad_format(const std::filesystem::path& path);

/// How a CAD file is meshed, and the limits of the program that reads it.
struct CadImportOptions {
    /// Greatest distance of the mesh from the faces, from 1e-6 to 1e6.
    double chord_tolerance_mm = 0.01;
    double angle_deg =
        20;  ///< greatest angle between neighbouring chords, within 0 and 180
    std::size_t max_faces = 100000;  ///< a file with more faces is refused
    double limit_seconds = 60;       ///< of processor time, and of wall time
    double limit_gib = 4;            ///< address space of the program
    bool measures = false;           ///< whether `CadPart::measures` is asked for
};

/// Imports a CAD file: starts `endmill-cad` with an empty environment and the limits, with the
/// file as its standard input, and examines its answer.
/// \param program path of `endmill-cad`; empty if there is none.
/// \param file    a STEP or IGES file by its extension.
/// \throws DomainError if there is no program, or an option is out of its domain.
/// \throws FormatError as `read_file` and `parse_cad_stream`; E_CAD if the program refuses the
///         file or crashes on it.
/// \throws LimitError if the program reaches a limit, or is killed.
/// \throws OutputError if the program cannot be started.
CadPart import_cad(const std::filesystem::path& program,
                   const std::filesystem::path& file,
                   const CadImportOptions& options = {}, const ReadLimits& limits = {});

/// The same, with the answer kept in a folder. An answer that is there is used again if the
/// file, the options, the version and the build of `endmill-cad` are the same. A damaged one, by
/// its SHA-256, is made again. One that cannot be kept is used all the same.
/// \param cache   folder, made if it is missing; empty: nothing is kept.
/// \param version of the program that asks.
/// \throws as `import_cad`; FormatError E_CAD if the file changes meanwhile.
CadPart import_cad_with_cache(const std::filesystem::path& program,
                              const std::filesystem::path& file,
                              const std::filesystem::path& cache,
                              const std::string& version, const ReadLimits& limits = {});

}  // namespace endmill
