// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_input.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <filesystem>
#include <utility>

#include "cli/console.h"
#include "cli/idle_options.h"
#include "cli/path_facts.h"
#include "cli/path_tools.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/machining_data.h"
#include "endmill/files/part_file.h"
#include "endmill/files/path_file.h"
#include "endmill/files/read_file.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// The top of the stock, and what gives it.
struct StockTop {
    double z;  // mm
    std::string by;
};

// The top of the block around the part that the summary of the path names, if it names one.
// \throws Error if the part cannot be read.
std::optional<double> top_by_summary(const FeedInput& input,
                                     const FeedCommandOptions& options)
{
    if (!input.known.part)
        return std::nullopt;
    const auto& [file, units, up] = *input.known.part;
    const Part part = part_file({file.string(), units, up}, options.common).part;
    return default_block(&part, input.program.path, input.tool.cutter).high.z();
}

// Without a part the default block is the bounding box of the path, whose top is not the
// top of the stock.
std::optional<StockTop> known_stock_top(const FeedInput& input,
                                        const FeedCommandOptions& options)
{
    const double block_top = input.stock.block.high.z();
    if (options.stock_top)
        return StockTop{*options.stock_top, "--stock-top"};
    if (options.stock != "block")
        return StockTop{block_top, "--stock"};
    if (!options.part.path.empty())
        return StockTop{block_top, "1 mm above --part"};
    // A summary may be older than a move of the part. The path can help then.
    std::exception_ptr unreadable;
    try {
        if (const auto top = top_by_summary(input, options))
            return StockTop{*top, "1 mm above the part of the path"};
    } catch (const Error&) {
        unreadable = std::current_exception();
    }
    if (const auto top = entry_height(input.program.path))
        return StockTop{*top, "at most, where the first move at feed goes down"};
    if (unreadable)
        std::rethrow_exception(unreadable);
    return std::nullopt;
}

// The only tool of the path, from the table of --tools.
Tool tool_of_table(const Program& program, const FeedCommandOptions& options)
{
    const std::string file = printable(options.path.file);
    const PathTools tools =
        tools_of_path(program.path, file, printable(options.path.tools),
                      read_tools_for(options.path, options.common));
    if (!tools.changes.empty())
        throw DomainError{file +
                          ": several tools cut; expected a path of one tool, for which "
                          "feeds are planned"};
    return tools.first;
}

Tool tool_without_file(const FeedCommandOptions& options, const Program& program,
                       const PathSummary& known)
{
    for (const auto& cutter : {options.path.cutter, program.cutter, known.cutter})
        if (cutter)
            return Tool{.cutter = *cutter};
    throw DomainError{options.path.file +
                      ": neither the path nor a summary.json beside it names the cutter; "
                      "expected --cutter or --tool"};
}

// Options of the command line override the values of the tool file.
void apply_options(Tool& tool, const ToolOptions& options)
{
    if (options.flutes)
        tool.flutes = options.flutes;
    if (options.helix_deg)
        tool.helix = Angle::degrees(*options.helix_deg);
    if (options.max_force_n)
        tool.limits.cutting_force_n = options.max_force_n;
    if (options.max_thrust_n)
        tool.limits.thrust_n = options.max_thrust_n;
    if (options.max_torque_n_m)
        tool.limits.torque_n_m = options.max_torque_n_m;
}

void require_same_cutter(const std::optional<Tool>& tool,
                         const std::optional<Cutter>& cutter)
{
    if (tool && cutter && tool->cutter != *cutter)
        throw DomainError{"--cutter " + cutter_word(*cutter) + ": the tool file has " +
                          cutter_word(tool->cutter) +
                          "; expected the same cutter, or only one of the two options"};
}

FeedPlanOptions plan_options(const FeedCommandOptions& options)
{
    FeedPlanOptions plan =
        options.mode == FeedMode::Paper ? FeedPlanOptions{} : corrected_feed_options();
    plan.chip = options.chip.value_or(plan.chip);
    if (options.peak) {
        plan.peak = options.peak->rule;
        plan.peak_factor = options.peak->factor;
    }
    plan.max_feed_per_tooth_mm = options.max_feed_per_tooth_mm;
    plan.min_feed_per_tooth_mm = options.min_feed_per_tooth_mm;
    plan.block_time_ms = options.block_time_ms;
    plan.accuracy = options.accuracy;
    return plan;
}

