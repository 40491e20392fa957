// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/path_facts.h"

#include <fmt/format.h>

#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/files/path_file.h"
#include "endmill/files/read_file.h"

namespace endmill {
namespace {

// The machine of a path or program, from which the poses of the tool follow.
Json machine_json(const PartOnMachine& setup)
{
    const Machine& machine = setup.machine;
    Json rows = Json::array();
    for (Eigen::Index k = 0; k < 3; ++k)
        rows.push_back(vector_json(setup.part_to_machine.row(k).transpose()));
    Json signs = Json::object();
    const auto& rotary = machine.configuration.rotary;
    for (std::size_t k = 0; k < rotary.size(); ++k)
        signs[std::string(1, rotary[k].letter)] = machine.word_signs[k];
    return {{"configuration", machine.configuration.word},
            {"pivot_mm", machine.pivot},
            {"table_offset_mm", vector_json(machine.table_offset)},
            {"axis_offset_mm", vector_json(machine.axis_offset)},
            {"word_sign", signs},
            {"tool_length_mm", setup.tool_length},
            {"part_to_machine", rows},
            {"clamp_mm", vector_json(setup.clamp)}};
}

}  // namespace

void add_path_totals(Json& summary, const PathTotals& totals)
{
    summary["cut_mm"] = totals.cut_mm;
    summary["plunge_mm"] = totals.plunge_mm;
    summary["link_mm"] = totals.link_mm;
    summary["rapid_mm"] = totals.rapid_mm;
    summary["time_min"] = totals.time_min ? Json(*totals.time_min) : Json(nullptr);
    summary["tools"] = totals.tools;
    summary["min_mm"] = totals.extent ? vector_json(totals.extent->low) : Json(nullptr);
    summary["max_mm"] = totals.extent ? vector_json(totals.extent->high) : Json(nullptr);
}

std::string path_totals_text(const Json& s)
{
    const auto length = [&](const char* key) { return shown(s[key].get<double>()); };
    std::string time = "time not known (no feeds)";
    if (!s["time_min"].is_null())
        time = shown_time(s["time_min"].get<double>()) + " min at feed";
    if (!s["time_min"].is_null() && s["rapid_mm"].get<double>() > 0)
        time += ", rapids not counted";
    return fmt::format(
        "  path        cuts {} mm, plunges {} mm, links {} mm, rapids {} mm; {}\n",
        length("cut_mm"), length("plunge_mm"), length("link_mm"), length("rapid_mm"),
        time);
}

std::string extent_text(const Json& s)
{
    std::string extent;
    for (std::size_t c = 0; c < 3; ++c)
        extent += fmt::format("{}{} {} to {}", c == 0 ? "" : ", ", "xyz"[c],
                              shown_coordinate(s["min_mm"][c].get<double>()),
                              shown_coordinate(s["max_mm"][c].get<double>()));
    return extent + " mm";
}

void number_points(ToolPath& path)
{
    for (std::size_t k = 0; k < path.points.size(); ++k)
        path.points[k].point = static_cast<int>(k);
}

void identify_path(Json& summary, std::size_t points, const std::string& sha256)
{
    summary["toolpath_points"] = points;
    summary["toolpath_sha256"] = sha256;
}

void add_source_path(Json& summary, const std::string& file, const ReadLimits& limits)
{
    summary["source_sha256"] = content_sha256(read_file(file, limits));
}

void add_machine_motion(Json& summary, const MachineMotion& motion)
{
    summary["interpolation"] = interpolation_name(motion.interpolation);
    summary["machine"] = machine_json(motion.setup);
}

}  // namespace endmill
