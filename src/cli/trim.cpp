// SPDX-License-Identifier: GPL-3.0-or-later
// endmill trim: sections of an offset, their loops cut out.

#include <memory>

#include "cli/console.h"
#include "cli/trim_files.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/trimming/trimmed_planes.h"

namespace endmill {
namespace {

// What a mesh can be trimmed by: its curves come from the drop cutter.
constexpr std::string_view mesh_method = "envelope";
constexpr const char* needs_surface = "it needs a surface, whose normals give an offset";

// What decides the exit status.
bool is_good(const TrimResult& result, const TrimOptions& options)
{
    return unresolved(result) == 0 && max_gouge(result).value_or(0) <= options.tolerance;
}

void check_figure(const TrimOptions& options, const TrimInput& input)
{
    require_option(!options.figure ||
                       static_cast<std::size_t>(*options.figure) < input.sections.size(),
                   "--figure " + std::to_string(options.figure.value_or(0)) +
                       ": expected a plane from 0 to " +
                       std::to_string(input.sections.size() - 1));
}

// Planes that miss the part, in a gap between its surfaces.
void warn_of_empty_planes(const TrimOptions& options, const TrimInput& input)
{
    const auto empty = std::ranges::count_if(
        input.sections, [](const PlaneSection& plane) { return plane.curves.empty(); });
    if (input.part && empty == std::ssize(input.sections))
        throw GeometryError{
            "no drive plane meets the part; expected other --planes, "
            "--pitch or --direction-deg"};
    if (input.part && empty > 0)
        warn(options.common, options.part.path + ": " +
                                 counted(static_cast<std::size_t>(empty), "drive plane") +
                                 " of " + std::to_string(input.sections.size()) +
                                 " miss the part");
}

struct Outcome {
    Json summary;
    std::string text;
    bool is_good = true;
};

Outcome trim_all(const TrimInput& input, const TrimOptions& options, OutputFolder& folder)
{
    Outcome outcome;
    // The first run pays for the start of the threads and for what is read first.
    if (!input.drop_cutter)
        trim_planes(input.sections, input.ranges, trimming_methods().front(),
                    trimming_options(options, 1));
    for (const TrimmingMethod& method : trimming_methods()) {
        if (input.drop_cutter && method.name != mesh_method) {
            outcome.text += "method " + std::string{method.name} + ": not run, " +
                            needs_surface + "\n";
            outcome.summary["not_run"].push_back(method.name);
            continue;
        }
        const TrimResult result = trim_by(method, input, options);
        const std::string prefix = std::string{method.name} + "/";
        Json summary = write_trimmed(result, input, options, folder, prefix);
        outcome.text += trim_text(summary);
        if (method.name == "envelope")
            outcome.is_good = is_good(result, options);
        outcome.summary["methods"][std::string{method.name}] = std::move(summary);
    }
    if (!input.drop_cutter)
        outcome.text += methods_text(outcome.summary["methods"]);
    folder.write("summary.json", outcome.summary.dump(2) + "\n");
    return outcome;
}

Outcome trim_with(const TrimmingMethod& method, const TrimInput& input,
                  const TrimOptions& options, OutputFolder& folder)
{
    const TrimResult result = trim_by(method, input, options);
    Json summary = write_trimmed(result, input, options, folder, "");
    std::string text = trim_text(summary);
    return {std::move(summary), std::move(text), is_good(result, options)};
}

ExitCode run_trim(const TrimOptions& options)
{
    check_trim_options(options);
    const TrimInput input = read_trim_input(options);
    check_figure(options, input);
    warn_of_empty_planes(options, input);
    const std::string name = method_name(options);
    require_option(
        !input.drop_cutter || name == mesh_method || name == "all",
        "--method " + name + ": " + needs_surface + "; for a mesh expected envelope");
    OutputFolder folder{output_folder(input.file, "trim", options.common),
                        options.common.force};
    folder.protect(input.file);
    write_sections(input, folder);
    const auto methods = trimming_methods();
    const auto method = std::ranges::find(methods, name, &TrimmingMethod::name);
    const Outcome outcome = method == methods.end()
                                ? trim_all(input, options, folder)
                                : trim_with(*method, input, options, folder);
    folder.publish();
    print_result(options.common, outcome.summary,
                 outcome.text + "written to " + printable(folder.path().string()) + "\n");
    return outcome.is_good ? ExitCode::Yes : ExitCode::No;
}

}  // namespace

void add_trim_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "trim", "sections of an offset by drive planes, their loops cut out");
    const auto options = std::make_shared<TrimOptions>();
    add_trim_options(*command, *options);
    command->footer(
        "Writes sections.csv (before) and trimmed.csv (after), both reference points,\n"
        "loops.csv, toolpath.csv (tips) and summary.json to --output (default\n"
        "./NAME-trim); --method all to a folder for each method. Exits 1 if the path\n"
        "gouges by more than --tolerance or a fold is left; --method all is judged on\n"
        "envelope.\n\n"
        "Example:\n  endmill trim datasets/surfaces/valley.json --cutter ball:20 "
        "--method all\n  endmill verify valley-trim/envelope/toolpath.csv");
    command->callback([options, &action] {
        action = [options] {
            try {
                return run_trim(*options);
            } catch (const GeometryError& error) {
                throw GeometryError{
                    (options->polyline.empty() ? options->part.path : options->polyline) +
                    ": " + error.what()};
            }
        };
    });
}

}  // namespace endmill
