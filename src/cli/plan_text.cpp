// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_text.h"

#include <fmt/format.h>

#include "endmill/core/numbers.h"

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
    return fmt::format(
        "cutter ball:{}, chord tolerance {:g} mm, scallop height {:g} mm, mode paper\n",
        to_text(context.cutter_diameter), options.planning.chord_tolerance,
        options.planning.scallop_height);
}

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
    if (chord_error > tolerance * (1 + rounding))
        text += ": mode paper looks at each step's start only";
    text += "\n";
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
