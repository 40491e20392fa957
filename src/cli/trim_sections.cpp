// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trim_sections.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "cli/console.h"
#include "cli/mesh_remarks.h"
#include "cli/progress.h"
#include "cli/trim_stages.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/cutter.h"
#include "endmill/cutter/plane_offset.h"
#include "endmill/drop_cutter/mesh_sections.h"
#include "endmill/files/input_csv.h"
#include "endmill/files/read_file.h"
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

double pitch_for(double scallop, const Cutter& cutter)
{
    const double highest = 2 * cutter.corner_radius();
    require_option(scallop < highest, "--scallop " + to_text(scallop) +
                                          ": expected a height below twice the corner "
                                          "radius, " +
                                          to_text(highest) + " mm");
    return level_path_interval(cutter, scallop);
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

// Memory of one point of an offset: the point, its copy in the result, and its text in
// the files.
constexpr double bytes_a_point = 230;

// Memory of one vertex of an offset mesh: point, contact, two triangles, and its place in a
// chain.
constexpr double bytes_an_offset_vertex = 110;

// Refuses a pocket. The loops at its corners lie outside the rest of its offset, where the
// rule for closed curves of the method `winding` cannot tell them from an outline.
void require_outline(const SectionCurve& profile)
{
    double twice_area = 0;
    const std::vector<SectionPoint>& points = profile.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const SectionPoint a = points[i] - points.front();
        const SectionPoint b = points[i + 1] - points.front();
        twice_area += a.x() * b.y() - b.x() * a.y();
    }
    if (profile.is_closed && twice_area > 0)
        throw GeometryError{
            "the closed curve through s = " + to_text(points.front().x()) +
            ", z = " + to_text(points.front().y()) +
            " mm runs counter-clockwise, so that the tool is inside; expected an outline "
            "that runs clockwise"};
}

