// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_summary.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/setup_idle.h"
#include "cli/shown_numbers.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// Square degrees in one square radian.
constexpr double deg2_per_rad2 = (180 / std::numbers::pi) * (180 / std::numbers::pi);

double to_deg(double radians)
{
    return Angle::radians(radians).written_degrees() + 0.0;  // never -0
}

template <typename Value>
Json optional_json(const std::optional<Value>& value)
{
    return value ? Json(*value) : Json{};
}

Json pair_deg(const std::array<double, 2>& radians)
{
    return {to_deg(radians[0]), to_deg(radians[1])};
}

Json rows_json(const Eigen::Matrix3d& matrix)
{
    Json rows = Json::array();
    for (int r = 0; r < 3; ++r)
        rows.push_back(vector_json(matrix.row(r)));
    return rows;
}

std::string setup_type_word(const MachineConfiguration& configuration)
{
    if (configuration.family)
        return *configuration.family == RotaryFamily::CA ? "CA" : "AB";
    return fmt::format("{}-axis", configuration.axes());
}

bool is_set(const SetupCommandOptions& options)
{
    return options.mode == SetupMode::WholeCones;
}

// Adds the objective that was minimised. All modes but set minimise the area.
void add_objective(Json& summary, const SetupAnswer& answer,
                   const SetupCommandOptions& options)
{
    const bool is_area =
        !is_set(options) || options.objective == SetupObjective::FlooredArea;
    summary["objective"] =
        is_set(options) ? setup_objective_word(options.objective) : "area";
    const PartSetup& best = answer.setup.best;
    const auto shown = [&](const std::optional<double>& value) {
        if (!value)
            return Json{};
        return Json(is_area ? *value * deg2_per_rad2 : Angle::radians(*value).degrees());
    };
    summary[is_area ? "objective_deg2" : "objective_deg"] = shown(best.objective);
    summary[is_area ? "lower_bound_deg2" : "lower_bound_deg"] =
        best.certificate ? shown(best.certificate->lower_bound) : Json{};
}

void add_ranges(Json& summary, const SetupAnswer& answer,
                const SetupCommandOptions& options)
{
    const std::optional<FittedPose>& reported = answer.reported();
    const std::optional<RotaryFamily>& family =
        answer.machine->machine.configuration.family;
    summary["phi_range_deg"] = reported ? range_json(reported->phi) : Json{};
    summary["theta_range_deg"] = reported ? range_json(reported->theta) : Json{};
    summary["width_deg"] =
        reported && family ? Json(to_deg(pose_ranges(*family, *reported).width)) : Json{};
    summary["floored_area_deg2"] =
        optional_json(floored_area_deg2(answer.setup, options.floor_deg));
    summary["rigid"] = reported ? Json(reported->is_rigid) : Json{};
}

// Null if the linear axes have no limits, or if there was nothing to examine.
Json travel_json(const MachineSetup& setup)
{
    if (!setup.has_linear_limits() || setup.within_travel == Answer::Undecided)
        return {};
    return setup.within_travel == Answer::Yes;
}

// Slack of X, Y and Z; null for an axis without limits.
Json slack_json(const Vec3& slack)
{
    return {{"x", finite_or_null(slack.x())},
            {"y", finite_or_null(slack.y())},
            {"z", finite_or_null(slack.z())}};
}

// What --within-travel found. Null if there was no pose to examine, or no limit.
Json travel_search_json(const MachineSetup& setup)
{
    if (!setup.travel_search)
        return {};
    const auto& [poses, out_of_reach, pose, clamping] = *setup.travel_search;
    return {{"fits", setup.travel_search->fits()},
            {"poses", poses},
            {"out_of_reach", out_of_reach},
            {"clamp_mm", clamping ? vector_json(clamping->clamp) : Json{}},
            {"slack_mm", clamping ? slack_json(clamping->slack) : Json{}},
            {"pose", pose_json(pose)}};
}

