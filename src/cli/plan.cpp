// SPDX-License-Identifier: GPL-3.0-or-later
// endmill plan: from a surface to economic cutter locations.

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <set>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/facet_list.h"
#include "cli/mesh_remarks.h"
#include "cli/plan_files.h"
#include "cli/plan_oriented.h"
#include "cli/plan_setups.h"
#include "cli/plan_strategy.h"
#include "cli/plan_text.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "cli/view.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/path_file.h"
#include "endmill/files/setup_file.h"
#include "endmill/planning/planned_path.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/tool_side.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

// Default height of the tip for rapid moves above the highest point of a mesh, mm.
constexpr double clear_above_mesh = 5;

// The diameter of the ball; an error names the limit of the surface.
double chosen_diameter(const std::optional<double>& asked,
                       const std::optional<CutterLimit>& limit)
{
    if (const std::optional<double> diameter = fitting_diameter(asked, limit))
        return *diameter;
    if (asked)
        throw GeometryError{fmt::format(
            "--cutter ball:{}: found radius {} mm; expected a smaller radius than the "
            "limit of the surface, {} mm at {}",
            to_text(*asked), to_text(*asked / 2), shown_limit(limit->radius_mm),
            place_text(limit->at, limit->point))};
    throw GeometryError{fmt::format(
        "no ball of {:g} to {:g} mm diameter fits; expected --cutter with a radius "
        "below {} mm, the limit of the surface at {}",
        stock_diameters.front(), stock_diameters.back(), shown_limit(limit->radius_mm),
        place_text(limit->at, limit->point))};
}

// Fills in the defaults of options that were not given.
// \param highest the default of the safe height, mm.
void complete(PlanOptions& options, double diameter, double highest)
{
    IsoParametricOptions& planning = options.planning;
    const PlanTolerances tolerances =
        plan_tolerances(options.requested, options.mode, BallCutter{diameter / 2});
    planning.chord_tolerance = tolerances.chord;
    planning.scallop_height = tolerances.scallop_height;
    options.motion = tolerances.motion;
    if (planning.scallop_height >= diameter)
        throw DomainError{"--scallop " + to_text(planning.scallop_height) +
                          ": expected a height below the ball's diameter, " +
                          to_text(diameter) + " mm"};
    if (options.strategy != StrategyChoice::Iso &&
        planning.scallop_height >= diameter / 2)
        throw DomainError{"--scallop " + to_text(planning.scallop_height) +
                          ": expected a height below the ball's radius, " +
                          to_text(diameter / 2) + " mm, with --strategy " +
                          strategy_word(options.strategy)};
    if (options.mode == Planner::Verified && options.motion.inner >= diameter / 2)
        throw DomainError{"--inner-tolerance " + to_text(options.motion.inner) +
                          ": expected a depth below the ball's radius, " +
                          to_text(diameter / 2) + " mm"};
    if (options.motion.inner == 0 && options.motion.outer >= diameter / 2)
        throw DomainError{"--outer-tolerance " + to_text(options.motion.outer) +
                          ": expected a height below the ball's radius, " +
                          to_text(diameter / 2) + " mm, with --inner-tolerance 0"};
    planning.link.safe_height = options.safe_height.value_or(highest);
    planning.most_points = most_path_points(options.common.limits.max_memory_gib);
}

// Reports on standard error that the path gouges, and how to avoid it.
void report_gouge(const KnownGouge& gouge, const PlanOptions& options)
{
    const std::string better =
        options.mode == Planner::Paper ? "; --mode verified keeps the tolerance" : "";
    report_error(
        "E_GOUGE",
        fmt::format("{}: the path along {} gouges the part {} mm deep with "
                    "--mode {}, beyond the inner tolerance of {} mm{}",
                    options.part.path, gouge.along == Parameter::U ? "u" : "v",
                    shown_against(gouge.depth_mm, options.motion.inner),
                    mode_word(options.mode), shown_limit(options.motion.inner), better),
        ExitCode::No, options.common.json_errors);
}

