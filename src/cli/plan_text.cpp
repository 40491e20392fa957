// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_text.h"

#include <string_view>

#include <fmt/format.h>

#include "cli/shown_numbers.h"
#include "endmill/core/text.h"

namespace endmill {

std::string limit_text(const std::optional<CutterLimit>& limit)
{
    if (!limit)
        return "  cutter limit  none: the surface has no concavity\n";
    return fmt::format("  cutter limit  radius below {} mm, at {}\n",
                       shown_limit(limit->radius_mm),
                       place_text(limit->at, limit->point));
}

std::string settings_text(const PlanContext& context, const PlanOptions& options)
{
    const std::string tolerance =
        options.mode == Planner::Paper
            ? fmt::format("chord tolerance {} mm",
                          shown(options.planning.chord_tolerance))
            : fmt::format("inner tolerance {} mm, outer tolerance {} mm",
                          shown(options.motion.inner), shown(options.motion.outer));
    return fmt::format("{}: cutter ball:{}, mode {}, {}, scallop height {} mm\n",
                       context.name, to_text(context.cutter_diameter),
                       mode_word(options.mode), tolerance,
                       shown(options.planning.scallop_height));
}

namespace {

std::string length_of(const Json& s, const char* key)
{
    return s[key].is_null() ? "unknown" : shown(s[key].get<double>()) + " mm";
}

// The motion error along the passes, then gouge and scallop on the whole part.
std::string deviation_text(const Json& s)
{
    return fmt::format(
        "    motion error  {}: gouge {}, remaining {}\n"
        "    gouge         {} (limit {})\n"
        "    scallop       {} (limit {} mm)\n",
        length_of(s, "max_motion_error_mm"), length_of(s, "max_motion_gouge_mm"),
        length_of(s, "max_motion_left_mm"), length_of(s, "max_gouge_mm"),
        length_of(s, "inner_tolerance_mm"), length_of(s, "max_scallop_mm"),
        shown(s["scallop_mm"].get<double>() + s["outer_tolerance_mm"].get<double>()));
}

std::string chord_error_text(const PlannedDirection& planned, const Json& s)
{
    return fmt::format("    chord error   {} (limit {}){}\n",
                       length_of(s, "max_chord_error_mm"),
                       length_of(s, "chord_tolerance_mm"),
                       planned.missed.contains(PathLimit::Chord)
                           ? ": mode paper checks the start of each step only"
                           : "");
}

std::string_view limit_name(PathLimit limit)
{
    switch (limit) {
        case PathLimit::Chord:
            return "chord error";
        case PathLimit::Gouge:
            return "gouge";
        case PathLimit::Scallop:
            break;
    }
    return "scallop";
}

}  // namespace

std::string direction_text(const PlannedDirection& planned, const Json& s)
{
    std::string text = fmt::format(
        "  along {}: {} passes, {} points\n"
        "    travel        {} by contacts, {} by tips; links {}\n",
        s["direction"].get<std::string>(), s["passes"].get<std::size_t>(),
        s["ncl"].get<std::size_t>(), length_of(s, "tcd_mm"), length_of(s, "tcd_cl_mm"),
        length_of(s, "link_mm"));
    if (s["mode"] == "paper")
        text += chord_error_text(planned, s);
    text += deviation_text(s);
    if (const auto links = s["lifted_links"].get<std::size_t>())
        text += fmt::format("    lifted links  {}\n", links);
    if (const auto places = s["uncovered_places"].get<std::size_t>())
        text += "    not covered   " + counted(places, "place") + "\n";
    if (s.contains("time_min"))
        text += fmt::format("    time          {} min at {} mm/min\n",
                            shown(s["time_min"].get<double>()),
                            shown(s["feed_mm_per_min"].get<double>()));
    return text;
}

std::string missed_text(const PlannedDirection& planned)
{
    std::string names;
    for (const PathLimit limit : planned.missed)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", limit_name(limit));
    return fmt::format("along {}: {}", planned.along == Parameter::U ? "u" : "v", names);
}

std::string better_mode_text(std::span<const std::string> missed)
{
    std::string text =
        "  better mode   --mode verified proves its limits on the whole surface";
    for (const std::string& names : missed)
        text += (&names == missed.data() ? "; limits missed " : "; ") + names;
    return text + "\n";
}

std::string comparison_text(const Json& both)
{
    return fmt::format(
        "  recommended   along {}: the directions differ by {:.1f} % in travel and "
        "{:.1f} "
        "% in points\n",
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