void add_travel_keys(Json& summary, const SetupAnswer& answer,
                     const SetupCommandOptions& options)
{
    summary["clamp_mm"] = vector_json(answer.setup.clamp);
    if (options.travel == TravelRule::WithinLimits)
        summary["within_travel"] = travel_search_json(answer.setup);
    const std::optional<SetupTravel>& travel = answer.setup.travel;
    summary["travel_mm"] = nullptr;
    summary["clamp_centred_mm"] = nullptr;
    summary["travel_ok"] = travel_json(answer.setup);
    if (!travel)
        return;
    summary["travel_mm"] = {{"x", {travel->low.x(), travel->high.x()}},
                            {"y", {travel->low.y(), travel->high.y()}},
                            {"z", {travel->low.z(), travel->high.z()}}};
    summary["clamp_centred_mm"] = vector_json(travel->centred_clamp);
}

// Adds the list of setups. It is null with --max-setups 1, where the pose is the only
// setup.
void add_setups(Json& summary, const SetupAnswer& answer,
                const SetupCommandOptions& options)
{
    const bool has_empty_cones = !summary["empty_cones"].empty();
    summary["setups"] = nullptr;
    summary["uncovered"] = nullptr;
    summary["setups_lower_bound"] = nullptr;
    if (!answer.setups)
        return;
    Json setups = Json::array();
    for (const PartialSetup& setup : answer.setups->setups)
        setups.push_back({{"tool_axis", vector_json(setup.pose.tool_axis)},
                          {"r1_axis", vector_json(setup.pose.r1_axis)},
                          {"r2_axis", vector_json(setup.pose.r2_axis)},
                          {"facets", setup.facets}});
    summary["setups"] = setups;
    summary["uncovered"] = answer.setups->uncovered;
    const bool needs_two = is_set(options) &&
                           answer.setup.best.machinable == Answer::No &&
                           answer.setup.best.is_proved;
    if (!has_empty_cones)  // an empty cone makes every number of setups insufficient
        summary["setups_lower_bound"] = needs_two ? 2 : 1;
}

// Adds whether the rotary axes suffice, and whether the machine does.
void add_verdict(Json& keys, const MachineSetup& setup)
{
    const bool is_open = setup.best.machinable == Answer::Undecided;
    keys["rotary_ok"] = is_open ? Json{} : Json(setup.best.machinable == Answer::Yes);
    keys["machinable"] = is_open ? Json{} : Json(setup.is_machinable());
}

Json ranking(std::span<const SetupAnswer> answers, const SetupCommandOptions& options)
{
    Json list = Json::array();
    for (const SetupAnswer& answer : answers) {
        Json one{
            {"machine", printable(answer.machine->file.empty() ? answer.machine->name
                                                               : answer.machine->file)},
            {"configuration", answer.machine->machine.configuration.word}};
        add_verdict(one, answer.setup);
        one["travel_ok"] = travel_json(answer.setup);
        one["floored_area_deg2"] =
            optional_json(floored_area_deg2(answer.setup, options.floor_deg));
        list.push_back(std::move(one));
    }
    return list;
}

// Adds the facets that one setup misses, and what hides the first of those that no
// direction reaches. Null unless the answer is no.
void add_missed(Json& summary, const std::optional<MissedFacets>& missed)
{
    summary["missed_facets"] = missed ? Json(missed->facets) : Json{};
    summary["missed_area_share"] = missed ? Json(missed->area_share) : Json{};
    summary["hidden_facets"] = missed ? Json::array() : Json{};
    if (missed)
        for (const HiddenFacet& hidden : missed->hidden)
            summary["hidden_facets"].push_back(
                {{"facet", hidden.facet}, {"by", optional_json(hidden.by)}});
}

void add_search(Json& summary, const SetupAnswer& answer,
                const SetupCommandOptions& options)
{
    const PartSetup& best = answer.setup.best;
    add_verdict(summary, answer.setup);
    summary["proved"] = best.is_proved;
    // The status describes a pose, except that no open hemisphere rules out any pose.
    const bool has_status =
        answer.reported().has_value() || best.status == SetupStatus::NoOpenHemisphere;
    summary["status"] = has_status ? Json(setup_status_word(best.status)) : Json{};
    summary.update(pose_json(answer.reported()));
    add_ranges(summary, answer, options);
    add_objective(summary, answer, options);
    summary["part_to_machine"] =
        answer.setup.part_to_machine ? rows_json(*answer.setup.part_to_machine) : Json{};
    summary["mar"] = best.least ? pose_json(best.least) : Json{};
    summary["poses_tried"] = best.poses_tried;
    summary["poses_skipped"] = best.poses_skipped;
    summary["unresolved"] = best.certificate ? best.certificate->unresolved : 0;
    add_setups(summary, answer, options);
    add_missed(summary, answer.missed);
    add_travel_keys(summary, answer, options);
}

