// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_text.h"

#include <fmt/format.h>

#include "endmill/core/text.h"

namespace endmill {

std::string limit_text(const std::optional<CutterLimit>& limit)
{
    if (!limit)
        return "largest ball: none, the surface has no concavity\n";
    return fmt::format("largest ball: radius {:.6f} mm, at {}\n", limit->radius_mm,
                       place_text(limit->at, limit->point));
}

std::string settings_text(const PlanContext& context, const PlanOptions& options)
{
    const bool is_paper = options.mode == PlanMode::Paper;
    const std::string tolerance =
        is_paper
            ? fmt::format("chord tolerance {:g} mm", options.planning.chord_tolerance)
            : fmt::format("inner tolerance {:g} mm, outer {:g} mm", options.motion.inner,
                          options.motion.outer);
    return fmt::format("cutter ball:{}, {}, scallop height {:g} mm, mode {}\n",
                       to_text(context.cutter_diameter), tolerance,
                       options.planning.scallop_height, mode_word(options.mode));
}

namespace {

std::string motion_text(const Json& s)
{
    std::string text = fmt::format(
        "         along its lines the moving ball enters the part by {:.4g} mm, and "
        "leaves "
        "{:.4g} mm\n",
        s["max_motion_gouge_mm"].get<double>(), s["max_motion_left_mm"].get<double>());
    if (const auto links = s["lifted_links"].get<std::size_t>())
        text += "         " + counted(links, "link") + " lifted\n";
    if (const auto places = s["uncovered_places"].get<std::size_t>())
        text += "         not covered: " + counted(places, "place") + "\n";
    return text;
}

}  // namespace

std::string direction_text(const Json& s)
{
    const double chord_error = s["max_chord_error_mm"];
    const double tolerance = s["chord_tolerance_mm"];
    std::string text = fmt::format(
        "along {}: {} passes, {} CL points, {:.1f} mm of travel ({:.1f} mm by tips), "
        "{:.1f} "
        "mm of it links\n"
        "         largest chord error {:.4g} mm, {:.3g} x the tolerance",
        s["direction"].get<std::string>(), s["passes"].get<std::size_t>(),
        s["ncl"].get<std::size_t>(), s["tcd_mm"].get<double>(),
        s["tcd_cl_mm"].get<double>(), s["link_mm"].get<double>(), chord_error,
        chord_error / tolerance);
    constexpr double rounding = 1e-9;
    const bool is_paper = s["mode"] == "paper";
    if (is_paper && chord_error > tolerance * (1 + rounding))
        text += ": mode paper looks at each step's start only";
    text += "\n" + motion_text(s);
    const bool holds = s["max_motion_gouge_mm"] <= s["inner_tolerance_mm"] &&
                       s["max_motion_left_mm"] <= s["outer_tolerance_mm"];
    if (is_paper && !holds)
        text +=
            "         --mode verified keeps both, and the scallop height, everywhere\n";
    if (s.contains("time_min"))
        text +=
            fmt::format("         {:.4g} min at {:g} mm/min\n",
                        s["time_min"].get<double>(), s["feed_mm_per_min"].get<double>());
    return text;
}

std::string comparison_text(const Json& both)
{
    return fmt::format(
        "more economic: {}; the directions differ by {:.1f} % in travel and {:.1f} % in "
        "points\n",
        both["recommended"].get<std::string>(), 100 * both["reduction_tcd"].get<double>(),
        100 * both["reduction_ncl"].get<double>());
}

FigureOptions figure_options(const Json& s)
{
    const std::string direction = s["direction"];
    FigureOptions figure;
    figure.title = s["name"].get<std::string>() +
                   ": contact points in cutting order, along " + direction;
    figure.captions = {fmt::format(
        "TOL = {:g} mm   SCALLOP = {:g} mm   C.D. = {:g} mm   NCL,{} = {}   TCD,{} = "
        "{:.1f} mm",
        s["chord_tolerance_mm"].get<double>(), s["scallop_mm"].get<double>(),
        number_from_text(s["cutter"].get<std::string>().substr(5)).value_or(0), direction,
        s["ncl"].get<std::size_t>(), direction, s["tcd_mm"].get<double>())};
    return figure;
}

}  // namespace endmill
