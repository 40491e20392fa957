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

/// What a setup is looked for with.
struct SetupInput {
    std::string name;                  ///< of the part
    std::string source;                ///< of its numbers
    TriangleMesh mesh;                 ///< in mm
    std::vector<std::string> notes;    ///< of its reader, who has warned of them
    std::vector<std::string> remarks;  ///< beside them
    SphereGrid grid;
    std::optional<StoredVisibility> known_visibility;  ///< of --from-visibility
    std::vector<SetupMachine> machines;  ///< one, or all of a folder by name
    std::optional<Tool> tool;  ///< that must be clear of the part, and gives the length
};

/// What tells the body of a tool from another: its cylinders, in mm; empty without one.
std::string body_text(const std::optional<Tool>& tool);

/// Reads all files that the options of `endmill setup` name. A surface is sampled.
/// \throws FormatError, LimitError, DomainError as the readers; DomainError for a grid that is
///         none; LimitError if the visibility does not fit --max-memory.
SetupInput read_setup_input(const SetupCommandOptions& options);

}  // namespace endmill