// The first of these facets.
std::string facet_numbers(const Json& facets)
{
    constexpr std::size_t most_shown = 10;
    std::string text;
    for (std::size_t k = 0; k < std::min(most_shown, facets.size()); ++k)
        text += fmt::format(" {}", facets[k].get<std::size_t>());
    return text + (facets.size() > most_shown ? " ..." : "");
}

// The first hidden facets and the facets that hide them.
std::string hidden_text(const Json& hidden, const Json& tool)
{
    std::string text;
    for (const Json& one : hidden) {
        const auto facet = one["facet"].get<std::size_t>();
        text += text.empty() ? "; " : ", ";
        if (!one["by"].is_null())
            text += fmt::format("facet {} hides {}", one["by"].get<std::size_t>(), facet);
        else if (!tool.is_null())
            text += fmt::format("shank and holder keep the tool from {}", facet);
        else
            text += fmt::format(
                "none hides {} along its normal (--sphere or --incidence-deg)", facet);
    }
    return text;
}

// What a setup of this type can turn: the ground on which facets are missed.
std::string reach_text(const Json& s)
{
    const std::string type = s["type"].get<std::string>();
    if (type == "3-axis")
        return "a 3-axis machine cuts from one direction, and the best one misses ";
    if (type == "4-axis")
        return "one rotary axis turns within its limits, and the best setup misses ";
    return "the best single setup within the limits misses ";
}

// Why the part is not machinable: the facets that one setup misses, and what hides them.
std::string missed_text(const Json& s)
{
    const Json& missed = s["missed_facets"];
    if (missed.is_null())
        return {};
    if (missed.empty())
        return fmt::format(
            "  reason       mode {} finds no pose within the limits, though one exists; "
            "{}\n",
            s["mode"].get<std::string>(),
            s["mode"] == "set" ? "expected a larger --max-nodes"
                               : "expected --mode set, which searches all poses");
    const Json& empty = s["empty_cones"];
    std::string text = "  reason       ";
    if (!empty.empty())
        text +=
            fmt::format("no direction reaches {}:{}{}", counted(empty.size(), "facet"),
                        facet_numbers(empty), hidden_text(s["hidden_facets"], s["tool"]));
    if (missed.size() > empty.size() || empty.empty())
        text += fmt::format("{}{}{}:{}", empty.empty() ? "" : "; ", reach_text(s),
                            counted(missed.size(), "facet"), facet_numbers(missed));
    const double percent = 100 * s["missed_area_share"].get<double>();
    return text + fmt::format(" ({} % of the area)\n", shown(percent));
}

std::string axis_text(const Json& axis)
{
    return fmt::format("({:.4f}, {:.4f}, {:.4f})", axis[0].get<double>(),
                       axis[1].get<double>(), axis[2].get<double>());
}

std::string clamp_text(const Json& clamp)
{
    return fmt::format("--clamp {},{},{}", shown_result(clamp[0].get<double>()),
                       shown_result(clamp[1].get<double>()),
                       shown_result(clamp[2].get<double>()));
}

// The slack of the axes that have limits, as "x 12.5, z 3".
std::string slack_text(const Json& slack)
{
    std::string text;
    for (const char* axis : {"x", "y", "z"})
        if (!slack[axis].is_null())
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", axis,
                                shown(slack[axis].get<double>()));
    return text;
}

// The answer of --within-travel.
std::string travel_search_text(const Json& found)
{
    const std::string poses = counted(found["poses"].get<std::size_t>(), "pose");
    if (found["clamp_mm"].is_null())
        return "  travel       " + poses +
               " tried; at each a facet has no direction within the limits\n";
    const std::string slack = slack_text(found["slack_mm"]);
    if (found["fits"].get<bool>())
        return fmt::format(
            "  travel       the linear axes reach all facets with {}, slack {} mm; {} "
            "tried\n",
            clamp_text(found["clamp_mm"]), slack, poses);
    const Json& axis = found["pose"]["tool_axis"];
    return fmt::format(
        "  travel       none of {} fits the linear axes; the nearest has the tool axis "
        "{} "
        "and with {} the slack {} mm\n",
        poses, axis_text(axis), clamp_text(found["clamp_mm"]), slack);
}

