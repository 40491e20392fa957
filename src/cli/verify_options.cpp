// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify_options.h"

#include "cli/arguments.h"

namespace endmill {
namespace {

// Finer cells than these would be below the rounding of any file.
constexpr int most_refine = 20;

void add_measure_options(CLI::App& command, VerifyOptions& options)
{
    add_number(command,
               {"--resolution", "MM", "pitch of the stock and of the first rays",
                NumberDomain::of_machine()},
               options.resolution);
    add_number(command,
               {"--tolerance", "MM",
                "deepest gouge; default the path's inner tolerance, or 0.01",
                NumberDomain::of_machine()},
               options.tolerance);
    add_number(command,
               {"--scallop", "MM",
                "highest rest of material; default the path's scallop and outer "
                "tolerance, or 0.1",
                NumberDomain::of_machine()},
               options.scallop);
    add_whole_number(command,
                     {"--max-refine", "halvings of a cell that is in doubt; default 8", 0,
                      most_refine},
                     [&options](int halvings) { options.max_refine = halvings; });
}

}  // namespace

void add_verify_options(CLI::App& command, VerifyOptions& options)
{
    add_path_options(command, options.path);
    command
        .add_option("--part", options.part.path,
                    "surface or mesh to judge by, or none; default the one that the "
                    "path was planned for")
        ->type_name("FILE");
    add_mesh_options(command, options.part);
    command
        .add_option("--tool", options.tool,
                    "tool file: its cutter, and a shank and holder that must stay clear")
        ->type_name("FILE");
    command
        .add_option("--stock", options.stock,
                    "block (default: around the part), X0,Y0,Z0,X1,Y1,Z1, a closed mesh, "
                    "or the stock.vti of an earlier run")
        ->type_name("STOCK");
    add_measure_options(command, options);
    add_reading_options(command, options.path);
    command.add_flag("--engagement", options.engagement,
                     "write which part of the cutter is in the material, move by move");
    command.add_flag("--write-stock", options.write_stock,
                     "write what is left as stock.vti, for a later --stock");
    command.add_flag("--write-mesh", options.write_mesh,
                     "write what is left as rest.stl, to look at");
    add_common_options(command, options.common);
}

}  // namespace endmill
