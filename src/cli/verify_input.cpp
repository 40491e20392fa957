// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verify_input.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <variant>

#include "cli/console.h"
#include "cli/facet_list.h"
#include "cli/path_tools.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/drop_cutter/clearance.h"
#include "endmill/files/dexel_file.h"
#include "endmill/files/machining_data.h"
#include "endmill/files/path_file.h"
#include "endmill/files/read_file.h"
#include "endmill/orientation/axis_reach.h"
#include "endmill/stock/mesh_stock.h"

namespace endmill {
namespace {

// Axes that differ by less count as one: far above the rounding of axes in programs.
constexpr double same_axis = 1e-6;

std::optional<Tool> given_tool(const VerifyOptions& options)
{
    std::optional<Tool> tool;
    if (!options.tool.empty())
        tool = read_tool(options.tool, options.common.limits);
    if (options.path.cutter && tool && tool->cutter != *options.path.cutter)
        throw DomainError{"--cutter " + cutter_word(*options.path.cutter) +
                          ": the tool file has " + cutter_word(tool->cutter) +
                          "; expected the same cutter, or only one of the two options"};
    if (options.path.cutter && !tool)
        tool = Tool{.cutter = *options.path.cutter};
    return tool;
}

Tool tool_of(std::optional<Tool> given, const Program& program, const PathSummary& known,
             const std::string& path)
{
    if (given)
        return *std::move(given);
    for (const auto& cutter : {program.cutter, known.cutter})
        if (cutter)
            return Tool{.cutter = *cutter};
    throw DomainError{path +
                      ": neither the path nor a summary.json beside it names the "
                      "cutter; expected --cutter or --tool"};
}

void require_moves(const Program& program, const std::string& file)
{
    if (program.path.points.size() < 2)
        throw GeometryError{
            file + ": the path has no moves to verify; expected at least two points"};
}

// The tools of the table, or else the only tool.
template <typename OnlyTool>
PathTools used_tools(const Program& program, const VerifyOptions& options,
                     const std::vector<NumberedTool>& table, const OnlyTool& only_tool)
{
    const std::string file = printable(options.path.file);
    if (table.empty()) {
        refuse_several_tools(program.path, file);
        return {only_tool(), {}};
    }
    PathTools tools =
        tools_of_path(program.path, file, printable(options.path.tools), table);
    if (!tools.changes.empty() && options.engagement)
        throw DomainError{"--engagement: several tools cut; expected a path of one tool"};
    return tools;
}

// The cutter around which the default block is made.
Cutter widest_cutter(const VerifyInput& input)
{
    Cutter widest = input.tool.cutter;
    for (const ToolChange& change : input.changes)
        if (change.cutter.radius() > widest.radius())
            widest = change.cutter;
    return widest;
}

// The limits of the command line, or else of the summary, or else the default ones.
DeviationLimits limits_of(const VerifyOptions& options, const PathSummary& known)
{
    constexpr DeviationLimits otherwise;
    const auto inner =
        known.inner_tolerance_mm ? known.inner_tolerance_mm : known.chord_tolerance_mm;
    const auto outer =
        known.outer_tolerance_mm ? known.outer_tolerance_mm : known.chord_tolerance_mm;
    const double scallop =
        known.scallop_mm ? *known.scallop_mm + outer.value_or(0) : otherwise.scallop;
    const double known_tolerance =
        std::max(inner.value_or(otherwise.tolerance), no_gouge_tolerance);
    return {options.tolerance.value_or(known_tolerance),
            options.scallop.value_or(scallop)};
}

// Adds the part of --part, or else the part that the path was planned for.
void add_part(VerifyInput& input, const VerifyOptions& options, const PathSummary& known)
{
    PartOptions part = options.part;
    if (part.path == no_part)
        return;
    if (!part.path.empty() && !options.guard.empty() && options.guard != no_part)
        part = part_pair(part, options.guard).part;
    if (part.path.empty() && known.part) {
        const auto& [file, units, up] = *known.part;
        std::error_code ignored;
        if (!std::filesystem::exists(file, ignored))
            throw FormatError{
                "E_OPEN",
                {options.path.file, "",
                 "its summary names the part " + shown_path(file) +
                     ", which does not exist",
                 "this file, --part FILE, or --part none to compare with no part"}};
        part = {file.lexically_normal().string(), units, up};
    }
    if (part.path.empty())
        return;
    input.part = read_part_for(part, options.common);
    input.part_path = std::move(part.path);
}

// Material removal requires the tool axis +z. A path with another fixed axis is rotated,
// together with its part.
void stand_upright(VerifyInput& input)
{
    const auto axis = fixed_axis(input.program.path);
    if (!axis || *axis == Vec3::UnitZ())
        return;
    input.upright_axis = *axis;
    const Eigen::Matrix3d rotation = upright_rotation(*axis);
    input.program.path = turned(input.program.path, rotation);
    if (input.part)
        input.part->part = turned(input.part->part, rotation);
    input.program.remarks.push_back(
        "path, part and results are rotated about the origin: the tool axis " +
        to_text(axis->x()) + "," + to_text(axis->y()) + "," + to_text(axis->z()) +
        " becomes +z");
}

// Whether the tool turns against the part. A machine may also turn it about its own axis,
// which moves the tip on an arc.
bool is_turning(const ToolPath& path)
{
    if (!fixed_axis(path))
        return true;
    if (!path.machine)
        return false;
    const std::vector<AxisPositions>& positions = path.machine->positions;
    return std::ranges::any_of(positions, [&](const AxisPositions& at) {
        return at.rotary != positions.front().rotary;
    });
}

// The cutter's positions are tested for so many axes at most.
constexpr std::size_t most_tested_axes = 24;

// The axes along which the tool cuts; none if there are too many, or if a machine moves it.
std::vector<Vec3> tested_axes(const VerifyInput& input)
{
    std::vector<Vec3> axes;
    for (const PathPoint& point : input.program.path.points) {
        const Vec3& axis = point.location.axis;
        const auto is_same = [&](const Vec3& known) {
            return (known - axis).norm() <= same_axis;
        };
        if (point.move != Move::Cut || std::ranges::any_of(axes, is_same))
            continue;
        if (axes.size() == most_tested_axes)
            return {};
        axes.push_back(axis);
    }
    return axes;
}

// The engine of --engine, or else the one that the path needs. Options that need heights are
// refused with the other one.
RemovalEngine engine_of(const VerifyInput& input, const VerifyOptions& options)
{
    const bool is_fixed = !is_turning(input.program.path);
    const bool needs_dexels = are_dexels(options.stock);
    const RemovalEngine engine = options.engine.value_or(
        is_fixed && !needs_dexels ? RemovalEngine::ThreeAxis : RemovalEngine::FiveAxis);
    const std::string why = !is_fixed      ? "the tool turns along the path"
                            : needs_dexels ? "--stock names dexels"
                                           : "--engine five-axis";
    if (engine == RemovalEngine::ThreeAxis && (!is_fixed || needs_dexels))
        throw DomainError{"--engine three-axis: " + why + "; expected five-axis"};
    if (engine == RemovalEngine::ThreeAxis)
        return engine;
    if (options.engagement)
        throw DomainError{"--engagement: " + why +
                          "; the engagement is known for three axes only"};
    if (input.inaccessible == InaccessibleStock::Report &&
        (input.guard || tested_axes(input).empty()))
        throw DomainError{
            "--inaccessible report: " + why +
            "; the test needs a mesh without a protected part, and at most " +
            std::to_string(most_tested_axes) +
            " axes along which the tool cuts. Expected --inaccessible count"};
    return engine;
}

// Whether path and part are rotated. Dexels that are read or written are in the frame of
// the part, so that the runs of all tool axes can follow each other.
bool is_stood_upright(const VerifyInput& input, const VerifyOptions& options)
{
    if (input.engine == RemovalEngine::ThreeAxis)
        return true;
    return !input.program.path.machine && !options.write_stock &&
           !are_dexels(options.stock);
}

// States how heights become dexels. Their moves are needed to write the stock.
void add_stock_remark(VerifyInput& input, const VerifyOptions& options)
{
    const auto& kept = input.stock.kept;
    if (input.engine == RemovalEngine::ThreeAxis || !kept)
        return;
    if (options.write_stock && !kept->history)
        throw DomainError{"--write-stock: the moves that made the stock " +
                          printable(input.stock.file) +
                          " are not known; expected a block, or the stock of an earlier "
                          "run that began with a block"};
    input.program.remarks.push_back(
        kept->history
            ? "the heights of the stock become dexels: its block is cut again by its " +
                  std::to_string(sweep_count(*kept->history)) + " moves"
            : std::string{"the heights of the stock become dexels, with bounds between "
                          "the centres of the cells"});
}

// States that three axes ignore a cutting length.
void add_length_remark(VerifyInput& input)
{
    const bool is_finite =
        std::isfinite(input.tool.cutting_length) ||
        std::ranges::any_of(input.changes, [](const ToolChange& change) {
            return std::isfinite(change.cutting_length);
        });
    if (is_finite && input.engine == RemovalEngine::ThreeAxis)
        input.program.remarks.emplace_back(
            "cutting_length_mm is not used with three axes, where cutters are endless; "
            "--engine five-axis uses it");
}

// The file of the protected part: that of --protect, or else of the summary.
// \return nothing if there is none.
std::optional<PartOptions> guard_file(const VerifyInput& input,
                                      const VerifyOptions& options,
                                      const PathSummary& known)
{
    if (options.guard == no_part)
        return std::nullopt;
    if (!options.guard.empty())
        return part_pair({input.part_path, options.part.units, options.part.up},
                         options.guard)
            .guard;
    if (!known.protected_part)
        return std::nullopt;
    const auto& [file, units, up] = *known.protected_part;
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        throw FormatError{"E_OPEN",
                          {options.path.file, "",
                           "its summary names the protected part " + shown_path(file) +
                               ", which does not exist",
                           "this file, --protect FILE, or --protect none"}};
    return PartOptions{file.lexically_normal().string(), units, up};
}

// Adds the protected part. Only a single ball along +z can be tested against it.
void add_guard(VerifyInput& input, const VerifyOptions& options, const PathSummary& known)
{
    const std::optional<PartOptions> file = guard_file(input, options, known);
    if (!file)
        return;
    const bool is_upright = fixed_axis(input.program.path) == Vec3{Vec3::UnitZ()};
    if (!input.tool.cutter.is_ball() || !input.changes.empty() || !is_upright)
        throw DomainError{
            "--protect " + printable(file->path) +
            ": expected a path of a single ball along +z, or --protect none"};
    input.guard_part =
        std::make_shared<const Part>(read_part_for(*file, options.common).part);
    input.guard = std::make_shared<const ProtectedPart>(
        *input.guard_part, BallCutter{input.tool.cutter.radius()},
        input.limits.tolerance);
    input.guard_path = file->path;
}

// Refuses a part whose facets and faces may have other numbers than when the path was planned.
void require_part_as_planned(const VerifyInput& input, const VerifyOptions& options,
                             const PathSummary& known)
{
    if (!known.part_sha256 ||
        *known.part_sha256 ==
            content_sha256(read_file(input.part_path, options.common.limits)))
        return;
    throw DomainError{
        printable(input.part_path) +
        ": its content changed since the path was planned (part_sha256 of "
        "the summary), so that the facets left uncut are not known; expected "
        "the same file, or --part and --skip-facets"};
}

// Adds the facets whose remaining stock is not judged: those of --skip-facets, or else those
// that the path was planned to leave by a list or by its faces.
void add_skipped(VerifyInput& input, const VerifyOptions& options,
                 const PathSummary& known)
{
    if (options.skip_facets == no_part || !input.part)
        return;
    if (options.skip_facets.empty() && options.part.path.empty())
        require_part_as_planned(input, options, known);
    input.skip_file = options.skip_facets;
    if (input.skip_file.empty() && options.part.path.empty() && known.skipped_facets)
        input.skip_file = known.skipped_facets->lexically_normal().string();
    input.skipped = skipped_facets(input.skip_file, *input.part, options.common);
    if (!options.skip_facets.empty() || !options.part.path.empty() ||
        known.cut_faces.empty())
        return;
    input.cut_faces = known.cut_faces;
    std::vector<std::size_t> all;
    std::ranges::set_union(
        input.skipped,
        facets_of_other_faces(input.cut_faces, *input.part, input.part_path),
        std::back_inserter(all));
    input.skipped = std::move(all);
}

// Whether remaining stock is judged where the cutter cannot touch the part. A test of the
// cutter's position exists for meshes, and beside a protected part.
InaccessibleStock inaccessible_of(const VerifyOptions& options, const PathSummary& known,
                                  const VerifyInput& input)
{
    const bool is_tested =
        input.part &&
        (input.guard || std::holds_alternative<TriangleMesh>(input.part->part));
    if (options.inaccessible == InaccessibleStock::Report && input.part && !is_tested)
        throw DomainError{
            "--inaccessible report: the part is a surface; expected a mesh, or "
            "--inaccessible count"};
    if (!is_tested)
        return InaccessibleStock::Count;
    return options.inaccessible.value_or(
        known.inaccessible.value_or(InaccessibleStock::Count));
}

// The test whether a cutter of the path can come so near to a place of the mesh that it
// leaves half of the scallop limit. It shares the drop cutters, which refer to the mesh.
std::function<bool(const PartRay&)> accessibility(const VerifyInput& input)
{
    if (input.inaccessible == InaccessibleStock::Count)
        return {};
    const double distance = reached_share * input.limits.scallop;
    const auto is_barred = [guard = input.guard, distance](const PartRay& ray) {
        return guard && !guard->is_accessible({ray.point, ray.normal}, distance);
    };
    const auto* mesh = std::get_if<TriangleMesh>(&input.part->part);
    if (!mesh)
        return [is_barred](const PartRay& ray) { return !is_barred(ray); };
    std::vector<Cutter> cutters{input.tool.cutter};
    for (const ToolChange& change : input.changes)
        if (std::ranges::find(cutters, change.cutter) == cutters.end())
            cutters.push_back(change.cutter);
    if (input.engine == RemovalEngine::FiveAxis) {
        std::vector<AxisReach> reach;
        reach.reserve(cutters.size());
        for (const Cutter& cutter : cutters)
            reach.emplace_back(*mesh, cutter, tested_axes(input));
        return [reach = std::move(reach), distance](const PartRay& ray) {
            return std::ranges::any_of(reach, [&](const AxisReach& of) {
                return of.reaches({ray.point, ray.normal}, distance);
            });
        };
    }
    std::vector<std::shared_ptr<const DropCutter>> drop_cutters;
    drop_cutters.reserve(cutters.size());
    for (const Cutter& cutter : cutters)
        drop_cutters.push_back(std::make_shared<const DropCutter>(*mesh, cutter));
    return [drop_cutters = std::move(drop_cutters), is_barred,
            distance](const PartRay& ray) {
        return !is_barred(ray) &&
               std::ranges::any_of(drop_cutters, [&](const auto& drop_cutter) {
                   return is_accessible(*drop_cutter, {ray.point, ray.normal}, distance);
               });
    };
}

// Memory for each cell or ray that the output of the remaining stock needs: a copy, or a
// mesh.
double bytes_to_write(const VerifyOptions& options, RemovalEngine engine)
{
    if (engine == RemovalEngine::FiveAxis)
        return std::max(options.write_stock ? dexel_file_bytes_per_ray : 0,
                        options.write_mesh ? mesh_bytes_per_ray : 0);
    const bool is_copied = options.engagement || options.write_stock;
    return std::max(is_copied ? double{sizeof(double)} : 0,
                    options.write_mesh ? mesh_bytes_per_cell : 0);
}

}  // namespace

VerifyInput read_verify_input(const VerifyOptions& options)
{
    const std::string& file = options.path.file;
    refuse_idle_tool_options(options.path, options.common);
    const std::vector<NumberedTool> table = read_tools_for(options.path, options.common);
    std::optional<Tool> given =
        table.size() == 1 ? std::optional{table.front().tool} : given_tool(options);
    const PathSummary known = path_summary_of(options.path, options.common);
    const std::optional<Cutter> before = given           ? std::optional{given->cutter}
                                         : table.empty() ? known.cutter
                                                         : std::nullopt;
    PathOptions path = options.path;
    path.tool_length = given ? given->length : 0;
    Program program = read_program_for(path, before, options.common, known.machine);
    require_moves(program, file);
    PathTools tools = used_tools(program, options, table, [&] {
        return tool_of(std::move(given), program, known, file);
    });
    const std::string stem = std::filesystem::path{file}.stem().string();
    VerifyInput input{.name = printable(known.name.value_or(stem)),
                      .program = std::move(program),
                      .tool = std::move(tools.first),
                      .limits = limits_of(options, known),
                      .changes = std::move(tools.changes),
                      .tools = std::move(tools.used)};
    if (input.program.path.machine)
        input.machine = MachineMotion{input.program.path.machine->interpolation,
                                      input.program.path.machine->setup,
                                      {}};
    add_part(input, options, known);
    if (const auto remark = rounding_remark(input.program, input.limits.tolerance);
        remark && input.part)
        input.program.remarks.push_back(*remark);
    if (!input.part)
        refuse_options_without_part(options.common);
    add_guard(input, options, known);
    add_skipped(input, options, known);
    input.inaccessible = inaccessible_of(options, known, input);
    const auto is_given = [](const std::string& name) {
        return !name.empty() && name != no_part;
    };
    if (!is_given(options.part.path) && !is_given(options.guard) &&
        !may_be_mesh(options.stock))
        refuse_idle_mesh_options(options.common);
    input.engine = engine_of(input, options);
    add_length_remark(input);
    if (is_stood_upright(input, options))
        naming(file, [&] { stand_upright(input); });
    input.stock = read_verify_stock(options, input.part ? &input.part->part : nullptr,
                                    input.program.path, widest_cutter(input));
    add_stock_remark(input, options);
    return input;
}

std::vector<std::string> files_of(const VerifyInput& input, const VerifyOptions& options)
{
    std::vector<std::string> files{options.path.file};
    for (const std::string& file : {options.tool, options.path.tools, input.part_path,
                                    input.guard_path, input.skip_file, input.stock.file})
        if (!file.empty())
            files.push_back(file);
    return files;
}

VerificationTask verification_task(const VerifyInput& input, const VerifyOptions& options)
{
    VerificationTask task{.path = &input.program.path,
                          .cutter = input.tool.cutter,
                          .body = tool_body(input.tool),
                          .cutting_length = input.tool.cutting_length,
                          .stock = input.stock.block};
    if (input.stock.kept)
        task.stock = &*input.stock.kept;
    if (input.stock.dexels)
        task.stock = &*input.stock.dexels;
    task.changes = input.changes;
    task.engine = input.engine;
    task.resolution = options.resolution;
    task.max_memory_gib = options.common.limits.max_memory_gib;
    task.extra_bytes_per_cell = bytes_to_write(options, input.engine);
    if (input.part)
        task.judged =
            JudgedPart{.part = &input.part->part,
                       .limits = input.limits,
                       .max_refine = options.max_refine,
                       .is_accessible = accessibility(input),
                       .skipped_facets = facets_in_mesh(input.skipped, *input.part)};
    return task;
}

}  // namespace endmill