// Whether the linear axes reach all facets, and a clamping position that may help.
std::string travel_text(const Json& s)
{
    if (s.contains("within_travel") && !s["within_travel"].is_null())
        return travel_search_text(s["within_travel"]);
    if (s["travel_ok"].is_null())
        return {};
    if (s["travel_ok"].get<bool>())
        return "  travel       the linear axes reach all facets\n";
    if (s["travel_mm"].is_null())
        return "  travel       at this pose a facet has no direction within the limits\n";
    std::string text = "  travel       beyond the limits of the linear axes; needed:";
    for (const char* axis : {"x", "y", "z"})
        text += fmt::format(" {} {} to {}", axis,
                            shown_result(s["travel_mm"][axis][0].get<double>()),
                            shown_result(s["travel_mm"][axis][1].get<double>()));
    return text + " mm; " + clamp_text(s["clamp_centred_mm"]) + " centres the travel\n";
}

// The limitation of the mode, and a mode without it.
std::string better_mode_text(const Json& s)
{
    if (s["type"] != "CA" && s["type"] != "AB")
        return {};
    const std::string mode = s["mode"].get<std::string>();
    if (mode == "set")
        return {};
    const std::string limits = mode == "corrected"
                                   ? "mode corrected tries the centres of cells only"
                                   : "--mode corrected fits the pose exactly";
    return "  better mode  " + limits +
           "; --mode set searches all poses for whole cones\n";
}

std::string machinable_text(const Json& s)
{
    if (s["machinable"].is_null())
        return "undecided whether one setup suffices";
    if (!s["rotary_ok"].get<bool>())
        return "not machinable in one setup";
    if (s["machinable"].get<bool>())
        return "machinable in one setup";
    return s.contains("within_travel")
               ? "not machinable within the travel of the linear axes"
               : "not machinable at this clamping";
}

// Why the answer is open.
std::string undecided_text(const Json& s)
{
    if (!s["machinable"].is_null())
        return {};
    if (s["mode"] == "set")
        return fmt::format(
            "  reason       the search ended at {} nodes (--max-nodes) without a pose "
            "within the limits\n",
            s["max_nodes"].get<int>());
    return "  reason       the points of this mode fit no open hemisphere; try --mode "
           "set\n";
}

std::string range_text(const Json& range)
{
    if (range.is_null())
        return "none";
    return shown_degrees(range[0].get<double>()) + " to " +
           shown_degrees(range[1].get<double>());
}

// The ranges of the pose, or else, where the limits forbid them, those that it needs.
std::string ranges_text(const Json& s, bool is_within)
{
    std::string text = fmt::format(
        "  {}phi {}, theta {} degrees", is_within ? "ranges       " : "needed       ",
        range_text(s["phi_range_deg"]), range_text(s["theta_range_deg"]));
    if (!is_within)
        text += fmt::format(" (limits {} and {})", range_text(s["limits_phi_deg"]),
                            range_text(s["limits_theta_deg"]));
    if (s.contains("empty_cones") && !s["empty_cones"].empty())
        text += " for the other facets";
    text += fmt::format("; area {} deg^2", shown(s["area_deg2"].get<double>()));
    if (s["rigid"] == false)
        text += "; within the limits only as a mirror image";
    return text;
}

}  // namespace

Json machine_json(const SearchedMachine& machine)
{
    const MachineConfiguration& configuration = machine.machine.configuration;
    Json keys{{"machine", machine.file.empty() ? Json{} : Json(printable(machine.file))},
              {"configuration", machine.is_family ? Json{} : Json(configuration.word)},
              {"type", setup_type_word(configuration)}};
    keys["reason"] =
        configuration.is_valid() ? Json{} : Json(why_not_valid(configuration));
    return keys;
}

Json limits_json(const RotaryLimits& limits)
{
    return {{"limits_phi_deg", range_json(limits.phi)},
            {"limits_theta_deg", range_json(limits.theta)}};
}

Json range_json(const RotaryRange& range)
{
    return {to_deg(range.from), to_deg(range.to)};
}

