// SPDX-License-Identifier: GPL-3.0-or-later
// endmill trim: slices an offset and removes the loops of its sections.

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/idle_options.h"
#include "cli/memory_limit.h"
#include "cli/program_ranks.h"
#include "cli/shown_numbers.h"
#include "cli/trim_comparison.h"
#include "cli/trim_files.h"
#include "cli/trim_ranks.h"
#include "cli/view.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/trimming/trimmed_planes.h"

namespace endmill {
namespace {

// The only method for a mesh. Its curves come from the drop cutter.
constexpr std::string_view mesh_method = "envelope";
constexpr const char* needs_surface = "it needs a surface, whose normals give an offset";

// A choice of options that would improve the path.
std::string better_choice(const TrimInput& input, const TrimResult& result,
                          const TrimOptions& options)
{
    if (input.dropped_part())
        return "a finer --grid or a smaller --tolerance gives the path more points";
    if (result.method != "envelope" && result.method != "winding")
        return "--method envelope leaves no folds";
    if (boundary_contact(options) == BoundaryContact::None)
        return "--boundary contact keeps the cutter off borders and creases";
    if (options.offset)
        return "--method winding follows closed curves too";
    return options.refine
               ? "a finer --grid samples the offset more closely"
               : "--refine moves the points onto the exact offset, and a finer "
                 "--grid samples it more closely";
}

// The planes that keep folds: how many, and the first.
std::string planes_with_folds(const TrimResult& result)
{
    std::size_t count = 0;
    std::size_t first = 0;
    for (std::size_t k = result.trimmed.size(); k-- > 0;)
        if (result.trimmed[k].unresolved > 0) {
            ++count;
            first = k;
        }
    return (count == 1 ? "plane " : counted(count, "plane") + ", the first ") +
           std::to_string(first);
}

// The fault of the path, if it gouges deeper than the tolerance or keeps folds.
std::optional<std::string> fault_of(const TrimInput& input, const TrimResult& result,
                                    const TrimOptions& options)
{
    const double gouge = max_gouge(result).value_or(0);
    const std::size_t folds = unresolved(result);
    if (gouge <= options.tolerance && folds == 0)
        return std::nullopt;
    std::string text = "the path fails: method " + result.method + " with --mode " +
                       std::string{mode_word(options.mode)};
    if (gouge > options.tolerance)
        text += " gouges the part " + shown_against(gouge, options.tolerance) +
                " mm deep, beyond --tolerance " + to_text(options.tolerance) + " mm" +
                (result.nearest ? ", in " + *result.nearest : "");
    if (folds > 0)
        text += (gouge > options.tolerance ? ", and leaves " : " leaves ") +
                counted(folds, "fold") +
                (input.sections.size() > 1 ? " in " + planes_with_folds(result) : "");
    return text + "; " + better_choice(input, result, options);
}

void check_figure(const TrimOptions& options, const TrimInput& input)
{
    require_option(!options.figure ||
                       static_cast<std::size_t>(*options.figure) < input.sections.size(),
                   "--figure " + std::to_string(options.figure.value_or(0)) +
                       ": expected a plane from 0 to " +
                       std::to_string(input.sections.size() - 1));
}

// Warns of planes that miss the part, as in a gap between its surfaces.
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
    std::optional<std::string> fault = {};  // the reason for exit code 1
};

// Adds the comparison of all methods to `outcome` and writes its files. The time that the
// summary of a method states is then the median of its runs.
void add_comparison(std::span<const MethodRuns> runs, const TrimInput& input,
                    const TrimOptions& options, OutputFolder& folder, Outcome& outcome)
{
    if (runs.empty())
        return;
    Json comparison = comparison_summary(runs, input, options);
    outcome.text += "\n" + comparison_text(comparison, options);
    outcome.summary["comparison"] = std::move(comparison);
    write_comparison(runs, input, options, folder);
    if (options.figure) {
        const auto plane = static_cast<std::size_t>(*options.figure);
        folder.write(fmt::format("methods-{}.svg", plane),
                     compared_picture(runs, input, options, plane));
    }
}

Outcome trim_all(const TrimInput& input, const TrimOptions& options,
                 std::span<const MethodRuns> runs, OutputFolder& folder)
{
    Outcome outcome;
    // Run once without timing: the first run also starts the threads and fills the
    // caches.
    if (!input.dropped_part())
        trimmed_sections(input, trimming_methods().front(), trimming_options(options, 1));
    for (const TrimmingMethod& method : trimming_methods()) {
        if (input.dropped_part() && method.name != mesh_method) {
            outcome.text += "method " + std::string{method.name} + ": not run, " +
                            needs_surface + "\n";
            outcome.summary["not_run"].push_back(method.name);
            continue;
        }
        TrimResult result = trim_by(method, input, options);
        if (options.repeat)
            result.trim_ms =
                time_spread(
                    std::ranges::find(runs, method.name, &MethodRuns::name)->times_ms)
                    .median;
        const std::string prefix = std::string{method.name} + "/";
        Json summary = write_trimmed(result, input, options, folder, prefix);
        if (input.dropped_part())
            outcome.text += trim_text(summary);
        if (method.name == "envelope")
            outcome.fault = fault_of(input, result, options);
        outcome.summary["methods"][std::string{method.name}] = std::move(summary);
    }
    if (!input.dropped_part())
        outcome.text += methods_text(outcome.summary["methods"]);
    add_comparison(runs, input, options, folder, outcome);
    folder.write("summary.json", outcome.summary.dump(2) + "\n");
    return outcome;
}

// Writes the comparison of the methods alone.
Outcome compare_only(const TrimInput& input, const TrimOptions& options,
                     std::span<const MethodRuns> runs, OutputFolder& folder)
{
    Outcome outcome;
    outcome.summary = {{"name", input.name},
                       {"source", input.source},
                       {"endmill", program_version},
                       {"planes", input.sections.size()}};
    add_settings(outcome.summary, options,
                 trimming_options(options, section_height(input.sections)));
    add_comparison(runs, input, options, folder, outcome);
    folder.write("summary.json", outcome.summary.dump(2) + "\n");
    return outcome;
}

Outcome trim_with(const TrimmingMethod& method, const TrimInput& input,
                  const TrimOptions& options, std::span<const MethodRuns> runs,
                  OutputFolder& folder)
{
    const TrimResult result = trim_by(method, input, options);
    Outcome outcome;
    outcome.summary = write_trimmed(result, input, options, folder, "");
    outcome.text = trim_text(outcome.summary);
    outcome.fault = fault_of(input, result, options);
    add_comparison(runs, input, options, folder, outcome);
    folder.write("summary.json", outcome.summary.dump(2) + "\n");
    return outcome;
}

// Refuses options that need several methods, or a search of sections, for a mesh.
void check_mesh_options(const TrimOptions& options, const std::string& method)
{
    require_option(
        method == mesh_method || method == "all",
        "--method " + method + ": " + needs_surface + "; for a mesh expected envelope");
    refuse_idle_options(options.common,
                        std::array{"--detection", "--m1-step", "--m1-threshold", "--m3",
                                   "--repeat", "--compare-only"},
                        "a mesh", "a surface: method envelope alone trims a mesh");
    require_option(
        !options.figure_worst,
        "--figure worst: one method alone trims a mesh; expected the number of "
        "a plane");
}

// The options with the plane to draw: the one in which the methods differ most, or the
// only one of a file of profiles.
TrimOptions with_chosen_plane(TrimOptions options, std::span<const MethodRuns> runs)
{
    if (options.figure_worst)
        options.figure = static_cast<int>(worst_plane(runs));
    else if (options.offset && !options.figure)
        options.figure = 0;
    return options;
}

// Trims by the selected method or methods and writes the results.
Outcome trim_as_selected(const TrimInput& input, const TrimOptions& options,
                         std::span<const MethodRuns> runs, OutputFolder& folder)
{
    if (!options.compare_only.empty())
        return compare_only(input, options, runs, folder);
    write_sections(input, options, folder);
    const auto methods = trimming_methods();
    const auto method =
        std::ranges::find(methods, method_name(options), &TrimmingMethod::name);
    if (method == methods.end())
        return trim_all(input, options, runs, folder);
    return trim_with(*method, input, options, runs, folder);
}

ExitCode run_trim(const TrimOptions& given)
{
    check_trim_options(given);
    if (program_ranks().rank() > 0) {
        serve_trimming(given);
        return ExitCode::Yes;
    }
    // The arcs of the offset around borders have the radius of the cutter with the allowance.
    if (given.cutter && given.allowance > given.cutter->radius())
        advise_less_memory("a smaller --allowance needs less");
    const TrimInput input = read_trim_input(given);
    check_figure(given, input);
    warn_of_empty_planes(given, input);
    const std::string name = method_name(given);
    if (input.dropped_part())
        check_mesh_options(given, name);
    std::vector<MethodRuns> runs;
    if (given.repeat || given.figure_worst)
        runs = run_methods(input, given);
    const TrimOptions options = with_chosen_plane(given, runs);
    OutputFolder folder{output_folder(input.file, "trim", options.common),
                        options.common.full_folder};
    folder.protect(input.file);
    const Outcome outcome = trim_as_selected(input, options, runs, folder);
    folder.remove_unless_written("page.html");
    folder.publish();
    write_html(folder.path(), options.common);
    print_result(options.common, outcome.summary,
                 outcome.text + "written to " + printable(folder.path().string()) + "\n");
    if (!outcome.fault)
        return ExitCode::Yes;
    report_error("E_GOUGE", input.file + ": " + *outcome.fault, ExitCode::No,
                 options.common.json_errors);
    return ExitCode::No;
}

}  // namespace

