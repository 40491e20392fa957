// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/info_summary.h"

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "cli/shown_numbers.h"
#include "endmill/core/text.h"
#include "endmill/mesh/mesh_checks.h"
#include "endmill/mesh/mesh_repair.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

Json unreachable_json(std::span<const Surface> surfaces, const Vec3& axis,
                      std::span<const double> sides)
{
    for (std::size_t number = 0; number < surfaces.size(); ++number)
        if (const auto place =
                find_unreachable_place(surfaces[number], axis, sides[number]))
            return place_json(place->at, place->point,
                              surfaces.size() > 1 ? std::optional{number} : std::nullopt);
    return nullptr;
}

void add_patches(Json& summary, std::span<const Surface> surfaces)
{
    int patches = 0;
    for (const Surface& surface : surfaces)
        patches += surface.patches(Parameter::U) * surface.patches(Parameter::V);
    summary["patches"] = patches;
    if (surfaces.size() > 1)
        return;
    summary["patches_u"] = surfaces.front().patches(Parameter::U);
    summary["patches_v"] = surfaces.front().patches(Parameter::V);
}

std::string patches_text(const Json& s)
{
    if (!s.contains("patches_u"))
        return fmt::format("{} separate Bezier patches", s["patches"].get<int>());
    return fmt::format("{} x {} Bezier patches", s["patches_u"].get<int>(),
                       s["patches_v"].get<int>());
}

// A number of a summary, rounded for the report, or "none".
std::string shown_or_none(const Json& number)
{
    return number.is_null() ? "none" : shown(number.get<double>());
}

// Number of the boundary loops, their total length and the length of the longest.
void add_boundary_loops(Json& summary, std::span<const BoundaryLoop> loops)
{
    double total = 0;
    double longest = 0;
    for (const BoundaryLoop& loop : loops) {
        total += loop.length;
        longest = std::max(longest, loop.length);
    }
    summary["boundary_loops"] = loops.size();
    summary["boundary_mm"] = total;
    summary["longest_boundary_loop_mm"] = loops.empty() ? Json(nullptr) : Json(longest);
}

// "3 boundary edges in 1 loop, 12 mm long", or "no boundary".
std::string boundary_text(const Json& s)
{
    const auto loops = s["boundary_loops"].get<std::size_t>();
    if (loops == 0)
        return "no boundary";
    std::string text =
        fmt::format("{} in {}, {} mm long",
                    counted(s["boundary_edges"].get<std::size_t>(), "boundary edge"),
                    counted(loops, "loop"), shown_or_none(s["boundary_mm"]));
    if (loops > 1)
        text += fmt::format(" in all, the longest {} mm",
                            shown_or_none(s["longest_boundary_loop_mm"]));
    return text;
}

std::string place_shown(const Json& place)
{
    if (place.is_null())
        return "";
    const std::string patch = place.contains("patch")
                                  ? fmt::format("patch {}, ", place["patch"].get<int>())
                                  : "";
    const Json& at = place["point_mm"];
    return " at " + patch +
           place_text({place["u"].get<double>(), place["v"].get<double>()},
                      {at[0].get<double>(), at[1].get<double>(), at[2].get<double>()});
}

// The largest break between two patches. A surface that is G1 has only breaks by rounding.
std::string break_shown(const Json& s)
{
    if (s["continuity"] == continuity_name(Continuity::G1))
        return "";
    return ", largest break " + shown_degrees(s["worst_break_deg"].get<double>()) +
           " degrees" + place_shown(s["worst_break_at"]);
}

std::string size_text(const Json& s)
{
    return fmt::format("  size          {} x {} x {} mm, area {} mm2\n",
                       shown_or_none(s["size_mm"][0]), shown_or_none(s["size_mm"][1]),
                       shown_or_none(s["size_mm"][2]), shown_or_none(s["area_mm2"]));
}

std::string limit_text(const Json& s)
{
    if (s["max_cutter_radius_mm"].is_null())
        return "no limit: the surface has no concavity";
    return fmt::format("radius below {} mm,{}",
                       shown_limit(s["max_cutter_radius_mm"].get<double>()),
                       place_shown(s["max_cutter_radius_at"]));
}

}  // namespace

