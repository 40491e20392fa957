// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify_input.h"

#include <filesystem>
#include <utility>

#include "cli/console.h"
#include "endmill/core/error.h"
#include "endmill/core/numbers.h"
#include "endmill/io/file_format.h"
#include "endmill/io/mesh_file.h"
#include "endmill/io/path_file.h"
#include "endmill/io/path_summary.h"
#include "endmill/io/printable.h"
#include "endmill/io/read_file.h"
#include "endmill/io/tool_file.h"
#include "endmill/io/vti.h"
#include "endmill/simulation/mesh_stock.h"
#include "endmill/simulation/stock_memory.h"
#include "endmill/simulation/upright.h"

namespace endmill {
namespace {

// Where neither the command line nor a summary says anything.
// Source: spec of the removal, section 3.
constexpr double default_tolerance_mm = 0.01;
constexpr double default_scallop_mm = 0.1;

std::optional<Tool> told_tool(const VerifyOptions& options)
{
    std::optional<Tool> tool;
    if (!options.tool.empty())
        tool = read_tool(options.tool, options.common.limits);
    if (options.cutter && tool && tool->cutter != *options.cutter)
        throw DomainError{"--cutter " + cutter_word(*options.cutter) +
                          ": the tool file says " + cutter_word(tool->cutter) +
                          "; expected the same, or one of the two options"};
    if (options.cutter && !tool)
        tool = Tool{.cutter = *options.cutter};
    return tool;
}

Program read_path(const VerifyOptions& options, const std::optional<Tool>& tool)
{
    PathReadOptions reading;
    reading.limits = options.common.limits;
    reading.gcode.arc_tolerance_mm = options.arc_tolerance;
    reading.gcode.block_delete = options.block_delete;
    if (options.centre_is_programmed) {
        if (!tool)
            throw DomainError{
                "--programmed-point centre: expected --cutter or --tool, to "
                "know where the tip is"};
        reading.gcode.programmed_point_height_mm = tool->cutter.corner_radius();
    }
    return read_program(options.path, reading);
}

Tool tool_of(std::optional<Tool> told, const Program& program, const PathSummary& known,
             const std::string& path)
{
    if (told)
        return *std::move(told);
    for (const auto& cutter : {program.cutter, known.cutter})
        if (cutter)
            return Tool{.cutter = *cutter};
    throw DomainError{path +
                      ": neither the path nor a summary.json beside it names the "
                      "cutter; expected --cutter or --tool"};
}

DeviationLimits limits_of(const VerifyOptions& options, const PathSummary& known)
{
    const auto inner =
        known.inner_tolerance_mm ? known.inner_tolerance_mm : known.chord_tolerance_mm;
    const auto outer =
        known.outer_tolerance_mm ? known.outer_tolerance_mm : known.chord_tolerance_mm;
    const double scallop =
        known.scallop_mm ? *known.scallop_mm + outer.value_or(0) : default_scallop_mm;
    return {options.tolerance.value_or(inner.value_or(default_tolerance_mm)),
            options.scallop.value_or(scallop)};
}

// That of the command line, or the one that the path was planned for.
void add_part(VerifyInput& input, const VerifyOptions& options, const PathSummary& known)
{
    PartOptions part = options.part;
    if (part.path.empty() && known.part) {
        std::error_code ignored;
        if (std::filesystem::exists(*known.part, ignored))
            part.path = known.part->lexically_normal().string();
        else
            warn(options.common, options.path + ": the part that its summary names, " +
                                     shown_path(*known.part) +
                                     ", is not there; --part FILE names another");
    }
    if (part.path.empty())
        return;
    input.part = read_part_for(part, options.common);
    input.part_file = printable(part.path);
    input.files.push_back(part.path);
}

// Removal knows upright cutters: a path with another fixed axis is turned, and its part
// with it.
void stand_upright(VerifyInput& input)
{
    const auto axis = fixed_axis(input.program.path);
    if (!axis || *axis == Vec3::UnitZ())
        return;
    const Eigen::Matrix3d rotation = upright_rotation(*axis);
    input.program.path = turned(input.program.path, rotation);
    if (input.part)
        input.part->part = turned(input.part->part, rotation);
    input.program.remarks.push_back(
        "path and part are turned about the origin so that the axis, " +
        to_text(axis->x()) + "," + to_text(axis->y()) + "," + to_text(axis->z()) +
        ", is +z; so is all that is written");
}

std::optional<Block> block_of_numbers(const std::string& text)
{
    std::vector<double> numbers;
    std::size_t begin = 0;
    while (begin <= text.size()) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto number = number_from_text(text.substr(begin, end - begin));
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() != 6)
        return std::nullopt;
    const Block block{{numbers[0], numbers[1], numbers[2]},
                      {numbers[3], numbers[4], numbers[5]}};
    if (!(block.low.array() < block.high.array()).all())
        throw DomainError{"--stock " + text +
                          ": expected X0,Y0,Z0,X1,Y1,Z1 in mm with X0 < X1, Y0 < Y1 and "
                          "Z0 < Z1"};
    return block;
}

Block box_of(const StockGrid& grid, double top)
{
    return {{grid.low_x, grid.low_y, grid.bottom_z},
            {grid.low_x + grid.columns * grid.pitch, grid.low_y + grid.rows * grid.pitch,
             top}};
}

Block box_of(const TriangleMesh& mesh)
{
    Block box{mesh.points().front(), mesh.points().front()};
    for (const Vec3& point : mesh.points()) {
        box.low = box.low.cwiseMin(point);
        box.high = box.high.cwiseMax(point);
    }
    return box;
}

void add_stock(VerifyInput& input, const VerifyOptions& options)
{
    if (options.stock == "block") {
        input.block = default_block(input.part ? &input.part->part : nullptr,
                                    input.program.path, input.tool.cutter);
        return;
    }
    if (const auto block = block_of_numbers(options.stock)) {
        input.block = *block;
        return;
    }
    input.files.push_back(options.stock);
    const std::filesystem::path path{options.stock};
    std::error_code ignored;
    if (path.empty() ||
        (options.stock.find(',') != std::string::npos && !exists(path, ignored)))
        throw DomainError{"--stock " + printable(options.stock) +
                          ": expected block, X0,Y0,Z0,X1,Y1,Z1 in mm, or a file"};
    if (path.extension() == ".vti") {
        input.stock = read_stock(path, options.common.limits);
    } else {
        const MeshFile mesh =
            read_mesh(path, {options.common.limits, options.part.units, options.part.up});
        require_stock_memory(box_of(mesh.mesh), options.resolution,
                             options.common.limits.max_memory_gib);
        input.stock = mesh_stock(mesh.mesh, options.resolution);
    }
    const auto heights = height_range(*input.stock);
    input.block = box_of(input.stock->grid(),
                         heights ? heights->high : input.stock->grid().bottom_z);
}

}  // namespace