// Replaces the curves of a file by their offsets for the cutter.
void offset_curves(const TrimOptions& options, TrimInput& input)
{
    const ProgressLine progress{"offsetting the curves", options.common};
    const Cutter& cutter = *options.offset;
    PolylineOffsetOptions rolling;
    rolling.rolls_around_corners = boundary_contact(options) == BoundaryContact::Contact;
    std::vector<SectionCurve> profiles = std::move(input.sections[0].curves);
    double points = 0;
    for (const SectionCurve& profile : profiles) {
        require_outline(profile);
        points += polyline_offset_size(cutter, profile.points, rolling);
    }
    require_memory(input.file, points * bytes_a_point, options.common.limits);
    std::vector<SectionCurve> offsets;
    Interval range{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
    for (const SectionCurve& profile : profiles) {
        PolylineOffset offset = polyline_offset(cutter, profile.points, rolling);
        range = {std::min(range.low, offset.low_s), std::max(range.high, offset.high_s)};
        // A closed arc may shrink to its centre.
        if (offset.points.size() >= 2)
            offsets.push_back({std::move(offset.points), profile.is_closed});
    }
    if (offsets.empty())
        throw GeometryError{"--offset leaves no curve; expected a smaller one"};
    input.sections[0].curves = arranged(std::move(offsets));
    input.curves = OffsetCurves{std::move(profiles), {range}};
}

TrimInput curves_input(const TrimOptions& options)
{
    TrimInput input;
    input.file = options.polyline;
    input.name = printable(std::filesystem::path{options.polyline}.stem().string());
    for (auto& curves : read_polyline_planes(options.polyline, options.common.limits))
        input.sections.push_back({std::move(curves), {}, {}, 0});
    require_option(!options.offset || input.sections.size() == 1,
                   "--offset: profiles in " + counted(input.sections.size(), "plane") +
                       "; expected all in one plane");
    if (options.offset)
        offset_curves(options, input);
    return input;
}

// The offset, whose vertices are limited by the memory.
OffsetMesh offset_within_memory(std::span<const Surface> surfaces,
                                const TrimOptions& options, OffsetOptions offset_options)
{
    const double gib = options.common.limits.max_memory_gib;
    offset_options.most_vertices =
        static_cast<std::size_t>(gib * one_gib / bytes_an_offset_vertex);
    try {
        return offset_mesh(surfaces, *options.cutter, offset_options);
    } catch (const LimitError& error) {
        const bool is_wide = options.allowance > options.cutter->radius();
        throw LimitError{std::string{error.what()} + " within " + to_text(gib) +
                         " GiB (--max-memory); a smaller " +
                         (is_wide ? "--allowance" : "cutter") + " needs less"};
    }
}

void add_surface_sections(std::vector<Surface> surfaces, const TrimOptions& options,
                          TrimInput& input)
{
    const std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    require_reachable(surfaces, Vec3::UnitZ(), sides);
    OffsetOptions offset_options;
    offset_options.grid_lines = options.grid;
    offset_options.boundary = boundary_contact(options);
    offset_options.allowance = options.allowance;
    const DriveFrame frame{Angle::degrees(options.direction_deg)};
    DrivePlanes planes = planes_over(extent_across(surfaces, frame), options);
    require_trimming_memory(
        {surfaces.size(), options.grid, planes.positions.size(), offset_options.boundary},
        options.common.limits.max_memory_gib);
    ProgressLine progress{"offsetting the surface", options.common};
    const auto start = Clock::now();
    OffsetMesh offset = offset_within_memory(surfaces, options, offset_options);
    const double offset_ms = milliseconds_since(start);
    progress.begin("slicing the offset", work_after(TrimStage::Slicing, options));
    const auto slicing = Clock::now();
    input.sections =
        slice(offset.mesh, planes, {offset.part_triangles, progress.shower()});
    const double slice_ms = milliseconds_since(slicing);
    auto ranges = path_ranges(offset, planes, input.sections);
    const double highest = extent(surfaces, Vec3::UnitZ()).high;
    input.part = CutPart{
        std::move(planes),
        OffsetPart{std::move(surfaces), std::move(offset), offset_ms, std::move(ranges)},
        highest, slice_ms};
}

// The passes over a mesh. Their chords take what dropping points leaves of the tolerance, on
// both sides of the curve.
MeshPasses passes_over(const DropCutter& larger, const DrivePlanes& planes,
                       const TrimOptions& options, ProgressLine& progress)
{
    MeshSectionOptions sampling;
    sampling.samples = options.grid;
    sampling.tolerance = options.tolerance - thin_tolerance(options);
    sampling.outer_tolerance = sampling.tolerance;
    sampling.beyond_borders = true;
    sampling.progress = [&progress](double share) { progress.show(share); };
    if (!options.scallop)
        return {planes, mesh_sections(larger, planes, sampling), 0};
    const double height = *options.scallop;
    return mesh_passes(larger, planes,
                       {.height = height,
                        .level_interval = pitch_for(height, *options.cutter),
                        .allowance = options.allowance},
                       sampling);
}

// Coordinates of a part differ by at least about this share of their size. A smaller tolerance
// cannot be kept, and would halve the steps of a curve down to the rounding.
constexpr double resolution_share = 1e-12;

void require_resolved_tolerance(const TriangleMesh& mesh, double tolerance)
{
    double size = 0;
    for (const Vec3& point : mesh.points())
        size = std::max(size, point.cwiseAbs().maxCoeff());
    require_option(tolerance >= resolution_share * size,
                   "--tolerance: found " + to_text(tolerance) +
                       " mm; expected at least " + to_text(resolution_share * size) +
                       " mm, the resolution of coordinates up to " + to_text(size) +
                       " mm");
}

// A mesh has no continuous normals to offset along. The drop cutter gives curves that
// need no trimming.
void add_mesh_sections(TriangleMesh part, const TrimOptions& options, TrimInput& input)
{
    require_option(!part.triangles().empty(), "the mesh has no triangles");
    require_option(!options.refine,
                   "--refine: a mesh has no surface to refine on; expected a surface");
    require_option(
        boundary_contact(options) == BoundaryContact::Contact,
        "--boundary none: the drop cutter always touches the borders of a mesh; expected "
        "--boundary contact");
    require_resolved_tolerance(part, options.tolerance);
    auto mesh = std::make_unique<const TriangleMesh>(std::move(part));
    const DriveFrame frame{Angle::degrees(options.direction_deg)};
    DrivePlanes planes = planes_over(extent_across(*mesh, frame), options);
    require_trimming_memory({0, options.grid, planes.positions.size()},
                            options.common.limits.max_memory_gib);
    ProgressLine progress{"dropping the cutter on the mesh", options.common};
    const auto start = Clock::now();
    DropCutter larger{*mesh, with_allowance(*options.cutter, options.allowance)};
    MeshPasses passes = passes_over(larger, planes, options, progress);
    for (auto& curves : passes.curves)
        input.sections.push_back({std::move(curves), {}, {}, 0});
    const double slice_ms = milliseconds_since(start);
    const double highest = std::ranges::max(mesh->points(), {}, [](const Vec3& point) {
                               return point.z();
                           }).z();
    input.part =
        CutPart{std::move(passes.planes),
                DroppedPart{std::move(mesh), std::move(larger), passes.added_planes},
                highest, slice_ms};
}

}  // namespace

std::span<const std::optional<Interval>> TrimInput::ranges() const
{
    if (curves)
        return curves->ranges;
    const OffsetPart* const surfaces = offset_part();
    return surfaces ? std::span{surfaces->ranges}
                    : std::span<const std::optional<Interval>>{};
}

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
    if (auto* mesh = std::get_if<TriangleMesh>(&file.part))
        add_mesh_sections(std::move(*mesh), options, input);
    else
        add_surface_sections(std::move(std::get<std::vector<Surface>>(file.part)),
                             options, input);
    return input;
}

double safe_height(const CutPart& part, const TrimOptions& options)
{
    return options.safe_height.value_or(part.highest + options.allowance + clear_above);
}

std::optional<double> pick_feed(const DrivePlanes& planes)
{
    const std::vector<double>& at = planes.positions;
    if (at.size() < 2)
        return std::nullopt;
    double greatest = 0;
    for (std::size_t k = 1; k < at.size(); ++k)
        greatest = std::max(greatest, at[k] - at[k - 1]);
    return greatest;
}

}  // namespace endmill
