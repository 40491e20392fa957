// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_answer.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "cli/progress.h"
#include "cli/setup_nearest_cells.h"
#include "cli/setup_visibility.h"
#include "endmill/visibility/visibility.h"

namespace endmill {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// Progress of the search over whole cones, in the unit of its objective.
std::string set_progress_text(const WholeConeSearchProgress& now,
                              const SetupCommandOptions& options)
{
    const bool is_area = options.objective == SetupObjective::FlooredArea;
    const auto shown = [&](double value) {
        const double in_deg = Angle::radians(value).degrees();
        return is_area ? Angle::radians(in_deg).degrees() : in_deg;
    };
    std::string text =
        fmt::format("{} of at most {} nodes, bound {:.6g} {}", now.nodes,
                    options.max_nodes, shown(now.lower_bound), is_area ? "deg^2" : "deg");
    if (now.objective)
        text += fmt::format(", best {:.6g}", shown(*now.objective));
    if (now.objective && now.lower_bound > 0)
        text +=
            fmt::format(", gap {:.1f} %", 100 * (*now.objective / now.lower_bound - 1));
    return text;
}

MachineSetup setup_on(const SearchedMachine& machine, const SetupInput& input,
                      const SetupVisibility& visibility,
                      const SetupCommandOptions& options)
{
    ProgressLine progress{"searching for a setup", options.common};
    const double looks = 2 * static_cast<double>(visibility.map().cells());
    std::optional<Clamping> clamping;
    if (!machine.is_family)
        clamping =
            Clamping{options.clamp, input.tool ? input.tool->length : 0, options.travel};
    return machine_setup(
        {input.mesh, input.grid, visibility.searched()}, machine.machine,
        {.reach = {.arc_tolerance = Angle::degrees(options.arc_tolerance_deg)},
         .mode = options.mode,
         .whole_cones = {.objective = options.objective,
                         .floor_rad = Angle::degrees(options.floor_deg).radians(),
                         .gap = options.gap,
                         .max_nodes = static_cast<std::size_t>(options.max_nodes),
                         .progress =
                             [&](const WholeConeSearchProgress& now) {
                                 progress.begin("searching over whole cones");
                                 progress.show(
                                     set_progress_text(now, options),
                                     static_cast<double>(now.nodes) / options.max_nodes);
                             }},
         .nearest_cells =
             [&](const VisibilityMap& map, std::span<const Vec3> centres,
                 const NearestCellsVisit& visit) {
                 divided_nearest_cells(map, centres, visit, progress);
             },
         .cell_progress =
             [&](std::size_t done) {
                 progress.show(static_cast<double>(done) / looks);
                 if (options.mode == SetupMode::WholeCones &&
                     static_cast<double>(done) >= looks)
                     progress.begin("preparing the search over whole cones");
             }},
        clamping);
}

SetupCover several_setups(const SearchedMachine& machine, const SetupInput& input,
                          const VisibilityMap& map, const SetupCommandOptions& options,
                          std::size_t most)
{
    ProgressLine progress{
        most == 1 ? "looking for the facets that one setup misses" : "choosing setups",
        options.common};
    const RotaryReach reach{machine.machine.configuration, machine.machine.rotary,
                            Angle::degrees(options.arc_tolerance_deg)};
    return greedy_setups(map, input.grid.centres, reach, most,
                         [&](const SetupCoverProgress& now) {
                             progress.show(fmt::format("setup {}, {} of {} tool axes",
                                                       now.setup, now.tried, now.axes));
                         });
}

// Twice the vector area of a facet; zero for a degenerate one.
Vec3 normal_of(const TriangleMesh& mesh, std::size_t facet)
{
    const Triangle& triangle = mesh.triangles()[facet];
    const Vec3& a = mesh.points()[triangle[0]];
    return (mesh.points()[triangle[1]] - a).cross(mesh.points()[triangle[2]] - a);
}

double area_share(const TriangleMesh& mesh, std::span<const std::size_t> facets)
{
    double whole = 0;
    for (std::size_t facet = 0; facet < mesh.triangles().size(); ++facet)
        whole += normal_of(mesh, facet).norm();
    double share = 0;
    for (const std::size_t facet : facets)
        share += normal_of(mesh, facet).norm() / whole;
    return share;
}

// Some facets lose their cones, as facets without area have none.
PartVisibility without_cones(const PartVisibility& visibility,
                             std::span<const std::size_t> facets)
{
    PartVisibility left = visibility;
    for (std::size_t cell = 0; cell < left.map.cells(); ++cell) {
        const std::span<std::uint64_t> column = left.map.column(cell);
        for (const std::size_t facet : facets)
            column[facet / 64] &= ~(std::uint64_t{1} << facet % 64);
    }
    std::vector<std::size_t> dropped;
    dropped.reserve(left.dropped.size() + facets.size());
    std::ranges::set_union(visibility.dropped, facets, std::back_inserter(dropped));
    left.dropped = std::move(dropped);
    return left;
}

}  // namespace

SetupVisibility visibility_for(const SetupInput& input,
                               const SetupCommandOptions& options)
{
    const Clock::time_point start = Clock::now();
    SetupVisibility found;
    if (input.known_visibility) {
        found.file = *input.known_visibility;
    } else {
        found.file.grid = input.grid.name;
        found.file.incidence = Angle::degrees(options.incidence_deg);
        found.file.part_checksum = part_checksum(input.mesh);
        found.file.kind = options.visibility;
        found.file.tool = body_text(input.tool);
        found.file.visibility = divided_visibility(input, options);
    }
    if (!input.skipped.empty())
        found.without_skipped = without_cones(found.file.visibility, input.skipped);
    found.empty = empty_cones(found.searched());
    found.seconds = seconds_since(start);
    return found;
}

SetupAnswer answer_for(const SearchedMachine& machine, const SetupInput& input,
                       const SetupVisibility& visibility,
                       const SetupCommandOptions& options)
{
    const Clock::time_point start = Clock::now();
    SetupAnswer answer{.machine = &machine,
                       .setup = setup_on(machine, input, visibility, options)};
    if (options.max_setups > 1 && machine.machine.configuration.is_valid())
        answer.setups = several_setups(machine, input, visibility.map(), options,
                                       static_cast<std::size_t>(options.max_setups));
    answer.seconds = seconds_since(start);
    return answer;
}

std::optional<MissedFacets> missed_facets(const SetupAnswer& answer,
                                          const SetupInput& input,
                                          const SetupVisibility& visibility,
                                          const SetupCommandOptions& options)
{
    constexpr std::size_t most_hidden = 3;
    if (answer.setup.best.machinable != Answer::No ||
        !answer.machine->machine.configuration.is_valid())
        return std::nullopt;
    const SetupCover cover = answer.setups ? *answer.setups
                                           : several_setups(*answer.machine, input,
                                                            visibility.map(), options, 1);
    MissedFacets missed{visibility.empty, 0, {}};
    missed.facets.insert(missed.facets.end(), cover.uncovered.begin(),
                         cover.uncovered.end());
    for (std::size_t k = 1; k < cover.setups.size(); ++k)
        missed.facets.insert(missed.facets.end(), cover.setups[k].facets.begin(),
                             cover.setups[k].facets.end());
    std::ranges::sort(missed.facets);
    missed.area_share = area_share(input.mesh, missed.facets);
    for (const std::size_t facet : std::span{visibility.empty}.first(
             std::min(most_hidden, visibility.empty.size())))
        missed.hidden.push_back(
            {facet, hiding_facet(input.mesh, facet, normal_of(input.mesh, facet))});
    return missed;
}

}  // namespace endmill