VerifyInput read_verify_input(const VerifyOptions& options)
{
    std::optional<Tool> told = told_tool(options);
    Program program = read_path(options, told);
    const PathSummary known =
        read_path_summary(options.path, options.common.limits).value_or(PathSummary{});
    Tool tool = tool_of(std::move(told), program, known, options.path);
    const std::string stem = std::filesystem::path{options.path}.stem().string();
    VerifyInput input{printable(known.name.value_or(stem)),
                      std::move(program),
                      std::move(tool),
                      limits_of(options, known),
                      {},
                      {},
                      {},
                      {},
                      {options.path}};
    if (!options.tool.empty())
        input.files.push_back(options.tool);
    if (input.program.path.points.size() < 2)
        throw GeometryError{
            "no move is left of the path to be judged; expected two points "
            "at least"};
    add_part(input, options, known);
    stand_upright(input);
    add_stock(input, options);
    return input;
}

VerificationTask verification_task(const VerifyInput& input, const VerifyOptions& options)
{
    VerificationTask task{.path = &input.program.path,
                          .cutter = input.tool.cutter,
                          .body = tool_body(input.tool),
                          .part = input.part ? &input.part->part : nullptr,
                          .block = input.block,
                          .stock = input.stock ? &*input.stock : nullptr};
    task.resolution = options.resolution;
    task.max_memory_gib = options.common.limits.max_memory_gib;
    task.deviation.limits = input.limits;
    task.deviation.max_refine = options.max_refine;
    return task;
}

}  // namespace endmill
