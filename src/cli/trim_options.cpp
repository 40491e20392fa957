// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trim_options.h"

#include <algorithm>
#include <array>
#include <vector>

#include "cli/arguments.h"
#include "cli/idle_options.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/trimming/trimmed_planes.h"
#include "endmill/trimming/trimming_methods.h"

namespace endmill {
namespace {

constexpr std::array modes{Choice<TrimMode>{"corrected", TrimMode::Corrected},
                           Choice<TrimMode>{"paper", TrimMode::Paper}};
constexpr std::array detections{Choice<FoldDetection>{"guarded", FoldDetection::Guarded},
                                Choice<FoldDetection>{"literal", FoldDetection::Literal}};
constexpr std::array searches{
    Choice<BranchSearch>{"march", BranchSearch::March},
    Choice<BranchSearch>{"scan", BranchSearch::Scan},
    Choice<BranchSearch>{"scan-to-end", BranchSearch::ScanToEnd}};
constexpr std::array boundaries{
    Choice<BoundaryContact>{"contact", BoundaryContact::Contact},
    Choice<BoundaryContact>{"none", BoundaryContact::None}};
constexpr std::array orders{Choice<PassOrder>{"zigzag", PassOrder::ZigZag},
                            Choice<PassOrder>{"one-way", PassOrder::OneWay}};

// Options of a part and its path, which --polyline excludes.
constexpr std::array part_options{
    "--units",         "--up",   "--planes",    "--pitch", "--scallop",
    "--direction-deg", "--grid", "--allowance", "--order", "--safe-height",
    "--thin-tolerance"};
constexpr const char* all_methods = "all";
// Default step of method 1, as a share of the cutter's radius.
constexpr double step_share_of_radius = 1.0 / 500;
// Default tolerance for dropping points, as a share of the tolerance. It is taken from the
// budget of the chords, so that a small share costs them little.
constexpr double thin_share = 0.1;
constexpr int most_planes = 10'000'000;
constexpr int most_repetitions = 100'000;
// The radii for which the clearance can be measured, in mm.
constexpr double least_radius = 1e-6;
constexpr double most_radius = 1e6;
constexpr std::string_view worst_word = "worst";
constexpr std::size_t shown_characters = 40;  // of a wrong word
constexpr int most_grid = 46'000;             // N x N vertices must have 32-bit numbers

std::vector<std::string_view> method_words()
{
    std::vector<std::string_view> words;
    for (const TrimmingMethod& method : trimming_methods())
        words.push_back(method.name);
    words.emplace_back(all_methods);
    return words;
}

void add_method_options(CLI::App& command, TrimOptions& options)
{
    const std::vector<std::string_view> words = method_words();
    std::string shown;
    for (const std::string_view word : words)
        shown += (shown.empty() ? "" : "|") + std::string{word};
    command
        .add_option_function<std::string>(
            "--method",
            [words, &options](const std::string& word) {
                options.method =
                    std::string{words[choice_argument("--method", word, words)]};
            },
            "trimming method (default envelope; --mode paper: 3)")
        ->type_name(shown);
    add_choice<TrimMode>(command, "--mode", options.mode, modes,
                         "corrected (default), or paper: defaults --method 3 --detection "
                         "literal --m3 scan-to-end --boundary none");
    add_choice<FoldDetection>(
        command, "--detection", options.detection, detections,
        "how methods 1, 2 and 3 find folds: by the signs of dz as printed (literal), or "
        "by corrected rules (guarded, default)");
    add_number(command,
               {"--m1-step", "MM",
                "method 1: distance of the scan lines (default radius / 500; "
                "--polyline: height of the curves / 1000)",
                NumberDomain::of_machine()},
               options.scan_step);
    add_number(command,
               {"--m1-threshold", "MM",
                "method 1: two points closer than this count as a self-intersection "
                "(default 4 steps)",
                NumberDomain::of_machine()},
               options.scan_threshold);
    add_choice<BranchSearch>(
        command, "--m3", options.search, searches,
        "search of method 3 for the crossing of two branches: in step along both (march, "
        "default), by every pair of segments (scan), or to the end of the curve as "
        "printed "
        "(scan-to-end, default of --mode paper with literal detection)");
    command.add_flag(
        "--explain", options.explain,
        "add a column to loops.csv: the rule by which each piece was removed");
}

// A number is the radius of a ball; other words are those of --cutter.
Cutter offset_argument(const std::string& word)
{
    if (word.find(':') != std::string::npos)
        return cutter_argument("--offset", word);
    return Cutter::ball(number_argument("--offset", word, NumberDomain::of_machine()));
}

void add_polyline_options(CLI::App& command, TrimOptions& options)
{
    command
        .add_option("--polyline", options.polyline,
                    "curves to trim, in place of PART (CSV: s_mm, z_mm, curve, plane)")
        ->type_name("FILE");
    command
        .add_option_function<std::string>(
            "--offset",
            [&options](const std::string& word) {
                options.offset = offset_argument(word);
            },
            "offset the curves of --polyline before trimming; the tool is on their left. "
            "R: radius of a ball in mm; CUTTER: as --cutter")
        ->type_name("R|CUTTER");
}

// The names of methods in a list such as "1,3r".
std::vector<std::string> methods_argument(const std::string& list)
{
    std::vector<std::string_view> words = method_words();
    words.pop_back();  // all_methods
    std::vector<std::string> methods;
    std::string rest = list + ",";
    for (std::size_t comma; (comma = rest.find(',')) != std::string::npos;
         rest.erase(0, comma + 1))
        methods.emplace_back(
            words[choice_argument("--compare-only", rest.substr(0, comma), words)]);
    return methods;
}

void add_comparison_options(CLI::App& command, TrimOptions& options)
{
    command
        .add_option_function<std::string>(
            "--compare-only",
            [&options](const std::string& list) {
                options.compare_only = methods_argument(list);
                options.repeat = options.repeat.value_or(1);
            },
            "compare these methods with the exact one, as --repeat does (default 1), and "
            "write no curves: names as in --method, separated by commas")
        ->type_name("METHODS");
}

void add_result_options(CLI::App& command, TrimOptions& options)
{
    command
        .add_option_function<std::string>(
            "--figure",
            [&options](const std::string& word) {
                options.figure.reset();
                options.figure_worst = word == worst_word;
                if (options.figure_worst)
                    return;
                if (!number_from_text(word))
                    throw CLI::ValidationError(
                        "--figure", "found \"" + printable(word, shown_characters) +
                                        "\"; expected the number of a plane, or worst");
                options.figure = whole_number_argument("--figure", word, 0, most_planes);
            },
            "draw the plane of this number before and after, from 0; worst: the plane in "
            "which the methods differ most")
        ->type_name("N|worst");
    add_whole_number(command,
                     {"--repeat",
                      "with --method all: time each method this often, in turns, and "
                      "compare the times "
                      "and the curves",
                      1, most_repetitions},
                     [&options](int count) { options.repeat = count; });
}

void add_plane_options(CLI::App& command, TrimOptions& options)
{
    add_whole_number(command,
                     {"--planes", "number of drive planes (default 100)", 1, most_planes},
                     [&options](int count) { options.planes = count; });
    add_number(
        command,
        {"--pitch", "MM", "largest distance of the drive planes, in place of --planes",
         NumberDomain::of_machine()},
        options.pitch);
    add_number(
        command,
        {"--scallop", "MM",
         "largest scallop height, in place of --planes (ball, bull-nose): on a mesh "
         "everywhere, on a surface where it is horizontal",
         NumberDomain::of_machine()},
        options.scallop);
    add_number(command,
               {"--direction-deg", "DEG", "feed direction, from +x in the xy plane",
                NumberDomain::any()},
               options.direction_deg);
    add_whole_number(command,
                     {"--grid",
                      "samples along each parameter of a surface; for a mesh, along each "
                      "drive plane (default 200)",
                      2, most_grid},
                     [&options](int count) { options.grid = count; });
    add_choice<BoundaryContact>(
        command, "--boundary", options.boundary, boundaries,
        "where the part is protected from the cutter. contact (default): on faces, "
        "borders, corners and creases; none (default of --mode paper): on faces only");
    add_number(command,
               {"--allowance", "MM", "thickness of the stock to leave on the part",
                NumberDomain::from_to(0, most_of_machine)},
               options.allowance);
    command.add_flag("--refine", options.refine,
                     "move the trimmed points onto the exact offset surface");
}

}  // namespace

void add_trim_options(CLI::App& command, TrimOptions& options)
{
    command.add_option("PART", options.part.path,
                       "surface, mesh or CAD file (STEP, IGES)");
    add_polyline_options(command, options);
    add_comparison_options(command, options);
    add_mesh_options(command, options.part);
    command
        .add_option_function<std::string>(
            "--cutter",
            [&options](const std::string& word) {
                options.cutter = cutter_argument("--cutter", word);
            },
            "ball:DIAMETER, flat:DIAMETER or bull:DIAMETER:CORNER_RADIUS in mm (required "
            "with PART)")
        ->type_name("CUTTER");
    add_plane_options(command, options);
    add_method_options(command, options);
    add_choice<PassOrder>(command, "--order", options.order, orders,
                          "cutting direction in neighbouring planes. zigzag (default): "
                          "opposite; one-way: the same");
    add_number(command,
               {"--safe-height", "MM", "height of rapids (default 5 above the part)",
                NumberDomain::any()},
               options.safe_height);
    add_number(command,
               {"--tolerance", "MM", "largest gouge depth", NumberDomain::of_machine()},
               options.tolerance);
    add_number(command,
               {"--thin-tolerance", "MM",
                "drop points of the path whose distance from the chord is at most this, "
                "within --tolerance; 0 keeps all (default --tolerance / 10)",
                NumberDomain::from_to(0, most_of_machine)},
               options.thin_tolerance);
    add_result_options(command, options);
    add_html_option(command, options.common);
    add_common_options(command, options.common);
    CLI::Option* const polyline = command.get_option("--polyline");
    for (const char* name : part_options)
        command.get_option(name)->excludes(polyline);
}

void require_option(bool holds, const std::string& what)
{
    if (!holds)
        throw DomainError{what};
}

const std::optional<Cutter>& cutter_of(const TrimOptions& options)
{
    return options.offset ? options.offset : options.cutter;
}

namespace {

FoldDetection detection_of(const TrimOptions& options)
{
    return options.detection.value_or(options.mode == TrimMode::Paper
                                          ? FoldDetection::Literal
                                          : FoldDetection::Guarded);
}

// Refuses options of methods other than the selected one.
void refuse_idle_method_options(const TrimOptions& options, const std::string& method)
{
    if (method == all_methods)
        return;
    const auto refuse = [&](const char* name, const std::string& users) {
        refuse_idle_options(options.common, std::array{name}, "--method " + method,
                            "--method " + users + " or all");
    };
    for (const TrimmingMethod& known : trimming_methods())
        if (known.name == method && !known.has_detection)
            refuse("--detection", "1, 2, 3");
    if (method != "1")
        for (const char* name : {"--m1-step", "--m1-threshold"})
            refuse(name, "1");
    if (method != "3")
        refuse("--m3", "3");
    refuse_idle_options(options.common, std::array{"--repeat"}, "--method " + method,
                        "--method all");
}

// Refuses combinations of --polyline and --offset with options of a part.
void check_curve_options(const TrimOptions& options)
{
    const bool has_curves = !options.polyline.empty();
    require_option(has_curves != !options.part.path.empty(),
                   "expected PART or --polyline, one of them");
    require_option(has_curves || options.cutter, "--cutter is needed, such as ball:20");
    require_option(has_curves || !options.offset,
                   "--offset: a PART is offset for its --cutter; expected --polyline");
    require_option(!has_curves || !options.cutter,
                   "--cutter and --polyline: curves are already an offset; expected one "
                   "of the two, or --offset");
    require_option(
        !has_curves || !options.refine,
        "--refine and --polyline: curves have no surface to refine on; expected one of "
        "the two");
    if (options.offset) {
        const double radius = options.offset->radius();
        require_within_extent("--offset", radius, options.common.limits);
        require_option(least_radius <= radius && radius <= most_radius,
                       "--offset: found a radius of " + to_text(radius) +
                           " mm; expected one from " + to_text(least_radius) + " to " +
                           to_text(most_radius) + " mm");
    }
    if (has_curves && !options.offset)
        refuse_idle_options(options.common, std::array{"--boundary"},
                            "--polyline without --offset", "--offset, or a PART");
    if (has_curves && !options.offset && method_name(options) != all_methods)
        refuse_idle_options(options.common, std::array{"--tolerance"},
                            "--polyline and one --method",
                            "--offset, a PART, or --method all");
}

}  // namespace

void check_trim_options(const TrimOptions& options)
{
    const ReadLimits& limits = options.common.limits;
    require_within_extent("--safe-height", options.safe_height, limits);
    require_within_extent("--allowance", options.allowance, limits);
    if (options.cutter)
        require_within_extent("--cutter", *options.cutter, limits);
    check_curve_options(options);
    require_option(int{options.planes.has_value()} + int{options.pitch.has_value()} +
                           int{options.scallop.has_value()} <
                       2,
                   "--planes, --pitch and --scallop: expected one of them");
    require_option(!options.scallop || !options.cutter || !options.cutter->is_flat(),
                   "--scallop: a flat cutter leaves no scallop on a horizontal surface; "
                   "expected --pitch");
    require_option(options.thin_tolerance.value_or(0) < options.tolerance,
                   "--thin-tolerance " + to_text(options.thin_tolerance.value_or(0)) +
                       ": expected less than --tolerance, " + to_text(options.tolerance) +
                       " mm");
    if (!options.compare_only.empty())
        refuse_idle_options(options.common,
                            std::array{"--method", "--explain", "--figure", "--refine"},
                            "--compare-only", "--method all");
    refuse_idle_method_options(options, method_name(options));
    require_option(options.search != BranchSearch::ScanToEnd ||
                       detection_of(options) == FoldDetection::Literal,
                   "--m3 scan-to-end: guarded detection pairs runs, whose ends it must "
                   "keep; expected --detection literal, or --m3 scan");
}

std::string_view mode_word(TrimMode mode)
{
    return word_for<TrimMode>(mode, modes);
}

std::string method_name(const TrimOptions& options)
{
    if (!options.compare_only.empty())
        return all_methods;
    return options.method.value_or(options.mode == TrimMode::Paper ? "3" : "envelope");
}

BoundaryContact boundary_contact(const TrimOptions& options)
{
    return options.boundary.value_or(options.mode == TrimMode::Paper
                                         ? BoundaryContact::None
                                         : BoundaryContact::Contact);
}

double thin_tolerance(const TrimOptions& options)
{
    return options.thin_tolerance.value_or(thin_share * options.tolerance);
}

TrimmingOptions trimming_options(const TrimOptions& options, double extent)
{
    TrimmingOptions trimming = default_trimming_options(extent);
    trimming.detection = detection_of(options);
    if (const std::optional<Cutter>& cutter = cutter_of(options))
        trimming.scan_step = step_share_of_radius * cutter->radius();
    trimming.scan_step = options.scan_step.value_or(trimming.scan_step);
    trimming.scan_threshold =
        options.scan_threshold.value_or(scan_threshold_in_steps * trimming.scan_step);
    // The paper scans to the end of the curve, which guarded detection excludes.
    const bool is_printed =
        options.mode == TrimMode::Paper && trimming.detection == FoldDetection::Literal;
    trimming.search = options.search.value_or(is_printed ? BranchSearch::ScanToEnd
                                                         : BranchSearch::March);
    return trimming;
}

void add_settings(Json& summary, const TrimOptions& options,
                  const TrimmingOptions& trimming)
{
    summary["mode"] = mode_word(options.mode);
    summary["detection"] = word_for<FoldDetection>(trimming.detection, detections);
    summary["m1_step_mm"] = trimming.scan_step;
    summary["m1_threshold_mm"] = trimming.scan_threshold;
    summary["m3"] = word_for<BranchSearch>(trimming.search, searches);
    if (options.offset) {
        summary["boundary"] =
            word_for<BoundaryContact>(boundary_contact(options), boundaries);
        summary["tolerance_mm"] = options.tolerance;
    }
    if (!options.polyline.empty())
        return;
    summary["direction_deg"] = options.direction_deg;
    summary["grid"] = options.grid;
    summary["boundary"] =
        word_for<BoundaryContact>(boundary_contact(options), boundaries);
    summary["allowance_mm"] = options.allowance;
    summary["tolerance_mm"] = options.tolerance;
    summary["thin_tolerance_mm"] = thin_tolerance(options);
    summary["order"] = word_for<PassOrder>(options.order, orders);
}

}  // namespace endmill