// The cutter must be the one that the path was planned for.
void require_cutter_of_path(const FeedCommandOptions& options, const Cutter& used,
                            const std::optional<Cutter>& planned)
{
    if (!planned || used == *planned)
        return;
    const std::string used_name = options.path.cutter ? "--cutter " + cutter_word(used)
                                                      : "--tool " + options.tool.file +
                                                            " with " + cutter_word(used);
    throw DomainError{used_name + ": the path or the summary.json beside it names " +
                      cutter_word(*planned) + "; expected the same cutter"};
}

void require_tool(const Tool& tool)
{
    if (!tool.cutter.is_ball())
        throw DomainError{"--cutter: found " + cutter_word(tool.cutter) +
                          "; expected ball:DIAMETER, the cutter of the model"};
    if (!tool.flutes)
        throw DomainError{
            "--flutes: the number of flutes is not known; expected --flutes N, or a tool "
            "file with flutes"};
    if (tool.helix && std::abs(tool.helix->radians()) > most_helix)
        throw DomainError{"--helix-deg, or helix_deg of the tool file: found " +
                          to_text(tool.helix->written_degrees()) + "; expected " +
                          helix_domain.words};
}

void require_range(const FeedInput& input, const FeedCommandOptions& options)
{
    const FeedRange range = feed_range(input.job.material, input.plan);
    if (!range.most_mm || range.least_mm <= *range.most_mm)
        return;
    const bool is_least_given = options.min_feed_per_tooth_mm.has_value();
    throw DomainError{is_least_given
                          ? "--min-feed-per-tooth: found " + to_text(range.least_mm) +
                                "; expected at most the largest feed per tooth, " +
                                to_text(*range.most_mm) + " mm (--max-feed-per-tooth)"
                          : "--max-feed-per-tooth: found " + to_text(*range.most_mm) +
                                "; expected at least the least feed per tooth, " +
                                to_text(range.least_mm) + " mm (--min-feed-per-tooth)"};
}

void require_answerable(const FeedInput& input, const FeedCommandOptions& options)
{
    const std::string peak = peak_word(input.plan.peak, input.plan.peak_factor);
    const bool has_factor = input.plan.peak == PeakRule::Constant;
    if (!has_factor && !input.tool.helix)
        throw DomainError{"--peak " + peak +
                          ": the helix of the flutes is not known; expected --helix-deg, "
                          "or a tool file with helix_deg"};
    if (!has_factor && options.coefficients == CoefficientSource::Table)
        throw DomainError{"--coefficients table: expected --peak constant:R; " + peak +
                          " needs the loads within a spindle revolution, not their mean"};
    if (options.engagement == EngagementChoice::Stock &&
        options.coefficients == CoefficientSource::Table)
        throw DomainError{
            "--coefficients table: expected --engagement contact, passes or auto; those "
            "of the stock are in no table"};
    if (options.mode == FeedMode::Planned && !input.job.machine.acceleration_m_per_s2)
        throw DomainError{
            "--mode planned: the acceleration is not known; expected --machine with "
            "acceleration_m_per_s2"};
}

// The rows must be in the order of the path. Shuffled rows would describe another path.
void require_order(const Program& program, const std::string& file,
                   const std::string& text)
{
    const std::vector<PathPoint>& points = program.path.points;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PathPoint& last = points[i - 1];
        const PathPoint& next = points[i];
        const bool is_rising =
            next.pass > last.pass || (next.pass == last.pass && next.point > last.point);
        if (!is_rising)
            throw FormatError{
                "E_CSV",
                {file, std::to_string(line_of_row(text, i)),
                 "point " + std::to_string(next.point) + " of pass " +
                     std::to_string(next.pass) + " after point " +
                     std::to_string(last.point) + " of pass " + std::to_string(last.pass),
                 "points in the order of the path"}};
    }
}

// The path must have a cutting move. The message includes the remarks of the reader: it
// may have left out moves, such as those whose position is not known.
void require_cut(const Program& program)
{
    const auto is_cut = [](const PathPoint& point) { return point.move == Move::Cut; };
    if (std::ranges::any_of(program.path.points, is_cut))
        return;
    std::string found = "no move of the path cuts";
    for (const std::string& remark : program.remarks)
        found += "; " + remark;
    throw GeometryError{found + "; expected a cutting move of some length"};
}