// Height of the tip for rapid moves over a part, unless another height is asked for, mm.
double clear_height(const Part& part, const Vec3& axis)
{
    const auto* mesh = std::get_if<TriangleMesh>(&part);
    if (!mesh)
        return default_safe_height(std::get<std::vector<Surface>>(part), axis);
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vec3& point : mesh->points())
        highest = std::max(highest, axis.dot(point));
    return highest + clear_above_mesh;
}

// A part that the path must not enter, without degenerate and repeated triangles.
std::optional<Part> guard_of(const PlanOptions& options)
{
    if (options.guard.path.empty())
        return std::nullopt;
    Part part = read_part_for(options.guard, options.common).part;
    if (auto* mesh = std::get_if<TriangleMesh>(&part)) {
        CleanedMesh cleaned = without_degenerate_or_duplicate(*mesh);
        if (cleaned.mesh.triangles().empty())
            throw GeometryError{options.guard.path + ": the protected part is empty"};
        part = std::move(cleaned.mesh);
    }
    return part;
}

// Removes degenerate and repeated triangles, with remarks on the mesh.
void clean_mesh(PartFile& file, const PlanOptions& options)
{
    auto& mesh = std::get<TriangleMesh>(file.part);
    CleanedMesh cleaned = without_degenerate_or_duplicate(mesh);
    const std::string place = options.part.path + ": ";
    for (std::string remark : mesh_remarks(cleaned))
        warn(options.common, remark.insert(0, place));
    mesh = std::move(cleaned.mesh);
}

// The context of a mesh, without degenerate and repeated triangles.
// \param least_clear the default of the safe height is at least this, mm.
PlanContext mesh_context(PartFile& file, PlanOptions& options, double least_clear)
{
    const std::string& path = options.part.path;
    if (options.strategy == StrategyChoice::Iso ||
        options.strategy == StrategyChoice::IsoU ||
        options.strategy == StrategyChoice::IsoV)
        throw DomainError{
            path +
            ": found a mesh; plan expects a surface file (endmill-surface/1) with "
            "--strategy " +
            strategy_word(options.strategy) +
            ", or for a mesh another --strategy, such as best"};
    if (options.required != RequiredContinuity::None)
        throw DomainError{path + ": found a mesh; --require g1 expects a surface file"};
    if (!options.cutter)
        throw DomainError{path +
                          ": found a mesh, whose curvature is not known; expected "
                          "--cutter ball:DIAMETER"};
    clean_mesh(file, options);
    complete(options, 2 * options.cutter->radius(),
             std::max(least_clear, clear_height(file.part, options.planning.link.axis)));
    return {file.name, file.source, {}, {}, *options.cutter, false, true};
}

// The context of surfaces that the ball fits.
PlanContext surface_context(const PartFile& file, PlanOptions& options,
                            const SurfaceContinuity& continuity, double least_clear)
{
    const auto& surfaces = std::get<std::vector<Surface>>(file.part);
    const Vec3& axis = options.planning.link.axis;
    const std::vector<double> sides = tool_side_signs(surfaces, axis);
    require_reachable(surfaces, axis, sides);
    const bool is_several = surfaces.size() > 1;
    const double highest = std::max(least_clear, clear_height(file.part, axis));
    if (options.cutter && !options.cutter->is_ball()) {
        complete(options, 2 * options.cutter->radius(), highest);
        return {file.name, file.source, continuity, {}, *options.cutter, is_several};
    }
    const auto limit = largest_cutter(surfaces, sides);
    const auto asked = options.cutter ? std::optional{2 * options.cutter->radius()}
                                      : std::optional<double>{};
    const double diameter = chosen_diameter(asked, limit);
    complete(options, diameter, highest);
    return {file.name, file.source, continuity, limit, Cutter::ball(diameter / 2),
            is_several};
}

