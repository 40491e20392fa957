// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/info_summary.h"

#include <fmt/format.h>

#include "cli/surface_facts.h"
#include "endmill/surface/area.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

Json unreachable_json(const Surface& surface, const Vec3& axis, double side)
{
    const auto place = find_unreachable_place(surface, axis, side);
    return place ? place_json(place->at, place->point) : Json(nullptr);
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
    return ", at u " + shown(place["u"]) + ", v " + shown(place["v"]);
}

}  // namespace

Json info_summary(const SurfaceFile& file, const SurfaceContinuity& continuity,
                  const Vec3& axis)
{
    const Surface& surface = file.surface;
    const double side = tool_side_sign(surface, axis);
    const auto curvature = curvature_range(surface, side);
    Json summary{{"name", file.name}, {"source", file.source}};
    summary["size_mm"] = {extent(surface, Vec3::UnitX()).length(),
                          extent(surface, Vec3::UnitY()).length(),
                          extent(surface, Vec3::UnitZ()).length()};
    summary["area_mm2"] = area(surface);
    summary["patches"] = surface.patches(Parameter::U) * surface.patches(Parameter::V);
    summary["patches_u"] = surface.patches(Parameter::U);
    summary["patches_v"] = surface.patches(Parameter::V);
    add_continuity(summary, continuity);
    summary["min_curvature_per_mm"] = curvature ? Json(curvature->least) : Json(nullptr);
    summary["max_curvature_per_mm"] =
        curvature ? Json(curvature->greatest) : Json(nullptr);
    add_cutter_limit(summary, largest_cutter(surface, side));
    const auto local = largest_cutter_by_curvature(surface, side);
    summary["max_cutter_radius_local_mm"] =
        local ? Json(local->radius_mm) : Json(nullptr);
    summary["axis"] = vector_json(axis);
    summary["unreachable_at"] = unreachable_json(surface, axis, side);
    return summary;
}

std::string info_text(const Json& s)
{
    return fmt::format(
        "{}: {} x {} Bezier patches\n"
        "size             {} x {} x {} mm\n"
        "area             {} mm2\n"
        "continuity       {}, worst break {} degrees{}\n"
        "curvature        {} to {} per mm (positive: convex)\n"
        "largest ball     {}{}\n"
        "from the axis    {}\n",
        s["name"].get<std::string>(), s["patches_u"].get<int>(),
        s["patches_v"].get<int>(), shown(s["size_mm"][0]), shown(s["size_mm"][1]),
        shown(s["size_mm"][2]), shown(s["area_mm2"]), s["continuity"].get<std::string>(),
        shown(s["worst_break_deg"]), place_shown(s["worst_break_at"]),
        shown(s["min_curvature_per_mm"]), shown(s["max_curvature_per_mm"]),
        s["max_cutter_radius_mm"].is_null()
            ? "none: nothing is concave"
            : "radius " + shown(s["max_cutter_radius_mm"]) + " mm",
        place_shown(s["max_cutter_radius_at"]),
        s["unreachable_at"].is_null()
            ? "all of the surface can be touched"
            : "not all can be touched: not" + place_shown(s["unreachable_at"]).substr(1));
}

}  // namespace endmill