std::string setup_status_word(SetupStatus status)
{
    switch (status) {
        case SetupStatus::Ok:
            return "ok";
        case SetupStatus::ThreeAxis:
            return "3-axis";
        case SetupStatus::FourAxis:
            return "4-axis";
        case SetupStatus::NoOpenHemisphere:
            return "not in an open hemisphere";
    }
    return {};
}

Json pose_json(const std::optional<FittedPose>& fit)
{
    if (!fit)
        return {{"area_deg2", nullptr}, {"phi_deg", nullptr}, {"theta_deg", nullptr},
                {"tool_axis", nullptr}, {"r1_axis", nullptr}, {"r2_axis", nullptr}};
    return {{"area_deg2", fit->area * deg2_per_rad2},
            {"phi_deg", pair_deg(magnitudes(fit->phi))},
            {"theta_deg", pair_deg(magnitudes(fit->theta))},
            {"tool_axis", vector_json(fit->pose.tool_axis)},
            {"r1_axis", vector_json(fit->pose.r1_axis)},
            {"r2_axis", vector_json(fit->pose.r2_axis)}};
}

std::string setup_pose_text(const Json& s, bool is_within)
{
    const std::string text = s["area_deg2"].is_null() ? "" : ranges_text(s, is_within);
    if (s["tool_axis"].is_null())
        return text.empty() ? text : text + "\n";
    return text + (text.empty() ? "  tool axis    " : "; tool axis ") +
           axis_text(s["tool_axis"]) + " of the part\n";
}

Json setup_summary(const SetupInput& input, const SetupVisibility& visibility,
                   std::span<const SetupAnswer> answers,
                   const SetupCommandOptions& options)
{
    const SetupAnswer& first = answers.front();
    Json summary{
        {"name", input.name}, {"source", input.source}, {"endmill", program_version}};
    summary.update(machine_json(*first.machine));
    const std::optional<SetupMode> mode = effective_mode(input.machines, options);
    summary["mode"] = mode ? Json(setup_mode_word(*mode)) : Json{};
    summary["visibility"] = visibility_word(visibility.file.kind);
    summary["incidence_deg"] = visibility.file.incidence.written_degrees();
    summary["sphere"] = input.grid.name;
    summary["cells"] = input.grid.centres.size();
    summary["floor_deg"] = options.floor_deg;
    summary["gap"] = is_set(options) ? Json(options.gap) : Json{};
    summary["max_nodes"] = is_set(options) ? Json(options.max_nodes) : Json{};
    summary["max_setups"] = options.max_setups;
    summary["arc_tolerance_deg"] = options.arc_tolerance_deg;
    summary["tool"] = options.tool.empty() ? Json{} : Json(printable(options.tool));
    summary["tool_length_mm"] = input.tool ? Json(input.tool->length) : Json{};
    summary["facets"] = input.mesh.triangles().size();
    if (!options.skip_facets.empty()) {
        summary["skip_facets"] = printable(options.skip_facets);
        summary["skipped_facets"] = input.skipped;
    }
    summary["empty_cones"] = visibility.empty;
    summary.update(limits_json(first.machine->machine.rotary));
    add_search(summary, first, options);
    if (answers.size() > 1)
        summary["ranking"] = ranking(answers, options);
    summary["remarks"] = input.notes;
    for (const std::string& remark : input.remarks)
        summary["remarks"].push_back(remark);
    summary["visibility_s"] = visibility.seconds;
    double seconds = 0;
    for (const SetupAnswer& answer : answers)
        seconds += answer.seconds;
    summary["search_s"] = seconds;
    return summary;
}

std::string setup_text(const Json& s)
{
    std::string text =
        fmt::format("{}: {} on {}{}; {}, {} directions\n", s["name"].get<std::string>(),
                    machinable_text(s),
                    s["configuration"].is_null() ? s["type"].get<std::string>()
                                                 : s["configuration"].get<std::string>(),
                    s["mode"].is_null() ? "" : ", mode " + s["mode"].get<std::string>(),
                    s["facets"].get<std::size_t>(), s["cells"].get<std::size_t>());
    if (!s["reason"].is_null())
        text += "  reason       " + s["reason"].get<std::string>() + "\n";
    return text + undecided_text(s) + missed_text(s) +
           setup_pose_text(s, s["rotary_ok"] == true) + travel_text(s) +
           better_mode_text(s);
}

}  // namespace endmill