Json surface_summary(const PartFile& file, const SurfaceContinuity& continuity,
                     const Vec3& axis)
{
    const std::span<const Surface> surfaces = std::get<std::vector<Surface>>(file.part);
    const bool several = surfaces.size() > 1;
    const std::vector<double> sides = tool_side_signs(surfaces, axis);
    const auto [range, local] = curvature_extremes(surfaces, sides);
    Json summary{{"name", file.name}, {"source", file.source}};
    for (const Vec3 along : {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()})
        summary["size_mm"].push_back(extent(surfaces, along).length());
    summary["area_mm2"] = area(surfaces);
    add_patches(summary, surfaces);
    add_continuity(summary, continuity, several);
    summary["min_curvature_per_mm"] = range ? Json(range->least) : Json(nullptr);
    summary["max_curvature_per_mm"] = range ? Json(range->greatest) : Json(nullptr);
    add_cutter_limit(summary, largest_cutter(surfaces, sides, local), several);
    summary["max_cutter_radius_local_mm"] =
        local ? Json(local->radius_mm) : Json(nullptr);
    summary["axis"] = vector_json(axis);
    summary["unreachable_at"] = unreachable_json(surfaces, axis, sides);
    return summary;
}

std::string surface_text(const Json& s)
{
    return fmt::format(
        "{}: {}, continuity {}{}\n"
        "{}"
        "  curvature     {} to {} per mm (positive: convex)\n"
        "  ball cutter   {}\n"
        "  tool axis     {}\n",
        s["name"].get<std::string>(), patches_text(s), s["continuity"].get<std::string>(),
        break_shown(s), size_text(s), shown_or_none(s["min_curvature_per_mm"]),
        shown_or_none(s["max_curvature_per_mm"]), limit_text(s),
        s["unreachable_at"].is_null()
            ? "the cutter can touch the whole surface"
            : "the cutter cannot touch the surface" + place_shown(s["unreachable_at"]));
}

Json mesh_summary(const PartFile& file, const PartOptions& options)
{
    const auto& mesh = std::get<TriangleMesh>(file.part);
    // As every other command, edges are counted without duplicate triangles.
    const bool is_clean = file.mesh_report->degenerate_triangles == 0 &&
                          file.mesh_report->duplicate_triangles == 0;
    const CleanedMesh cleaned =
        is_clean ? CleanedMesh{} : without_degenerate_or_duplicate(mesh);
    const TriangleMesh& sound = is_clean ? mesh : cleaned.mesh;
    const MeshReport report = is_clean ? *file.mesh_report : mesh_report(sound);
    Eigen::AlignedBox3d box;
    for (const Vec3& point : mesh.points())
        box.extend(point);
    Json summary{{"name", file.name}, {"source", file.source}};
    summary["size_mm"] = vector_json(box.sizes());
    summary["area_mm2"] = report.area;
    summary["triangles"] = mesh.triangles().size();
    summary["vertices"] = mesh.points().size();
    summary["components"] = report.components;
    summary["boundary_edges"] = report.boundary_edges;
    add_boundary_loops(summary, boundary_loops(sound, report.points_at_breaks));
    summary["non_manifold_edges"] = report.non_manifold_edges;
    summary["first_non_manifold_edge"] = report.first_non_manifold_edge
                                             ? Json(*report.first_non_manifold_edge)
                                             : Json(nullptr);
    summary["inconsistent_edges"] = report.inconsistent_edges;
    summary["degenerate"] = file.degenerate_triangles.size();
    summary["welded"] = file.welded_points;
    summary["duplicates"] = cleaned.duplicate_triangles;
    summary["volume_mm3"] = report.volume ? Json(*report.volume) : Json(nullptr);
    summary["units"] = length_unit_names[static_cast<std::size_t>(options.units)];
    summary["up"] = up_axis_names[static_cast<std::size_t>(options.up)];
    for (const char* key :
         {"patches", "continuity", "worst_break_deg", "min_curvature_per_mm",
          "max_curvature_per_mm", "max_cutter_radius_mm", "max_cutter_radius_at"})
        summary[key] = nullptr;
    return summary;
}

std::string mesh_text(const Json& s)
{
    const auto count = [&](const char* key, std::string_view thing) {
        return counted(s[key].get<std::size_t>(), thing);
    };
    return fmt::format(
        "{}: {}, {}, {}\n"
        "{}"
        "  volume        {}\n"
        "  edges         {}; {} of more than two triangles, {} between triangles of "
        "opposite orientation\n"
        "  triangles     {} degenerate (left out), {} duplicate\n",
        s["name"].get<std::string>(), count("triangles", "triangle"),
        count("vertices", "point"), count("components", "piece"), size_text(s),
        s["volume_mm3"].is_null()
            ? "none: the mesh is open, or its triangles face opposite sides"
            : shown_or_none(s["volume_mm3"]) + " mm3",
        boundary_text(s), count("non_manifold_edges", "edge"),
        count("inconsistent_edges", "edge"), s["degenerate"].get<std::size_t>(),
        s["duplicates"].get<std::size_t>());
}

}  // namespace endmill
