// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/command.h"
#include "endmill/import/cad_import.h"

namespace endmill {

/// The program `endmill-cad` beside this one; empty if it is not there.
std::filesystem::path cad_program();

/// Imports the CAD file that a command takes as its part. The answer is kept in the folder
/// .endmill-cad beside the output of the command, and used again while file and version are
/// the same.
/// \param keep whether it is kept.
/// \throws as `import_cad_with_cache`.
CadPart cad_part_for(const std::string& path, bool keep, const CommonOptions& options);

/// Adds the option --face, a list of face numbers from 1. \param help what the command does
/// with these faces.
void add_face_option(CLI::App& command, std::vector<int>& faces, const std::string& help);

}  // namespace endmill
