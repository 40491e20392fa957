// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify_options.h"

#include <array>

#include "cli/arguments.h"
#include "cli/facet_list.h"
#include "cli/idle_options.h"
#include "endmill/core/text.h"
#include "endmill/deviation/deviation.h"

namespace endmill {
namespace {

constexpr std::array inaccessible_words{
    Choice<InaccessibleStock>{inaccessible_names[0], InaccessibleStock::Count},
    Choice<InaccessibleStock>{inaccessible_names[1], InaccessibleStock::Report}};

constexpr std::array engine_words{
    Choice<RemovalEngine>{"three-axis", RemovalEngine::ThreeAxis},
    Choice<RemovalEngine>{"five-axis", RemovalEngine::FiveAxis}};

// Largest number of halvings. Smaller cells would be below the rounding of any file.
constexpr int most_refine = 20;

void add_measure_options(CLI::App& command, VerifyOptions& options)
{
    const NumberDomain length = NumberDomain::of_machine();
    add_number(
        command,
        {"--resolution", "MM",
         "cell size of the stock and distance of the initial measuring rays", length},
        options.resolution);
    add_number(command,
               {"--tolerance", "MM",
                "largest gouge depth (default: the path's inner tolerance, or " +
                    to_text(DeviationLimits{}.tolerance) + ")",
                length},
               options.tolerance);
    add_number(command,
               {"--scallop", "MM",
                "largest remaining stock (default: the path's scallop height plus its "
                "outer tolerance, or " +
                    to_text(DeviationLimits{}.scallop) + ")",
                length},
               options.scallop);
    add_choice<InaccessibleStock>(
        command, "--inaccessible", options.inaccessible, inaccessible_words,
        "remaining stock where the cutter cannot touch a mesh, as in sharp corners: "
        "count it as elsewhere, or only report it (default: that of the path's summary, "
        "or count)");
    add_whole_number(
        command,
        {"--max-refine",
         "how often a cell may be halved while the verdict is undecided (default 8)", 0,
         most_refine},
        [&options](int halvings) { options.max_refine = halvings; });
}

}  // namespace

void add_verify_options(CLI::App& command, VerifyOptions& options)
{
    add_path_options(command, options.path);
    command
        .add_option(
            "--part", options.part.path,
            "surface, mesh or CAD file to compare with, or the word none (default: the "
            "part that the path was planned for)")
        ->type_name("FILE");
    command
        .add_option("--protect", options.guard,
                    "another surface or mesh that the path must not enter, or the word "
                    "none; --units and --up apply to it as to the part (default: that of "
                    "the path's summary). For a single ball")
        ->type_name("FILE");
    add_skip_facets_option(command, options.skip_facets,
                           "their remaining stock is not judged, but their gouges are; "
                           "or the word none (default: that of the path's summary)");
    add_mesh_options(command, options.part);
    command
        .add_option("--tool", options.tool,
                    "tool file: the cutter, and the shank and holder, which must touch "
                    "neither stock nor part")
        ->type_name("FILE");
    add_tools_options(command, options.path);
    command
        .add_option(
            "--stock", options.stock,
            std::string{stock_help} + "; also the stock.dexels of a run of five axes")
        ->type_name("STOCK");
    add_measure_options(command, options);
    add_choice<RemovalEngine>(command, "--engine", options.engine, engine_words,
                              "simulation by heights along a fixed axis, or by rays in "
                              "three directions for any "
                              "motion (default: five-axis if the tool axis turns)");
    add_reading_options(command, options.path);
    add_rotary_options(command, options.path.rotary);
    command.add_flag("--engagement", options.engagement,
                     "write engagement.csv: the engaged region of the cutter in each "
                     "move");
    command.add_flag("--write-stock", options.write_stock,
                     "write the remaining stock for a later --stock: stock.vti, or "
                     "stock.dexels with five axes");
    command.add_flag("--write-mesh", options.write_mesh,
                     "write the remaining stock as the mesh rest.stl");
    add_html_option(command, options.common);
    add_common_options(command, options.common);
}

void refuse_options_without_part(const CommonOptions& options)
{
    refuse_idle_options(options,
                        std::array{"--tolerance", "--scallop", "--max-refine",
                                   "--inaccessible", "--skip-facets"},
                        "no part", "--part, to compare with");
}

void refuse_idle_mesh_options(const CommonOptions& options)
{
    refuse_idle_options(options, std::array{"--units", "--up"}, "no mesh",
                        "a mesh as --part or --stock");
}

}  // namespace endmill
