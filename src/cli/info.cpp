// SPDX-License-Identifier: GPL-3.0-or-later
// endmill info: what a part is like, and which ball fits it.

#include <memory>

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/surface_facts.h"
#include "endmill/io/output_folder.h"
#include "endmill/surface/area.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

struct InfoOptions {
    CommonOptions common;
    std::string part;
    Vec3 axis = Vec3::UnitZ();
    bool g1_is_required = false;
};

Json unreachable_json(const Surface& surface, const Vec3& axis, double side)
{
    const auto place = find_unreachable_place(surface, axis, side);
    return place ? place_json(place->at, place->point) : Json(nullptr);
}

Json summarize(const SurfaceFile& file, const SurfaceContinuity& continuity,
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

std::string text(const Json& s)
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

ExitCode run_info(const InfoOptions& options)
{
    const SurfaceFile file = read_part(options.part, options.common);
    const SurfaceContinuity whole = continuity(file.surface);
    const Json summary = summarize(file, whole, options.axis);
    if (!options.common.output.empty()) {
        OutputFolder folder{options.common.output, options.common.force};
        folder.protect(options.part);
        folder.write("summary.json", summary.dump(2) + "\n");
        folder.publish();
    }
    print_result(options.common, summary, text(summary));
    if (whole.continuity == Continuity::G1)
        return ExitCode::Yes;
    if (options.g1_is_required)
        return refuse_break(options.part, whole, options.common);
    warn(options.common, options.part + ": " + break_text(whole));
    return ExitCode::Yes;
}

}  // namespace

void add_info_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "info", "size, area, continuity, curvature and largest ball cutter of a part");
    const auto options = std::make_shared<InfoOptions>();
    command->add_option("PART", options->part, "surface file (endmill-surface/1)")
        ->required();
    add_axis_option(*command, options->axis);
    add_require_option(*command, options->g1_is_required);
    add_common_options(*command, options->common);
    command->footer(
        "Prints; writes DIR/summary.json only with --output.\n\n"
        "Example:\n  endmill info datasets/surfaces/net_rot24_7D.json --json");
    command->callback(
        [options, &action] { action = [options] { return run_info(*options); }; });
}

}  // namespace endmill