// The context of a part for a tool whose axis turns.
PlanContext oriented_context(PartFile& file, PlanOptions& options,
                             const SurfaceContinuity& continuity)
{
    const auto* surfaces = std::get_if<std::vector<Surface>>(&file.part);
    complete_for_oriented_part(options, surfaces == nullptr);
    if (!surfaces)
        clean_mesh(file, options);
    complete(options, 2 * options.cutter->radius(),
             clear_height(file.part, options.planning.link.axis));
    return {file.name, file.source,     continuity,
            {},        *options.cutter, surfaces && surfaces->size() > 1,
            !surfaces};
}

// How the part stands while it is planned: as in the setup, or turned by the smallest angle
// that makes the tool axis +z. The axis becomes that of the setup.
Eigen::Matrix3d frame_of(PlanOptions& options)
{
    Vec3& axis = options.planning.link.axis;
    if (options.setup.empty())
        return upright_rotation(axis);
    const ClampedPart pose = read_clamped_part(options.setup, options.common.limits);
    axis = pose.part_to_machine.row(2).transpose().normalized();
    return pose.part_to_machine;
}

// The facets that stay uncut: those of --skip-facets, and those of faces that --face does not
// name. By their numbers in the file; ascending.
std::vector<std::size_t> uncut_facets(const PartFile& file, const PlanOptions& options)
{
    std::vector<std::size_t> listed =
        skipped_facets(options.skip_facets, file, options.common);
    if (options.faces.empty())
        return listed;
    const std::vector<std::size_t> others =
        facets_of_other_faces(options.faces, file, options.part.path);
    std::vector<std::size_t> all;
    std::ranges::set_union(listed, others, std::back_inserter(all));
    return all;
}

// Checks that each chosen face has facets that face the tool. Says how much of these faces is
// upright or faces away: it is neither cut nor judged.
void require_faces_towards_tool(const PartFile& file, const PlanOptions& options)
{
    const auto* mesh = std::get_if<TriangleMesh>(&file.part);
    if (!mesh || options.axis_mode || !options.setups.empty())
        return;
    constexpr double least_cosine = 1e-6;  // of upright facets by rounding
    const Vec3& axis = options.planning.link.axis;
    std::set<int> towards;
    double left_mm2 = 0;
    for (std::size_t k = 0; k < file.face_numbers.size(); ++k) {
        const auto [a, b, c] = mesh->corners(k);
        const Vec3 across = (b - a).cross(c - a);
        if (across.dot(axis) > least_cosine * across.norm())
            towards.insert(file.face_numbers[k]);
        else if (std::ranges::binary_search(options.faces, file.face_numbers[k]))
            left_mm2 += across.norm() / 2;
    }
    for (const int face : options.faces)
        if (!towards.contains(face))
            throw GeometryError{fmt::format(
                "--face {}: no triangle of this face faces the tool along {:g}, {:g}, "
                "{:g}; "
                "expected a face that the tool reaches from above, or another --axis or "
                "--setup",
                face, axis.x(), axis.y(), axis.z())};
    if (left_mm2 > 0)
        warn(options.common,
             fmt::format("{} mm2 of the chosen faces are upright or face away from the "
                         "tool; they are neither cut nor judged",
                         shown(left_mm2)));
}

// Checks that a list of facets leaves some to cut.
void require_facets_to_cut(std::span<const std::size_t> skipped, const PartFile& file,
                           const std::string& list)
{
    const auto* mesh = std::get_if<TriangleMesh>(&file.part);
    if (!mesh || list.empty() ||
        facets_in_mesh(skipped, file).size() < mesh->triangles().size())
        return;
    throw FormatError{"E_EMPTY",
                      {list, "", "the list names all facets of the mesh",
                       "at least one that is left to cut"}};
}

// Checks that the setup was found for this part. Surfaces are known by their name only, which
// may have changed.
void require_setup_of(const PartFile& file, const PlanOptions& options)
{
    const std::string& setup = options.setup.empty() ? options.setups : options.setup;
    if (setup.empty())
        return;
    const SetupSubject subject = read_setup_subject(setup, options.common.limits);
    if (const auto* mesh = std::get_if<TriangleMesh>(&file.part)) {
        const std::size_t facets =
            mesh->triangles().size() + file.degenerate_triangles.size();
        if (subject.facets && *subject.facets != facets)
            throw FormatError{"E_FACET",
                              {setup, "/facets", std::to_string(*subject.facets),
                               std::to_string(facets) + ", as " + options.part.path +
                                   " has: the setup is that of another part"}};
    } else if (!subject.name.empty() && subject.name != file.name) {
        warn(options.common, setup + ": a setup of the part " + printable(subject.name) +
                                 ", not of " + printable(file.name));
    }
}

