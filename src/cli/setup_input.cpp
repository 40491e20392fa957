// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_input.h"

#include <algorithm>
#include <numbers>
#include <span>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/facet_list.h"
#include "cli/progress.h"
#include "cli/setup_idle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/machining_data.h"
#include "endmill/files/setup_file.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/mesh_repair.h"
#include "endmill/surface/sampling.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// Memory of a facet: its triangle with half a point and a normal while it is sampled, its
// edges while they are checked, and the row of the visibility map.
constexpr double bytes_a_facet = 150;

// "1 edge belongs", "2 edges belong".
std::string belonging(std::size_t edges)
{
    return counted(edges, "edge") + (edges == 1 ? " belongs" : " belong");
}

void take_mesh(SetupInput& input, TriangleMesh mesh)
{
    // As in every other command, edges are counted without duplicate triangles.
    const CleanedMesh cleaned = without_degenerate_or_duplicate(mesh);
    const MeshReport checks = mesh_report(cleaned.mesh);
    if (checks.boundary_edges > 0)
        input.remarks.push_back(
            fmt::format("{} to one triangle: the part is open, so all triangles block "
                        "from both sides",
                        belonging(checks.boundary_edges)));
    if (checks.non_manifold_edges > 0)
        input.remarks.push_back(fmt::format("{} to more than two triangles",
                                            belonging(checks.non_manifold_edges)));
    if (cleaned.duplicate_triangles > 0)
        input.remarks.push_back(
            fmt::format("{} an earlier triangle; such triangles block each other",
                        counted(cleaned.duplicate_triangles, "triangle") +
                            (cleaned.duplicate_triangles == 1 ? " repeats" : " repeat")));
    input.mesh = std::move(mesh);
}

// Samples the part within the memory limit.
SampledSurface sampled_within(std::span<const Surface> surfaces, double tolerance,
                              const ReadLimits& limits)
{
    const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    const auto most = static_cast<std::size_t>(std::min(
        limits.max_memory_gib * one_gib / bytes_a_facet, double(most_sampled_triangles)));
    try {
        return sampled(surfaces, sides, tolerance, most);
    } catch (const LimitError& error) {
        throw LimitError{fmt::format("{}; the limit is {:g} GiB (--max-memory)",
                                     error.what(), limits.max_memory_gib)};
    }
}

void take_surfaces(SetupInput& input, std::span<const Surface> surfaces,
                   const SetupCommandOptions& options)
{
    const double tolerance = options.chord_tolerance ? *options.chord_tolerance
                                                     : default_chord_tolerance(surfaces);
    SampledSurface sampled_part =
        sampled_within(surfaces, tolerance, options.common.limits);
    // Every surface is sampled, and nearly every one is open: no reason to warn.
    input.notes.push_back(fmt::format(
        "the surface is sampled as {} triangles, at most {:g} mm from it",
        sampled_part.mesh.triangles().size(), sampled_part.max_chord_error_mm));
    take_mesh(input, std::move(sampled_part.mesh));
    input.notes.insert(input.notes.end(), input.remarks.begin(), input.remarks.end());
    input.remarks.clear();
}

// Checks the memory of the visibility map before it is allocated.
void require_map_memory(const SetupInput& input, const SetupCommandOptions& options)
{
    const std::size_t cells = sphere_grid_cells(options.sphere);
    const std::size_t facets = input.mesh.triangles().size();
    // A cell needs one bit for each facet, and a triangle, half a corner point, a
    // centre and a solid angle.
    // Without the skipped facets there is a second map. The search keeps the different cones
    // as rows and as a map; there are at most as many as facets.
    const int maps = options.skip_facets.empty() ? 3 : 4;
    const double bytes_per_cell = maps * static_cast<double>(facets) / 8 +
                                  sizeof(Triangle) + 1.5 * sizeof(Vec3) + sizeof(double);
    const double gib = static_cast<double>(cells) * bytes_per_cell / one_gib;
    if (gib > options.common.limits.max_memory_gib)
        throw LimitError{fmt::format(
            "the visibility of {} facets from {} directions and the search for a setup "
            "need about {:.2g} GiB; the "
            "limit is {:g} GiB (--max-memory); a coarser --sphere needs less",
            facets, cells, gib, options.common.limits.max_memory_gib)};
}

void take_visibility(SetupInput& input, const SetupCommandOptions& options)
{
    if (options.from_visibility.empty()) {
        require_map_memory(input, options);
        input.grid = sphere_grid(options.sphere);
        return;
    }
    StoredVisibility known =
        read_visibility(options.from_visibility, input.mesh, options.common.limits);
    if (known.tool != body_text(input.tool))
        throw DomainError{
            options.from_visibility +
            ": found the visibility for another tool; expected the visibility " +
            (options.tool.empty() ? "without a tool" : "for " + options.tool)};
    input.grid = sphere_grid(known.grid);
    input.known_visibility = std::move(known);
}

}  // namespace

// Remarks that R2 of A,B is not used beyond a quarter turn: poses beyond it repeat
// those of the opposite side.
void remark_cut_limits(SetupInput& input)
{
    constexpr double quarter = std::numbers::pi / 2;
    for (const SearchedMachine& machine : input.machines) {
        const RotaryRange& theta = machine.machine.rotary.theta;
        const bool is_given = theta != RotaryRange{};
        if (machine.machine.configuration.family == RotaryFamily::AB && is_given &&
            (theta.from < -quarter || theta.to > quarter))
            input.remarks.push_back(machine.name +
                                    ": rotations of R2 beyond 90 degrees are not used");
    }
}

std::string body_text(const std::optional<Tool>& tool)
{
    std::string text;
    for (const ToolCylinder& cylinder :
         tool ? tool_body(*tool) : std::vector<ToolCylinder>{})
        text +=
            fmt::format("{}{}:{}:{}", text.empty() ? "" : ",", to_text(cylinder.diameter),
                        to_text(cylinder.from), to_text(cylinder.to));
    return text;
}

SetupInput read_setup_input(const SetupCommandOptions& options)
{
    SetupInput input;
    input.machines = setup_machines(options);
    refuse_options_idle_on(input.machines, options);
    if (!options.tool.empty())
        input.tool = read_tool(options.tool, options.common.limits);
    constexpr std::size_t longest_body = 1000;  // characters in a visibility file
    if (body_text(input.tool).size() > longest_body)
        throw DomainError{options.tool +
                          ": found too many cylinders in shank and holder; expected at "
                          "most 1000 characters in the visibility file"};
    PartFile file = read_part_for(options.part, options.common);
    input.name = file.name;
    input.source = file.source;
    input.notes = std::move(file.notes);
    const ProgressLine progress{"checking the mesh", options.common};
    if (auto* mesh = std::get_if<TriangleMesh>(&file.part)) {
        if (options.chord_tolerance)
            throw DomainError{"--chord-tolerance: found with a mesh; expected a surface"};
        // Degenerate facets have no cone and block no direction.
        const bool has_degenerate = !file.degenerate_triangles.empty();
        TriangleMesh numbered =
            has_degenerate ? mesh_with_file_numbers(file) : TriangleMesh{};
        take_mesh(input, std::move(*mesh));
        if (has_degenerate)
            input.mesh = std::move(numbered);
    } else {
        take_surfaces(input, std::get<std::vector<Surface>>(file.part), options);
    }
    if (!options.skip_facets.empty())
        input.skipped = read_facet_list(
            options.skip_facets, input.mesh.triangles().size(), options.common.limits);
    take_visibility(input, options);
    remark_cut_limits(input);
    return input;
}

}  // namespace endmill
