// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_options.h"

#include <array>

#include "cli/arguments.h"
#include "cli/surface_facts.h"

namespace endmill {
namespace {

constexpr std::array directions{Choice<PlanDirection>{"both", PlanDirection::Both},
                                Choice<PlanDirection>{"u", PlanDirection::U},
                                Choice<PlanDirection>{"v", PlanDirection::V}};
constexpr std::array governing{Choice<Governing>{"min", Governing::Min},
                               Choice<Governing>{"dense-min", Governing::DenseMin},
                               Choice<Governing>{"mean", Governing::Mean},
                               Choice<Governing>{"first", Governing::First},
                               Choice<Governing>{"max", Governing::Max}};
constexpr std::array last_path{Choice<LastPath>{"border", LastPath::Border},
                               Choice<LastPath>{"none", LastPath::None},
                               Choice<LastPath>{"half", LastPath::Half}};
constexpr std::array end_point{Choice<EndPoint>{"force", EndPoint::Force},
                               Choice<EndPoint>{"free", EndPoint::Free}};
constexpr std::array step_curvature{
    Choice<StepCurvature>{"curve", StepCurvature::Curve},
    Choice<StepCurvature>{"normal", StepCurvature::Normal}};
constexpr std::array march{Choice<March>{"forward", March::Forward},
                           Choice<March>{"alternate", March::Alternate}};
constexpr std::array cross{Choice<CrossCurvature>{"exact", CrossCurvature::Exact},
                           Choice<CrossCurvature>{"chord", CrossCurvature::Chord}};
constexpr std::array order{Choice<PassOrder>{"zigzag", PassOrder::ZigZag},
                           Choice<PassOrder>{"one-way", PassOrder::OneWay}};
constexpr std::array distance{Choice<TravelKind>{"contact", TravelKind::Contact},
                              Choice<TravelKind>{"cl", TravelKind::Tip}};
constexpr std::array no_first{Choice<bool>{"no", false}, Choice<bool>{"yes", true}};
constexpr std::array modes{Choice<PlanMode>{"paper", PlanMode::Paper},
                           Choice<PlanMode>{"verified", PlanMode::Verified}};

void add_policy_options(CLI::App& command, PlanOptions& options)
{
    IsoParametricOptions& planning = options.planning;
    add_choice<Governing>(command, "--governing", planning.governing, governing,
                          "which point of a pass decides how far the next one lies");
    add_choice<LastPath>(command, "--last-path", planning.last_path, last_path,
                         "what happens where the next pass would lie beyond the border");
    add_choice<EndPoint>(command, "--end-point", planning.end_point, end_point,
                         "what happens where no further step fits on a pass");
    add_choice<bool>(command, "--stop-at-borders", planning.stop_at_borders, no_first,
                     "a CL point on every patch border");
    add_choice<StepCurvature>(command, "--step-curvature", planning.step_curvature,
                              step_curvature, "the curvature that the step follows");
    add_choice<March>(command, "--march", planning.march, march,
                      "whether every other pass is computed from its far end");
    add_choice<CrossCurvature>(command, "--cross-curvature", planning.cross_curvature,
                               cross, "curvature across the feed: exact, or by eq. (8)");
    add_number(command,
               {"--cross-step", "MM", "step of eq. (8)", NumberDomain::of_machine()},
               planning.cross_step);
    add_choice<PassOrder>(command, "--order", planning.link.order, order,
                          "in which sense neighbouring passes are cut");
    add_number(
        command,
        {"--safe-height", "MM", "where the cutter moves freely; default 5 above the part",
         NumberDomain::any()},
        options.safe_height);
    add_choice<bool>(command, "--count-links", options.count_links, yes_first,
                     "links in tcd_mm and tcd_cl_mm");
    add_choice<TravelKind>(command, "--distance", options.distance, distance,
                           "the travel that time and comparison use");
    for (CLI::Option* option : command.get_options())
        if (option->get_group() == "Options" && option->get_lnames().front() != "help")
            option->group("Policies (the first word is the default)");
}

}  // namespace

void add_plan_options(CLI::App& command, PlanOptions& options)
{
    add_policy_options(command, options);
    command.add_option("SURFACE", options.part, "surface file (endmill-surface/1)")
        ->required();
    command
        .add_option_function<std::string>(
            "--cutter",
            [&options](const std::string& word) {
                options.cutter_diameter = ball_diameter_argument("--cutter", word);
            },
            "ball:DIAMETER in mm; default the largest of 20, 15, 10, 6, 4, 3, 2, 1 that "
            "fits")
        ->type_name("CUTTER");
    add_number(command,
               {"--chord-tolerance", "MM",
                "from the surface's line to the chord; default diameter / 30",
                NumberDomain::of_machine()},
               options.chord_tolerance);
    add_number(command,
               {"--scallop", "MM", "scallop height; default the chord tolerance",
                NumberDomain::of_machine()},
               options.scallop_height);
    add_choice<PlanDirection>(command, "--direction", options.direction, directions,
                              "along which parameter the passes run");
    add_choice<PlanMode>(
        command, "--mode", options.mode, modes,
        "paper: what the paper does, its misprints corrected; verified: true motion and "
        "scallop within tolerance, of the policies only --order and --stop-at-borders");
    add_number(command,
               {"--inner-tolerance", "MM",
                "how deep the ball may enter the part (mode verified); default the chord "
                "tolerance",
                NumberDomain::of_machine()},
               options.inner_tolerance);
    add_number(command,
               {"--outer-tolerance", "MM",
                "material that may stay along a pass (mode verified); default the chord "
                "tolerance",
                NumberDomain::of_machine()},
               options.outer_tolerance);
    add_number(command,
               {"--feed", "MM_PER_MIN", "adds the machining time to the summary",
                NumberDomain::of_machine()},
               options.feed_mm_per_min);
    add_axis_option(command, options.planning.link.axis);
    add_require_option(command, options.g1_is_required);
    add_common_options(command, options.common);
}

std::string mode_word(PlanMode mode)
{
    return std::string{word_for<PlanMode>(mode, modes)};
}

VerifiedOptions verified_options(const PlanOptions& options, Parameter along)
{
    VerifiedOptions verified;
    verified.direction = along;
    verified.tolerances = options.motion;
    verified.scallop_height = options.planning.scallop_height;
    verified.stop_at_borders = options.planning.stop_at_borders;
    verified.link = options.planning.link;
    verified.most_points = options.planning.most_points;
    return verified;
}

void add_policies(Json& summary, const PlanOptions& options)
{
    const IsoParametricOptions& planning = options.planning;
    summary["chord_tolerance_mm"] = planning.chord_tolerance;
    summary["scallop_mm"] = planning.scallop_height;
    summary["inner_tolerance_mm"] = options.motion.inner;
    summary["outer_tolerance_mm"] = options.motion.outer;
    summary["governing"] = word_for<Governing>(planning.governing, governing);
    summary["last_path"] = word_for<LastPath>(planning.last_path, last_path);
    summary["end_point"] = word_for<EndPoint>(planning.end_point, end_point);
    summary["stop_at_borders"] = word_for<bool>(planning.stop_at_borders, no_first);
    summary["step_curvature"] =
        word_for<StepCurvature>(planning.step_curvature, step_curvature);
    summary["march"] = word_for<March>(planning.march, march);
    summary["cross_curvature"] =
        word_for<CrossCurvature>(planning.cross_curvature, cross);
    summary["cross_step_mm"] = planning.cross_step;
    summary["order"] = word_for<PassOrder>(planning.link.order, order);
    summary["safe_height_mm"] = planning.link.safe_height;
    summary["axis"] = vector_json(planning.link.axis);
    summary["count_links"] = word_for<bool>(options.count_links, yes_first);
    summary["distance"] = word_for<TravelKind>(options.distance, distance);
}

}  // namespace endmill