void add_trim_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "trim", "cut an offset by drive planes and remove the loops of the sections");
    const auto options = std::make_shared<TrimOptions>();
    add_trim_options(*command, *options);
    command->footer(
        "Writes sections.csv (before), trimmed.csv (after), loops.csv (removed pieces),\n"
        "toolpath.csv (tips) and summary.json to --output (default ./NAME-trim); "
        "--method\n"
        "all writes a folder for each method. Sections hold reference points.\n"
        "--repeat adds times.csv and comparison.svg; --repeat and --figure worst add\n"
        "differences.csv, the distance of each method's curves from the exact ones, and\n"
        "methods-N.svg with the curves of all methods in the drawn plane N. "
        "--compare-only\n"
        "writes the files of --repeat and summary.json only, and exits with 0. Times "
        "are\n"
        "measured and vary; everything else is the same in every run.\n\n"
        "With --explain, the column rule of loops.csv names the rule that removed a "
        "piece:\n"
        "  below the envelope  it lies below the upper envelope of the section\n"
        "  winding number      the cutter would be inside the part (method winding)\n"
        "  valley              a loop behind a self-intersection\n"
        "  E1, E2              a tail at the end (E1) or at the beginning (E2) of a "
        "curve\n"
        "  E3                  a branch that ends before it can meet its neighbour\n"
        "  P3, P4              a loop found by the signs of dz (--detection literal)\n"
        "  P3 cut, P4 cut      the same signs, but no self-intersection was found\n"
        "  closed              a closed curve below the others\n"
        "  outside the range   beyond the part\n\n"
        "Exit 1: the path gouges deeper than --tolerance, or a fold remains. With "
        "--method\n"
        "all the exit code is that of method envelope.\n\n"
        "mpirun -n N endmill trim --polyline FILE ... divides the curves among N "
        "processes.\n"
        "--repeat, --compare-only and --figure worst compare the methods in one of "
        "them.\n\n"
        "Example:\n"
        "  endmill trim datasets/surfaces/valley.json --cutter ball:20 --method all "
        "--repeat 5 --figure worst\n"
        "  endmill verify valley-trim/envelope/toolpath.csv --resolution 0.5 --scallop "
        "2");
    command->callback([options, &action] {
        action = [options] {
            const std::string& file =
                options->polyline.empty() ? options->part.path : options->polyline;
            return naming(file, [&] { return run_trim(*options); });
        };
    });
}

}  // namespace endmill
