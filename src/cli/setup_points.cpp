// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_points.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cli/answer.h"
#include "cli/setup_machine.h"
#include "cli/setup_summary.h"
#include "cli/shown_numbers.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/input_csv.h"
#include "endmill/setup/pose_search.h"

namespace endmill {
namespace {

SearchedMachine machine_for_points(const SetupCommandOptions& options)
{
    if (options.mode == SetupMode::WholeCones)
        throw DomainError{
            "--mode set: found with --points; expected paper, paper-literal or "
            "corrected: "
            "single directions have no cones"};
    const std::vector<SearchedMachine> machines = setup_machines(options);
    const MachineConfiguration& configuration = machines.front().machine.configuration;
    const bool is_other_machine = configuration.is_valid() && !configuration.family;
    if (machines.size() > 1 || is_other_machine)
        throw DomainError{
            "--points: expected one machine with two rotary axes, or --family"};
    return machines.front();
}

// Azimuth of the rotary axis across the tool axis: R1 of A,B, R2 of C,A.
Json azimuth_deg(const Vec3& axis)
{
    return Angle::radians(std::atan2(axis.y(), axis.x())).written_degrees();
}

Json points_summary(const SearchedMachine& machine, const PoseSearchResult& search,
                    const SetupCommandOptions& options, std::size_t count)
{
    const bool is_ca = machine.machine.configuration.family == RotaryFamily::CA;
    const std::optional<FittedPose>& reported =
        search.feasible ? search.feasible : search.least;
    Json summary = machine_json(machine);
    summary.update(Json{{"mode", setup_mode_word(options.mode)},
                        {"points", count},
                        {"status", setup_status_word(search.status)},
                        {"machinable", search.feasible.has_value()}});
    summary.update(limits_json(machine.machine.rotary));
    summary.update(pose_json(reported));
    const char* azimuth_key = is_ca ? "r2_azimuth_deg" : "r1_azimuth_deg";
    summary["width_deg"] = nullptr;
    summary["phi_range_deg"] = nullptr;
    summary["theta_range_deg"] = nullptr;
    summary[azimuth_key] = nullptr;
    summary["rigid"] = nullptr;
    if (reported) {
        const RotaryRange& window = is_ca ? reported->theta : reported->phi;
        summary["width_deg"] = Angle::radians(window.to - window.from).written_degrees();
        summary["phi_range_deg"] = range_json(reported->phi);
        summary["theta_range_deg"] = range_json(reported->theta);
        summary[azimuth_key] =
            azimuth_deg(is_ca ? reported->pose.r2_axis : reported->pose.r1_axis);
        summary["rigid"] = reported->is_rigid;
    }
    summary["mar"] = search.least ? pose_json(search.least) : Json{};
    return summary;
}

// One line for the answer, one for the reason or the pose, one for the azimuth.
std::string points_text(const Json& s, const std::string& file)
{
    const bool is_machinable = s["machinable"].get<bool>();
    const Json& machine = s["configuration"].is_null() ? s["type"] : s["configuration"];
    std::string text =
        fmt::format("{}: {} {} in one setup on {}, mode {}\n", printable(file),
                    counted(s["points"].get<std::size_t>(), "direction"),
                    is_machinable ? "can be reached" : "cannot be reached",
                    machine.get<std::string>(), s["mode"].get<std::string>());
    if (!s["reason"].is_null())
        text += "  reason       " + s["reason"].get<std::string>() + "\n";
    else if (s["area_deg2"].is_null())
        text += "  reason       the directions fit in no open hemisphere\n";
    text += setup_pose_text(s, is_machinable);
    for (const auto& [key, name] :
         {std::pair{"r1_azimuth_deg", "R1"}, {"r2_azimuth_deg", "R2"}})
        if (s.contains(key) && !s[key].is_null())
            text += fmt::format(
                "  azimuth      {} degrees: {}, the rotary axis across the tool\n",
                shown_degrees(s[key].get<double>()), name);
    return text;
}

}  // namespace

ExitCode run_setup_points(const SetupCommandOptions& options)
{
    const SearchedMachine machine = machine_for_points(options);
    const MachineConfiguration& configuration = machine.machine.configuration;
    const std::vector<Vec3> directions =
        read_directions(options.points, options.common.limits);
    PoseSearchResult search;  // stays empty if the machine is not valid
    if (configuration.family)
        search = pose_fit(Vec3::UnitZ(), directions,
                          {.family = *configuration.family,
                           .mode = options.mode,
                           .limits = machine.machine.rotary,
                           .order = rotary_order(configuration)});
    const Json summary = points_summary(machine, search, options, directions.size());
    give_answer(options.common, {options.points, machine.file}, summary,
                points_text(summary, options.points));
    return search.feasible ? ExitCode::Yes : ExitCode::No;
}

}  // namespace endmill
