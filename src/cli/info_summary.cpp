// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/info_summary.h"

#include <span>
#include <vector>

#include <fmt/format.h>

#include "cli/surface_facts.h"
#include "endmill/surface/area.h"
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

// A number of a summary for a person: six digits and no minus zero, or "none".
std::string shown(const Json& number)
{
    return number.is_null() ? "none" : fmt::format("{:.6g}", number.get<double>() + 0.0);
}

std::string place_shown(const Json& place)
{
    if (place.is_null())
        return "";
    const std::string patch =
        place.contains("patch") ? " patch " + shown(place["patch"]) + "," : "";
    return ", at" + patch + " u " + shown(place["u"]) + ", v " + shown(place["v"]);
}

}  // namespace

Json info_summary(const SurfaceFile& file, const SurfaceContinuity& continuity,
                  const Vec3& axis)
{
    const std::span<const Surface> surfaces = file.surfaces;
    const bool several = surfaces.size() > 1;
    const std::vector<double> sides = tool_side_signs(surfaces, axis);
    const auto curvature = curvature_range(surfaces, sides);
    Json summary{{"name", file.name}, {"source", file.source}};
    for (const Vec3 along : {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()})
        summary["size_mm"].push_back(extent(surfaces, along).length());
    summary["area_mm2"] = area(surfaces);
    add_patches(summary, surfaces);
    add_continuity(summary, continuity, several);
    summary["min_curvature_per_mm"] = curvature ? Json(curvature->least) : Json(nullptr);
    summary["max_curvature_per_mm"] =
        curvature ? Json(curvature->greatest) : Json(nullptr);
    add_cutter_limit(summary, largest_cutter(surfaces, sides), several);
    const auto local = largest_cutter_by_curvature(surfaces, sides);
    summary["max_cutter_radius_local_mm"] =
        local ? Json(local->radius_mm) : Json(nullptr);
    summary["axis"] = vector_json(axis);
    summary["unreachable_at"] = unreachable_json(surfaces, axis, sides);
    return summary;
}

std::string info_text(const Json& s)
{
    return fmt::format(
        "{}: {}\n"
        "size             {} x {} x {} mm\n"
        "area             {} mm2\n"
        "continuity       {}, worst break {} degrees{}\n"
        "curvature        {} to {} per mm (positive: convex)\n"
        "largest ball     {}{}\n"
        "from the axis    {}\n",
        s["name"].get<std::string>(), patches_text(s), shown(s["size_mm"][0]),
        shown(s["size_mm"][1]), shown(s["size_mm"][2]), shown(s["area_mm2"]),
        s["continuity"].get<std::string>(), shown(s["worst_break_deg"]),
        place_shown(s["worst_break_at"]), shown(s["min_curvature_per_mm"]),
        shown(s["max_curvature_per_mm"]),
        s["max_cutter_radius_mm"].is_null()
            ? "none: nothing is concave"
            : "radius " + shown(s["max_cutter_radius_mm"]) + " mm",
        place_shown(s["max_cutter_radius_at"]),
        s["unreachable_at"].is_null()
            ? "all of the surface can be touched"
            : "not all can be touched: not" + place_shown(s["unreachable_at"]).substr(1));
}

}  // namespace endmill
