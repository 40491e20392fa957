// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trim_sections.h"

#include <chrono>
#include <filesystem>
#include <limits>

#include "cli/console.h"
#include "cli/mesh_remarks.h"
#include "cli/progress.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/cutter.h"
#include "endmill/drop_cutter/mesh_sections.h"
#include "endmill/files/input_csv.h"
#include "endmill/planning/path_interval.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/tool_side.h"
#include "endmill/trimming/trimmed_planes.h"

namespace endmill {
namespace {

constexpr int default_planes = 100;
constexpr double clear_above = 5;  // mm between part and rapids, as in `plan`

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Largest distance of planes for a scallop height on level ground. The flat bottom of a
// bull-nose cutter adds its width.
double pitch_for(double scallop, const Cutter& cutter)
{
    const double r = cutter.corner_radius();
    require_option(scallop < 2 * r, "--scallop " + to_text(scallop) +
                                        ": expected a height below twice the corner "
                                        "radius, " +
                                        to_text(2 * r) + " mm");
    return 2 * cutter.flat_radius() + path_interval(BallCutter{r}, 0, scallop).chord;
}

DrivePlanes planes_over(const Interval& across, const TrimOptions& options)
{
    const DriveFrame frame{Angle::degrees(options.direction_deg)};
    if (options.pitch)
        return drive_planes_by_pitch(frame, across, *options.pitch);
    if (options.scallop)
        return drive_planes_by_pitch(frame, across,
                                     pitch_for(*options.scallop, *options.cutter));
    return drive_planes(frame, across, options.planes.value_or(default_planes));
}

TrimInput curves_input(const TrimOptions& options)
{
    TrimInput input;
    input.file = options.polyline;
    input.name = printable(std::filesystem::path{options.polyline}.stem().string());
    input.sections.resize(1);
    input.sections[0].curves = read_polylines(options.polyline, options.common.limits);
    return input;
}

void add_surface_sections(const std::vector<Surface>& surfaces,
                          const TrimOptions& options, TrimInput& input)
{
    const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    require_reachable(surfaces, Vec3::UnitZ(), sides);
    OffsetOptions offset;
    offset.grid_lines = options.grid;
    offset.boundary = boundary_contact(options);
    offset.allowance = options.allowance;
    const DriveFrame frame{Angle::degrees(options.direction_deg)};
    input.planes = planes_over(extent_across(surfaces, frame), options);
    require_trimming_memory(
        {surfaces.size(), options.grid, input.planes->positions.size(), offset.boundary},
        options.common.limits.max_memory_gib);
    ProgressLine progress{"offsetting the surface", options.common};
    const auto start = Clock::now();
    input.offset = offset_mesh(surfaces, *options.cutter, offset);
    input.offset_ms = milliseconds_since(start);
    progress.begin("slicing the offset");
    const auto slicing = Clock::now();
    input.sections =
        slice(input.offset->mesh, *input.planes, {input.offset->part_triangles});
    input.slice_ms = milliseconds_since(slicing);
    input.ranges = path_ranges(*input.offset, *input.planes, input.sections);
    input.highest = extent(surfaces, Vec3::UnitZ()).high;
}

// A mesh has no continuous normals to offset along. The drop cutter gives curves that
// need no trimming.
void add_mesh_sections(const TriangleMesh& mesh, const TrimOptions& options,
                       TrimInput& input)
{
    require_option(!mesh.triangles().empty(), "the mesh has no triangles");
    require_option(!options.refine,
                   "--refine: a mesh has no surface to refine on; expected a surface");
    require_option(
        boundary_contact(options) == BoundaryContact::Contact,
        "--boundary none: the drop cutter always touches the borders of a mesh; expected "
        "--boundary contact");
    const DriveFrame frame{Angle::degrees(options.direction_deg)};
    Interval across{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    input.highest = across.high;
    for (const Vec3& point : mesh.points()) {
        across.low = std::min(across.low, frame.across(point));
        across.high = std::max(across.high, frame.across(point));
        input.highest = std::max(input.highest, point.z());
    }
    input.planes = planes_over(across, options);
    require_trimming_memory({0, options.grid, input.planes->positions.size()},
                            options.common.limits.max_memory_gib);
    const ProgressLine progress{"dropping the cutter on the mesh", options.common};
    const auto start = Clock::now();
    input.drop_cutter.emplace(mesh, with_allowance(*options.cutter, options.allowance));
    MeshSectionOptions sampling;
    sampling.samples = options.grid;
    sampling.tolerance = options.tolerance;
    for (auto& curves : mesh_sections(*input.drop_cutter, *input.planes, sampling))
        input.sections.push_back({std::move(curves), {}, {}, 0});
    input.slice_ms = milliseconds_since(start);
    // The clearance of the result is measured with the cutter itself, without the
    // allowance.
    input.drop_cutter.emplace(mesh, *options.cutter);
}

}  // namespace

TrimInput read_trim_input(const TrimOptions& options)
{
    if (!options.polyline.empty())
        return curves_input(options);
    TrimInput input;
    input.file = options.part.path;
    PartFile file = read_part_for(options.part, options.common);
    input.remarks = std::move(file.notes);
    if (auto* mesh = std::get_if<TriangleMesh>(&file.part)) {
        CleanedMesh cleaned = without_degenerate_or_duplicate(*mesh);
        for (std::string& remark : mesh_remarks(cleaned)) {
            warn(options.common, options.part.path + ": " + remark);
            input.remarks.push_back(std::move(remark));
        }
        *mesh = std::move(cleaned.mesh);
    }
    input.name = file.name;
    input.source = file.source;
    input.part = std::make_unique<const Part>(std::move(file.part));
    if (const auto* mesh = std::get_if<TriangleMesh>(&*input.part))
        add_mesh_sections(*mesh, options, input);
    else
        add_surface_sections(std::get<std::vector<Surface>>(*input.part), options, input);
    return input;
}

double safe_height(const TrimInput& input, const TrimOptions& options)
{
    return options.safe_height.value_or(input.highest + options.allowance + clear_above);
}

std::optional<double> pick_feed(const DrivePlanes& planes)
{
    const std::vector<double>& at = planes.positions;
    return at.size() < 2 ? std::nullopt : std::optional{at[1] - at[0]};
}

std::optional<double> level_scallop(double pitch, const Cutter& cutter)
{
    const double over = pitch - 2 * cutter.flat_radius();
    if (over <= 0)
        return 0;
    if (over >= 2 * cutter.corner_radius())
        return std::nullopt;
    return scallop_height(BallCutter{cutter.corner_radius()}, 0, over);
}

CreaseTest crease_test(const TrimInput& input, std::size_t plane)
{
    if (!input.offset)
        return {};
    return [&offset = *input.offset,
            &section = input.sections[plane]](const SegmentNumber& at) {
        const CrossedEdge& edge = section.edges[static_cast<std::size_t>(at.curve)]
                                               [static_cast<std::size_t>(at.point)];
        const auto is_concave = [&](std::int32_t vertex) {
            return offset.contacts[static_cast<std::size_t>(vertex)].kind ==
                   ContactKind::ConcaveCrease;
        };
        return is_concave(edge.below) || is_concave(edge.above);
    };
}

}  // namespace endmill
