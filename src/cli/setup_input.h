// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/setup_machine.h"
#include "cli/setup_options.h"
#include "endmill/cutter/tool.h"
#include "endmill/files/visibility_file.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/sphere_grid.h"

namespace endmill {

/// The input of `endmill setup`.
struct SetupInput {
    std::string name;                  ///< name of the part
    std::string source;                ///< source of the part's numbers
    TriangleMesh mesh;                 ///< in mm
    std::vector<std::string> notes;    ///< printed before, or not worth a warning
    std::vector<std::string> remarks;  ///< further remarks, not printed yet
    std::vector<std::size_t> skipped;  ///< facets that need not be accessible; ascending
    SphereGrid grid;
    std::optional<StoredVisibility> known_visibility;  ///< of --from-visibility
    std::vector<SearchedMachine>
        machines;              ///< one machine, or all of a folder sorted by name
    std::optional<Tool> tool;  ///< its body must stay clear of the part
};

/// A text that identifies the body of a tool: its cylinders, in mm. Empty without a body.
std::string body_text(const std::optional<Tool>& tool);

/// Reads all files that the options of `endmill setup` name. A surface is sampled as a
/// mesh.
/// \throws FormatError, LimitError, DomainError as the readers; DomainError if --sphere
///         is not a grid; LimitError if the visibility needs more than --max-memory.
SetupInput read_setup_input(const SetupCommandOptions& options);

}  // namespace endmill