// The part with the facets of its file; only for several setups.
std::optional<TriangleMesh> mesh_for_setups(const PartFile& file,
                                            const PlanOptions& options)
{
    if (options.setups.empty())
        return std::nullopt;
    if (!std::holds_alternative<TriangleMesh>(file.part))
        throw DomainError{options.part.path +
                          ": found a surface; --setups expects a mesh (.stl, .obj, .ply, "
                          ".off)"};
    return mesh_with_file_numbers(file);
}

// The part without the facets that stay uncut; nothing if all are cut, or if the planner leaves
// them out.
std::optional<Part> part_to_cut(const PartFile& file,
                                std::span<const std::size_t> skipped,
                                const PlanOptions& options)
{
    if (skipped.empty() || !options.setups.empty() || options.axis_mode)
        return std::nullopt;
    const TriangleMesh cut =
        without_facets(std::get<TriangleMesh>(file.part), facets_in_mesh(skipped, file));
    return without_degenerate_or_duplicate(cut).mesh;
}

// Those of the triangles `facets` of a mesh that are left after it was cleaned, by their new
// numbers. \param facets ascending.
std::vector<std::size_t> numbers_after(const TriangleMesh& before,
                                       std::span<const std::size_t> facets,
                                       const TriangleMesh& after)
{
    std::vector<std::size_t> found;
    found.reserve(facets.size());
    std::size_t left = 0;  // triangles that are left so far
    auto next = facets.begin();
    for (std::size_t k = 0; k < before.triangles().size() && next != facets.end(); ++k) {
        const bool is_left = left < after.triangles().size() &&
                             before.triangles()[k] == after.triangles()[left];
        if (*next == k) {
            if (is_left)
                found.push_back(left);
            ++next;
        }
        left += is_left ? 1 : 0;
    }
    return found;
}

// Continuity of the surfaces; a break is refused or a warning.
struct KnownContinuity {
    SurfaceContinuity found{};
    bool is_refused = false;
};
KnownContinuity continuity_of(const PartFile& file, const PlanOptions& options)
{
    const auto* surfaces = std::get_if<std::vector<Surface>>(&file.part);
    if (!surfaces)
        return {};
    KnownContinuity known{continuity(*surfaces)};
    if (known.found.continuity == Continuity::G1)
        return known;
    known.is_refused = options.required == RequiredContinuity::G1;
    if (!known.is_refused)
        warn(options.common, options.part.path + ": " + break_text(known.found));
    return known;
}

// No input may be overwritten.
void protect_inputs(OutputFolder& folder, const PlanOptions& options)
{
    for (const std::string& file : {options.part.path, options.guard.path,
                                    options.skip_facets, options.setup, options.setups})
        if (!file.empty())
            folder.protect(file);
}