// The tolerance applies to contacts that the path states, which are checked in any case,
// and to those that are projected on the part.
void require_contacts(const FeedInput& input, const FeedCommandOptions& options)
{
    const auto has_contact = [](const PathPoint& point) {
        return point.contact() != nullptr;
    };
    const bool is_by_passes = options.engagement == EngagementChoice::Passes;
    if (std::ranges::any_of(input.program.path.points, has_contact) ||
        (!input.part.empty() && !is_by_passes))
        return;
    refuse_idle_options(
        options.common, std::array{"--contact-tolerance"},
        is_by_passes ? "--engagement passes and a path without contacts"
                     : "a path without contacts",
        is_by_passes ? "--engagement auto or contact, and --part" : "--part");
}

void add_stock(FeedInput& input, const FeedCommandOptions& options)
{
    if (are_dexels(options.stock))
        throw DomainError{"--stock " + printable(options.stock) +
                          ": dexels of a run of five axes; expected a block, a closed "
                          "mesh, or the stock.vti of a run of three axes"};
    VerifyOptions stock;
    stock.common = options.common;
    stock.part = options.part;
    stock.stock = options.stock;
    stock.resolution = options.resolution;
    const Part part = input.part;
    input.stock = read_verify_stock(stock, input.part.empty() ? nullptr : &part,
                                    input.program.path, input.tool.cutter);
    const auto top = known_stock_top(input, options);
    if (!top)
        throw DomainError{
            "the stock's top is not known: no summary beside the path names a part, and "
            "the path does not begin with a move down into the stock; expected "
            "--stock-top, --stock or --part"};
    input.stock_top = top->z;
    input.stock_top_by = top->by;
    if (!input.stock.kept)
        input.stock.block.high.z() = top->z;
}

}  // namespace

FeedInput read_feed_input(const FeedCommandOptions& options)
{
    refuse_idle_feed_options(options);
    refuse_idle_tool_options(options.path, options.common);
    const std::string& file = options.path.file;
    const ReadLimits& limits = options.common.limits;
    std::optional<Tool> tool;
    if (!options.tool.file.empty())
        tool = read_tool(options.tool.file, limits);
    require_same_cutter(tool, options.path.cutter);
    const PathSummary known = path_summary_of(options.path, options.common);
    const auto cutter = options.path.cutter ? options.path.cutter
                        : tool              ? std::optional{tool->cutter}
                                            : known.cutter;
    std::string text = read_file(file, limits);
    const PathReadOptions reading = path_reading(options.path, cutter, options.common);
    Program program = program_of_text(text, options.path, reading, options.common);
    require_order(program, file, text);
    number_points(program.path);
    if (!options.path.tools.empty())
        tool = tool_of_table(program, options);
    if (!tool)
        tool = tool_without_file(options, program, known);
    require_cutter_of_path(options, tool->cutter, known.cutter);
    require_cutter_of_path(options, tool->cutter, program.cutter);
    apply_options(*tool, options.tool);
    require_tool(*tool);
    const std::string stem = std::filesystem::path{file}.stem().string();
    FeedInput input{.name = printable(known.name.value_or(stem)),
                    .program = std::move(program),
                    .known = known,
                    .tool = *tool,
                    .job = {read_material(options.material, limits), milling_tool(*tool)},
                    .plan = plan_options(options)};
    const bool is_interpreted = options.path.interpreter != Interpreter::Endmill;
    input.format = is_interpreted ? PathFormat::Canonical : path_format(text, file);
    if (input.format == PathFormat::Gcode)
        input.text = std::move(text);
    input.reading = gcode_reading(reading);
    if (!options.machine.empty())
        input.job.machine = read_machine(options.machine, limits).limits;
    require_answerable(input, options);
    require_range(input, options);
    if (!options.part.path.empty())
        input.part =
            read_surface_for(options.part.path, "feed --part", options.common).surfaces;
    require_cut(input.program);
    require_contacts(input, options);
    add_stock(input, options);
    return input;
}

std::vector<std::string> files_of(const FeedInput& input,
                                  const FeedCommandOptions& options)
{
    std::vector<std::string> files{options.path.file, options.material};
    for (const std::string& file :
         {options.machine, options.tool.file, options.path.tools, options.part.path,
          input.stock.file})
        if (!file.empty())
            files.push_back(file);
    return files;
}

}  // namespace endmill
