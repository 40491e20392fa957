// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_text.h"

#include <string_view>

#include <fmt/format.h>

#include "cli/shown_numbers.h"
#include "endmill/core/text.h"

namespace endmill {

namespace {

// The largest radius that fits the surface.
std::string limit_text(const PlanContext& context)
{
    if (context.is_mesh)
        return "on a mesh";
    if (!context.limit)
        return "no concavity limits its radius";
    return fmt::format("radius below {} mm fits", shown_limit(context.limit->radius_mm));
}

// The form of the curvature across the feed. Mode verified does not use it.
std::string cross_curvature_text(const PlanOptions& options)
{
    if (options.mode != Planner::Paper)
        return {};
    if (options.planning.cross_curvature == CrossCurvature::Exact)
        return ", exact curvature across the feed";
    return fmt::format(
        ", curvature across the feed by eq. (8) of the paper with chord {} mm",
        shown_limit(options.planning.cross_step));
}

}  // namespace

std::string settings_text(const PlanContext& context, const PlanOptions& options)
{
    const std::string tolerance =
        options.strategy != StrategyChoice::Iso
            ? fmt::format("strategy {}, inner tolerance {} mm",
                          strategy_word(options.strategy),
                          shown_limit(options.motion.inner))
        : options.mode == Planner::Paper
            ? fmt::format("chord tolerance {} mm",
                          shown_limit(options.planning.chord_tolerance))
            : fmt::format("inner tolerance {} mm, outer tolerance {} mm",
                          shown_limit(options.motion.inner),
                          shown_limit(options.motion.outer));
    return fmt::format("{}: cutter {}{}, mode {}, {}, scallop height {} mm{}\n",
                       context.name, cutter_word(context.cutter),
                       context.cutter.is_ball() ? " (" + limit_text(context) + ")" : "",
                       mode_word(options.mode), tolerance,
                       shown_limit(options.planning.scallop_height),
                       cross_curvature_text(options));
}

namespace {

std::string length_of(const Json& s, const char* key)
{
    return s[key].is_null() ? "unknown" : shown(s[key].get<double>()) + " mm";
}

// A length beside its limit.
std::string length_against(const Json& s, const char* key, double limit)
{
    return s[key].is_null() ? "unknown"
                            : shown_against(s[key].get<double>(), limit) + " mm";
}

// Gouge and remaining stock of the whole path with their limits.
std::string deviation_text(const PlannedDirection& planned, const Json& s)
{
    const double inner = s["inner_tolerance_mm"].get<double>();
    const double most_left =
        s["scallop_mm"].get<double>() + s["outer_tolerance_mm"].get<double>();
    return fmt::format("gouge {} mm (limit {}), remaining {} (limit {})",
                       shown_against(planned.errors().gouge, inner), shown_limit(inner),
                       length_against(s, "max_scallop_mm", most_left),
                       shown_limit(most_left));
}

std::string chord_error_text(const Json& s)
{
    const double limit = s["chord_tolerance_mm"].get<double>();
    return fmt::format("chord error {} (limit {}), ",
                       length_against(s, "max_chord_error_mm", limit),
                       shown_limit(limit));
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
    return "remaining stock";
}

}  // namespace

std::string direction_text(const PlannedDirection& planned, const Json& s)
{
    const Json& path = s["path"];
    std::string text = fmt::format(
        "  along {}       {} passes, {}, contact travel {}; cuts {}, links {}",
        s["direction"].get<std::string>(), s["passes"].get<std::size_t>(),
        counted(path["points"].get<std::size_t>(), "point"), length_of(s, "tcd_mm"),
        length_of(path, "cut_mm"), length_of(path, "link_mm"));
    if (const auto links = s["lifted_links"].get<std::size_t>())
        text += fmt::format(", plunges {}, rapids {} ({} lifted)",
                            length_of(path, "plunge_mm"), length_of(path, "rapid_mm"),
                            counted(links, "link"));
    if (s.contains("time_min"))
        text +=
            fmt::format(", {} min at {} mm/min", shown_time(s["time_min"].get<double>()),
                        to_text(s["feed_mm_per_min"].get<double>()));
    text += "; " + (s["mode"] == "paper" ? chord_error_text(s) : std::string{}) +
            deviation_text(planned, s);
    if (const auto places = s["uncovered_places"].get<std::size_t>())
        text += ", not covered: " + counted(places, "place");
    return text + "\n";
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
        "{:.1f} % in points\n",
        both["recommended"].get<std::string>(), 100 * both["reduction_tcd"].get<double>(),
        100 * both["reduction_ncl"].get<double>());
}

namespace {

double diameter_of(const Json& s)
{
    constexpr std::string_view ball = "ball:";
    return number_from_text(s["cutter"].get<std::string>().substr(ball.size()))
        .value_or(0);
}

std::string caption_of(const Json& s)
{
    const double inner = s["inner_tolerance_mm"].get<double>();
    const double outer = s["outer_tolerance_mm"].get<double>();
    const std::string tolerance =
        s["mode"] == "paper" ? fmt::format("chord tolerance {:g} mm",
                                           s["chord_tolerance_mm"].get<double>())
        : inner == outer     ? fmt::format("tolerance {:g} mm", inner)
                         : fmt::format("inner tolerance {:g} mm, outer tolerance {:g} mm",
                                       inner, outer);
    return fmt::format(
        "{}, scallop height {:g} mm, ball diameter {:g} mm, {} passes, {} points, travel "
        "{}",
        tolerance, s["scallop_mm"].get<double>(), diameter_of(s),
        s["passes"].get<std::size_t>(), s["ncl"].get<std::size_t>(),
        length_of(s, "tcd_mm"));
}

}  // namespace

FigureOptions figure_options(const Json& s)
{
    FigureOptions figure;
    figure.title = s["name"].get<std::string>() +
                   ": contact points in cutting order, along " +
                   s["direction"].get<std::string>();
    figure.captions = {caption_of(s)};
    if (s["mode"] == "paper" && s["cross_curvature"] == "chord")
        figure.captions.push_back(fmt::format(
            "curvature across the feed by eq. (8) of the paper, chord {:g} mm",
            s["cross_step_mm"].get<double>()));
    return figure;
}

}  // namespace endmill