ExitCode run_plan(PlanOptions options)
{
    complete_strategy(options);
    refuse_idle_plan_options(options);
    require_within_extent("--safe-height", options.safe_height, options.common.limits);
    if (options.cutter)
        require_within_extent("--cutter", *options.cutter, options.common.limits);
    require_within_extent("--chord-tolerance", options.requested.chord,
                          options.common.limits);
    if (!options.guard.path.empty()) {
        PartPair pair = part_pair(options.part, options.guard.path);
        options.part = std::move(pair.part);
        options.guard = std::move(pair.guard);
    }
    const Eigen::Matrix3d frame = frame_of(options);
    PartFile file = read_part_for(options.part, options.common);
    std::optional<Part> guard = guard_of(options);
    const double least_clear = guard ? clear_height(*guard, options.planning.link.axis)
                                     : -std::numeric_limits<double>::infinity();
    const auto [found, is_refused] = continuity_of(file, options);
    if (is_refused)
        return refuse_break(options.part.path, found, options.common);
    std::vector<std::size_t> skipped = uncut_facets(file, options);
    if (!options.faces.empty())
        require_faces_towards_tool(file, options);
    require_facets_to_cut(skipped, file, options.skip_facets);
    require_setup_of(file, options);
    const std::optional<TriangleMesh> numbered = mesh_for_setups(file, options);
    std::optional<Part> cut = part_to_cut(file, skipped, options);
    const std::vector<std::size_t> skipped_as_read =
        skipped.empty() ? skipped : facets_in_mesh(skipped, file);
    const TriangleMesh as_read =
        skipped.empty() ? TriangleMesh{} : std::get<TriangleMesh>(file.part);
    const auto* surfaces = std::get_if<std::vector<Surface>>(&file.part);
    const PlanContext context = options.axis_mode ? oriented_context(file, options, found)
                                : surfaces
                                    ? surface_context(file, options, found, least_clear)
                                    : mesh_context(file, options, least_clear);
    if (cut)
        guard = std::exchange(file.part, *std::move(cut));

    std::vector<std::size_t> skipped_in_mesh;
    if (options.axis_mode && !skipped.empty())
        skipped_in_mesh =
            numbers_after(as_read, skipped_as_read, std::get<TriangleMesh>(file.part));

    OutputFolder folder{output_folder(options.part.path, "plan", options.common),
                        options.common.full_folder};
    protect_inputs(folder, options);
    const PlanTask task{
        file.part,
        surfaces ? std::span<const Surface>{*surfaces} : std::span<const Surface>{},
        context,
        options,
        guard ? &*guard : nullptr,
        frame,
        std::move(skipped),
        std::move(skipped_in_mesh)};
    const PlanResult result = numbered ? write_setups_plan(task, *numbered, folder)
                              : options.axis_mode ? write_oriented_plan(task, folder)
                              : options.strategy == StrategyChoice::Iso
                                  ? write_plan(task, folder)
                                  : write_strategy_plan(task, folder);
    folder.remove_unless_written("page.html");
    folder.publish();
    write_html(folder.path(), options.common);
    print_result(options.common, result.summary,
                 settings_text(context, options) + result.text + "written to " +
                     printable(folder.path().string()) + "\n");
    if (result.gouge)
        report_gouge(*result.gouge, options);
    const bool is_good =
        result.uncovered_places == 0 && !result.gouge && !result.is_undecided;
    return is_good ? ExitCode::Yes : ExitCode::No;
}

}  // namespace

void add_plan_command(CLI::App& program, Action& action)
{
    CLI::App* command =
        program.add_subcommand("plan", "plan finishing passes on a surface or a mesh");
    const auto options = std::make_shared<PlanOptions>();
    add_plan_options(*command, *options);
    command->footer(
        "Writes toolpath.csv, toolpath.vtp, toolpath.svg and summary.json to --output\n"
        "(default ./NAME-plan); --strategy iso writes to its folders u and v. --force\n"
        "replaces the files of an earlier run.\n\n"
        "Exit 1: a path gouges the part deeper than the inner tolerance (--mode paper "
        "may),\n"
        "--mode verified finds places that no pass covers, such as a crease, or a path "
        "by "
        "a\n"
        "--strategy other than iso is not judged clean.\n\n"
        "Example:\n"
        "  endmill plan datasets/surfaces/saddle.json --cutter ball:15 --scallop 0.5\n"
        "  endmill plan datasets/surfaces/saddle.json --cutter ball:15 --inner-tolerance "
        "0 --outer-tolerance 0.05 --direction u -o no-gouge\n"
        "  endmill plan datasets/surfaces/wavy.json --cutter ball:10 --chord-tolerance "
        "0.05 --direction u -o wavy\n"
        "  endmill plan datasets/surfaces/saddle.json --strategy iso -o iso");
    command->callback([options, &action] {
        action = [options] {
            return naming(options->part.path, [&] { return run_plan(*options); });
        };
    });
}

}  // namespace endmill
