// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/plan_options.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/cad_files.h"
#include "cli/facet_list.h"
#include "cli/idle_options.h"
#include "cli/named_texts.h"
#include "cli/surface_facts.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr std::array directions{Choice<PlanDirection>{"both", PlanDirection::Both},
                                Choice<PlanDirection>{"u", PlanDirection::U},
                                Choice<PlanDirection>{"v", PlanDirection::V},
                                Choice<PlanDirection>{"best", PlanDirection::Best}};
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
constexpr std::array stop_at_borders{Choice<PatchBorders>{"no", PatchBorders::Cross},
                                     Choice<PatchBorders>{"yes", PatchBorders::Stop}};
constexpr std::array count_links{Choice<CountedMoves>{"yes", CountedMoves::CutsAndLinks},
                                 Choice<CountedMoves>{"no", CountedMoves::Cuts}};
constexpr std::array modes{Choice<Planner>{"verified", Planner::Verified},
                           Choice<Planner>{"paper", Planner::Paper}};

constexpr std::array strategies{
    Choice<StrategyChoice>{"best", StrategyChoice::Best},
    Choice<StrategyChoice>{"iso", StrategyChoice::Iso},
    Choice<StrategyChoice>{"iso-u", StrategyChoice::IsoU},
    Choice<StrategyChoice>{"iso-v", StrategyChoice::IsoV},
    Choice<StrategyChoice>{"planar", StrategyChoice::Planar},
    Choice<StrategyChoice>{"iso-scallop", StrategyChoice::IsoScallop},
    Choice<StrategyChoice>{"field", StrategyChoice::Field}};

constexpr std::array axis_modes{Choice<AxisMode>{"fixed", AxisMode::Fixed},
                                Choice<AxisMode>{"lead", AxisMode::Lead},
                                Choice<AxisMode>{"field", AxisMode::Field}};

constexpr std::array bounds{Choice<PlanBound>{"estimated", PlanBound::Estimated},
                            Choice<PlanBound>{"certified", PlanBound::Certified},
                            Choice<PlanBound>{"none", PlanBound::None}};

// Options of --axis-mode field only.
constexpr std::array field_options{"--lead-range", "--tilt-range", "--tool", "--machine",
                                   "--clamp"};
// Leads and tilts are below this.
constexpr double most_lean_deg = 89;

// Options of passes along parameter lines only.
constexpr std::array iso_options{"--outer-tolerance", "--stop-at-borders",
                                 "--count-links"};

// Policies of mode paper only. Mode verified chooses points and passes by the motion of
// the ball.
constexpr std::array paper_options{"--governing",      "--last-path", "--end-point",
                                   "--step-curvature", "--march",     "--cross-curvature",
                                   "--cross-step"};

void add_paper_options(CLI::App& command, IsoParametricOptions& planning)
{
    add_choice<Governing>(
        command, "--governing", planning.governing, governing,
        "path interval to the next pass, from the intervals along the current pass. min "
        "(default): the smallest at its points; dense-min: the smallest at and between "
        "its points; mean: their mean; first: the first; max: the largest");
    add_choice<LastPath>(
        command, "--last-path", planning.last_path, last_path,
        "what to do if the next pass would lie beyond the border. border (default): add "
        "a pass on the border; none: add no pass; half: add a pass on the border if at "
        "least half an interval remains");
    add_choice<EndPoint>(
        command, "--end-point", planning.end_point, end_point,
        "end of a pass. force (default): add a point on the border; free: "
        "stop at the last full step");
    add_choice<StepCurvature>(
        command, "--step-curvature", planning.step_curvature, step_curvature,
        "curvature that sets the step length. curve (default): of the pass as a space "
        "curve; normal: normal curvature of the surface");
    add_choice<March>(
        command, "--march", planning.march, march,
        "end from which a pass is computed. forward (default): the same for "
        "all passes; alternate: the other end for every second pass");
    add_choice<CrossCurvature>(
        command, "--cross-curvature", planning.cross_curvature, cross,
        "curvature across the feed. exact (default): from the second "
        "fundamental form; chord: by eq. (8) of the paper");
    add_number(command,
               {"--cross-step", "MM", "step of eq. (8) (--cross-curvature chord)",
                NumberDomain::of_machine()},
               planning.cross_step);
    for (const char* name : paper_options)
        command.get_option(name)->group("Options of --mode paper only");
}

void add_path_policies(CLI::App& command, PlanOptions& options)
{
    IsoParametricOptions& planning = options.planning;
    add_choice<PatchBorders>(command, "--stop-at-borders", planning.patch_borders,
                             stop_at_borders,
                             "points at patch borders. no (default): a step may cross a "
                             "border; yes: a pass has a point wherever it crosses one");
    add_choice<PassOrder>(
        command, "--order", planning.link.order, order,
        "cutting direction of neighbouring passes. zigzag (default): opposite; one-way: "
        "the same");
    add_number(command,
               {"--safe-height", "MM",
                "height of rapids along the axis (default 5 above the part)",
                NumberDomain::any()},
               options.safe_height);
    add_choice<CountedMoves>(command, "--count-links", options.counted, count_links,
                             "whether tcd_mm and tcd_cl_mm include the links between "
                             "passes (default yes)");
    add_choice<TravelKind>(command, "--distance", options.distance, distance,
                           "length used for the machining time and for comparing u and "
                           "v. contact (default): of contact points; cl: of cutter "
                           "locations");
    for (const char* name :
         {"--stop-at-borders", "--order", "--safe-height", "--count-links", "--distance"})
        command.get_option(name)->group("Options of the path");
}

void add_tolerances(CLI::App& command, PlanOptions& options)
{
    const NumberDomain length = NumberDomain::of_machine();
    const NumberDomain side = NumberDomain::from_to(0, most_of_machine);
    add_number(command,
               {"--chord-tolerance", "MM",
                "largest gouge and remaining stock of a move (default 0.01; --mode "
                "paper: largest chord error, default diameter / 30)",
                length},
               options.requested.chord);
    add_number(
        command,
        {"--scallop", "MM",
         "largest scallop height between passes (default: the chord tolerance)", length},
        options.requested.scallop_height);
    add_number(command,
               {"--inner-tolerance", "MM",
                "largest gouge depth (default: the chord tolerance); 0: no gouge at all "
                "(--mode verified only)",
                side},
               options.requested.inner);
    add_number(
        command,
        {"--outer-tolerance", "MM",
         "largest remaining stock along a pass (default: the chord tolerance); 0: no "
         "stock remains along a pass (--mode verified only)",
         side},
        options.requested.outer);
}

}  // namespace

namespace {

// Adds an angle of the tool, which is used with --axis-mode only.
void add_lean(CLI::App& command, const char* name, const char* help, Angle& target)
{
    command
        .add_option_function<std::string>(
            name,
            [name, &target](const std::string& word) {
                target = Angle::degrees(number_argument(
                    name, word, NumberDomain::between(-most_lean_deg, most_lean_deg)));
            },
            help)
        ->type_name("DEG")
        ->group("Options of five axes");
}

// Adds a range of leads or tilts.
void add_lean_range(CLI::App& command, const char* name, const char* help,
                    LeanRange& target)
{
    command
        .add_option_function<std::string>(
            name,
            [name, &target](const std::string& word) {
                const std::vector<std::string> ends = parts_of(word, ':');
                if (ends.size() != 2)
                    throw DomainError{std::string{name} + ": found \"" + printable(word) +
                                      "\"; expected A:B, such as -30:30"};
                const auto end = [&](const std::string& text) {
                    return Angle::degrees(number_argument(
                        name, text,
                        NumberDomain::between(-most_lean_deg, most_lean_deg)));
                };
                target = {end(ends.front()), end(ends.back())};
                if (target.from.radians() > target.to.radians())
                    throw DomainError{std::string{name} + ": found " + printable(word) +
                                      "; expected A:B with A at most B"};
            },
            help)
        ->type_name("A:B")
        ->group("Options of five axes");
}

void add_field_options(CLI::App& command, PlanOptions& options)
{
    add_lean_range(
        command, "--lead-range",
        "--axis-mode field: range of the lead in degrees, within -89 and 89 (default "
        "-30:30)",
        options.lead_range);
    add_lean_range(
        command, "--tilt-range",
        "--axis-mode field: range of the tilt in degrees, within -89 and 89 (default "
        "-30:30)",
        options.tilt_range);
    command
        .add_option(
            "--tool", options.tool,
            "--axis-mode field: tool file; its shank and holder keep off the part")
        ->type_name("FILE");
    add_clamped_machine_options(command, options.rotary);
    for (const char* name : {"--tool", "--machine", "--clamp"})
        command.get_option(name)->group("Options of five axes");
}

void add_axis_mode(CLI::App& command, PlanOptions& options)
{
    add_choice<AxisMode>(
        command, "--axis-mode", options.axis_mode, axis_modes,
        "plan for five axes, with any cutter: along parameter lines of a surface, or on "
        "a "
        "mesh by --strategy planar, iso-scallop (default for a ball) or field. The axis "
        "leans against the normal of the part. fixed: by --lead-deg and --tilt-deg; "
        "lead: by the least lead at which the cutter does not gouge, plus one degree, "
        "and at least --lead-deg; field: on the passes of lead, by the axes within "
        "--lead-range and --tilt-range that see the contacts, keep off the part and "
        "turn least")
        ->group("Options of five axes");
    add_lean(command, "--lead-deg",
             "lead of the axis: how far it leans forward, in the direction of the feed "
             "(default 0)",
             options.inclination.lead);
    add_lean(command, "--tilt-deg",
             "tilt of the axis: how far it leans to the left of the feed (default 0)",
             options.inclination.tilt);
    add_field_options(command, options);
}

void add_setup_files(CLI::App& command, PlanOptions& options)
{
    command
        .add_option("--setup", options.setup,
                    "summary.json of endmill setup: the part is planned as it stands on "
                    "this machine, with the tool along Z. --direction-deg then counts "
                    "from X towards Y of the machine")
        ->type_name("FILE");
    command
        .add_option("--setups", options.setups,
                    "summary.json of endmill setup: a mesh is planned from the tool axes "
                    "of all its setups (3+2 axes). Each facet is cut from the setup that "
                    "faces it most, of those from which the ball reaches it. For a ball")
        ->type_name("FILE");
}

void add_direction_angle(CLI::App& command, PlanOptions& options)
{
    command
        .add_option_function<std::string>(
            "--direction-deg",
            [&options](const std::string& word) {
                options.pass_direction = Angle::degrees(number_argument(
                    "--direction-deg", word, NumberDomain::from_to(-360, 360)));
            },
            "direction of the passes of --strategy planar in degrees, from +x towards +y "
            "(default: the best)")
        ->type_name("DEG");
}

// How passes are laid and compared.
void add_strategy_choices(CLI::App& command, PlanOptions& options)
{
    add_choice<StrategyChoice>(
        command, "--strategy", options.strategy, strategies,
        "how passes are laid. best (default): the shortest of iso-u, iso-v, planar, "
        "iso-scallop and field; iso: along u and along v, compared; iso-u, iso-v: along "
        "one of them; planar: in parallel upright planes; iso-scallop: each as far from "
        "the passes before it as the scallop height allows; field: across the widest "
        "strips. Except with iso, --scallop limits all remaining stock. An option that "
        "only iso or planar has, such as --mode paper or --direction, chooses it");
    add_choice<PlanBound>(
        command, "--bound", options.bound, bounds,
        "lower bound of the length, with which a path by a --strategy other than iso is "
        "compared. estimated (default): takes some seconds; certified: proved up to "
        "rounding, about 4 % lower, takes a minute; none: not computed. That of a mesh "
        "is for the travel of the tip, and can only be estimated");
    add_choice<Planner>(
        command, "--mode", options.mode, modes,
        "verified (default): every move is proved to be within "
        "tolerance; paper: as in the paper, with its misprints corrected; "
        "the path may exceed its tolerances");
}

}  // namespace

void add_plan_options(CLI::App& command, PlanOptions& options)
{
    command
        .add_option("PART", options.part.path,
                    "surface file (endmill-surface/1), or, but not with --strategy iso, "
                    "iso-u or iso-v, a mesh file (.stl, .obj, .ply, .off) or a CAD file "
                    "(.step, .stp, .iges, .igs)")
        ->required();
    command
        .add_option("--protect", options.guard.path,
                    "another surface or mesh that no move enters, such as a wall beside "
                    "PART; --units and --up apply to it as to PART. Where it keeps the "
                    "ball off PART nothing need be cut. For a ball along +z with a "
                    "--strategy other than iso")
        ->type_name("PART2");
    add_face_option(command, options.faces,
                    "cut only these faces of a STEP or IGES file, or of a mesh with face "
                    "numbers; no move gouges the others");
    add_skip_facets_option(command, options.skip_facets,
                           "they are not cut, but no move gouges them");
    add_setup_files(command, options);
    command
        .add_option_function<std::string>(
            "--cutter",
            [&options](const std::string& word) {
                options.cutter = cutter_argument("--cutter", word);
            },
            "ball:DIAMETER, or with --strategy planar flat:DIAMETER or "
            "bull:DIAMETER:CORNER_RADIUS, in mm (default: the largest ball of 20, 15, "
            "10, "
            "6, 4, 3, 2, 1 that fits; required for a mesh)")
        ->type_name("CUTTER");
    add_tolerances(command, options);
    add_choice<PlanDirection>(command, "--direction", options.direction, directions,
                              "direction of the passes. With --strategy iso, the "
                              "parameter along which they run: both (default), u or v. "
                              "With --strategy planar: best (default), the one with the "
                              "shortest passes");
    add_direction_angle(command, options);
    add_axis_mode(command, options);
    add_strategy_choices(command, options);
    add_number(command,
               {"--feed", "MM_PER_MIN", "feed for the machining time in the summary",
                NumberDomain::of_machine()},
               options.feed_mm_per_min);
    add_axis_option(command, options.planning.link.axis);
    add_require_option(command, options.required);
    add_path_policies(command, options);
    add_paper_options(command, options.planning);
    add_mesh_options(command, options.part);
    add_html_option(command, options.common);
    add_common_options(command, options.common);
}

namespace {

// A tolerance of 0 needs contacts off the surface, which mode paper does not have.
void refuse_zero_tolerances(const PlanOptions& options)
{
    const auto& [chord, scallop, inner, outer] = options.requested;
    if (inner == 0.0 && outer == 0.0)
        throw DomainError{
            "--inner-tolerance 0 with --outer-tolerance 0: a straight move deviates from "
            "a curved surface; expected one of the two above 0"};
    if (options.mode == Planner::Verified || (inner != 0.0 && outer != 0.0))
        return;
    throw DomainError{fmt::format(
        "{} 0: --mode paper puts every contact on the surface, so that chords gouge "
        "where it is convex and leave stock where it is concave; expected --mode "
        "verified, or a tolerance above 0",
        inner == 0.0 ? "--inner-tolerance" : "--outer-tolerance")};
}

// Directions that the strategies other than iso do not have.
void refuse_directions(const PlanOptions& options, const std::string& chosen)
{
    if (options.strategy != StrategyChoice::Planar) {
        refuse_idle_options(options.common, std::array{"--direction-deg"}, chosen,
                            "--strategy planar");
        refuse_idle_options(options.common, std::array{"--direction"}, chosen,
                            options.direction == PlanDirection::Best ? "--strategy planar"
                                                                     : "--strategy iso");
    } else if (options.direction != PlanDirection::Best) {
        refuse_idle_options(options.common, std::array{"--direction"}, chosen,
                            "--direction best, --direction-deg or --strategy iso");
    } else if (options.pass_direction) {
        refuse_idle_options(options.common, std::array{"--direction"}, "--direction-deg",
                            "one of the two");
    }
}

// What the strategies other than iso cannot do.
void refuse_for_strategy(const PlanOptions& options)
{
    const std::string chosen = "--strategy " + strategy_word(options.strategy);
    refuse_directions(options, chosen);
    refuse_idle_options(options.common, iso_options, chosen, "--strategy iso");
    if (options.mode == Planner::Paper)
        throw DomainError{"--mode paper with " + chosen +
                          ": the paper plans along parameter lines; expected --strategy "
                          "iso or --mode verified"};
    if (options.requested.inner == 0.0)
        throw DomainError{"--inner-tolerance 0 with " + chosen +
                          ": expected a tolerance above 0, or --strategy iso"};
}

// What a plan for five axes cannot do.
void refuse_for_five_axes(const PlanOptions& options)
{
    constexpr std::array three_axes{
        "--mode",        "--bound",           "--protect",
        "--axis",        "--outer-tolerance", "--stop-at-borders",
        "--count-links", "--distance",        "--setups"};
    refuse_idle_options(options.common, three_axes, "--axis-mode", "a fixed axis");
    refuse_idle_options(options.common, paper_options, "--axis-mode", "--mode paper");
    if (options.direction == PlanDirection::Best)
        refuse_idle_options(options.common, std::array{"--direction"}, "--axis-mode",
                            "--direction both, u or v");
    if (options.requested.inner == 0.0)
        throw DomainError{
            "--inner-tolerance 0 with --axis-mode: expected a tolerance above 0"};
    if (!options.cutter)
        throw DomainError{"--axis-mode: expected --cutter too"};
    if (options.axis_mode != AxisMode::Field)
        refuse_idle_options(options.common, field_options,
                            "--axis-mode " + axis_mode_word(*options.axis_mode),
                            "--axis-mode field");
    if (options.rotary.machine.empty())
        refuse_idle_options(options.common, std::array{"--clamp"}, "no --machine",
                            "--machine");
}

// What passes on a mesh cannot do for five axes.
void refuse_for_oriented_mesh(const PlanOptions& options)
{
    refuse_idle_options(options.common, std::array{"--direction"},
                        "--axis-mode on a mesh", "--direction-deg");
    if (options.required != RequiredContinuity::None)
        throw DomainError{options.part.path +
                          ": found a mesh; --require g1 expects a surface file"};
    switch (options.strategy) {
        case StrategyChoice::Planar:
            return;
        case StrategyChoice::IsoScallop:
        case StrategyChoice::Field:
            refuse_idle_options(options.common, std::array{"--direction-deg"},
                                "--strategy " + strategy_word(options.strategy),
                                "--strategy planar");
            return;
        default:
            throw DomainError{"--strategy " + strategy_word(options.strategy) +
                              ": with --axis-mode a mesh expects planar, iso-scallop or "
                              "field"};
    }
}

// What a plan from several setups cannot do.
void refuse_for_setups(const PlanOptions& options)
{
    constexpr std::array one_axis{"--axis",          "--setup",       "--protect",
                                  "--direction-deg", "--safe-height", "--feed"};
    refuse_idle_options(options.common, one_axis, "--setups", "one tool axis");
    if (options.strategy == StrategyChoice::Iso)
        throw DomainError{"--setups with --strategy iso: expected another --strategy"};
    if (options.cutter && !options.cutter->is_ball())
        throw DomainError{"--cutter " + cutter_word(*options.cutter) +
                          " with --setups: expected ball:DIAMETER"};
}

bool is_no_ball(const PlanOptions& options)
{
    return options.cutter && !options.cutter->is_ball();
}

// Cutters that only upright planes have.
void refuse_cutter(const PlanOptions& options)
{
    if (is_no_ball(options) && options.strategy != StrategyChoice::Planar)
        throw DomainError{"--cutter " + cutter_word(*options.cutter) +
                          " with --strategy " + strategy_word(options.strategy) +
                          ": expected ball:DIAMETER, or --strategy planar"};
    if (!is_no_ball(options))
        return;
    const std::string chosen = "--cutter " + cutter_word(*options.cutter);
    refuse_idle_options(options.common,
                        std::array{"--distance", "--protect", "--skip-facets", "--face"},
                        chosen, "a ball");
    if (options.bound != PlanBound::None)
        refuse_idle_options(options.common, std::array{"--bound"}, chosen, "a ball");
}

// What iso cannot do.
void refuse_for_iso(const PlanOptions& options)
{
    const std::string chosen = "--strategy iso";
    refuse_idle_options(options.common, std::array{"--bound", "--protect"}, chosen,
                        "another --strategy");
    refuse_idle_options(options.common, std::array{"--direction-deg"}, chosen,
                        "--strategy planar");
    if (options.direction == PlanDirection::Best)
        refuse_idle_options(options.common, std::array{"--direction"}, chosen,
                            "--strategy planar, or --direction both, u or v");
}

// Whether a direction was given that only upright planes have.
bool has_planar_option(const PlanOptions& options)
{
    return options.pass_direction || options.direction == PlanDirection::Best ||
           is_no_ball(options);
}

// Whether an option was given that only passes along parameter lines have.
bool has_iso_option(const PlanOptions& options)
{
    return options.mode == Planner::Paper || options.requested.inner == 0.0 ||
           options.common.given.contains("--direction") ||
           std::ranges::any_of(iso_options, [&](const char* name) {
               return options.common.given.contains(name);
           });
}

}  // namespace

void complete_strategy(PlanOptions& options)
{
    if (options.axis_mode) {
        if (!options.common.given.contains("--strategy"))
            options.strategy = StrategyChoice::Iso;
        return;
    }
    if (options.common.given.contains("--strategy"))
        return;
    if (has_planar_option(options))
        options.strategy = StrategyChoice::Planar;
    else if (!options.guard.path.empty())
        options.strategy = StrategyChoice::Best;
    else if (has_iso_option(options))
        options.strategy = StrategyChoice::Iso;
}

void complete_for_oriented_part(PlanOptions& options, bool is_mesh)
{
    constexpr std::array mesh_options{"--strategy", "--direction-deg", "--skip-facets",
                                      "--face"};
    if (!is_mesh)
        return refuse_idle_options(options.common, mesh_options,
                                   "--axis-mode on a surface", "a mesh");
    if (!options.common.given.contains("--strategy"))
        options.strategy = options.cutter->is_ball() && !options.pass_direction
                               ? StrategyChoice::IsoScallop
                               : StrategyChoice::Planar;
    refuse_for_oriented_mesh(options);
}

void refuse_idle_plan_options(const PlanOptions& options)
{
    const CommonOptions& common = options.common;
    if (options.axis_mode)
        return refuse_for_five_axes(options);
    refuse_idle_options(common, std::array{"--lead-deg", "--tilt-deg"}, "a fixed axis",
                        "--axis-mode");
    refuse_idle_options(common, field_options,
                        options.setups.empty() ? "a fixed axis" : "--setups",
                        options.setups.empty() ? "--axis-mode field"
                                               : "one tool axis, and --axis-mode field");
    refuse_zero_tolerances(options);
    refuse_cutter(options);
    if (!options.guard.path.empty())
        refuse_idle_options(common, std::array{"--skip-facets", "--face", "--setup"},
                            "--protect", "one of the two");
    if (!options.guard.path.empty() && options.planning.link.axis != Vec3::UnitZ())
        throw DomainError{"--protect with --axis: expected the axis 0,0,1"};
    if (!options.setup.empty())
        refuse_idle_options(common, std::array{"--axis"}, "--setup", "one of the two");
    if (!options.setups.empty())
        refuse_for_setups(options);
    if (options.strategy != StrategyChoice::Iso)
        refuse_for_strategy(options);
    else
        refuse_for_iso(options);
    if (options.mode == Planner::Verified)
        refuse_idle_options(common, paper_options, "--mode verified", "--mode paper");
    if (options.mode == Planner::Verified && options.requested.inner &&
        options.requested.outer && options.requested.scallop_height)
        refuse_idle_options(common, std::array{"--chord-tolerance"},
                            "--inner-tolerance, --outer-tolerance and --scallop",
                            "at most three of the four");
    if (options.planning.cross_curvature == CrossCurvature::Exact)
        refuse_idle_options(common, std::array{"--cross-step"}, "--cross-curvature exact",
                            "--cross-curvature chord");
    if (options.strategy == StrategyChoice::Iso &&
        options.direction != PlanDirection::Both && !options.feed_mm_per_min)
        refuse_idle_options(common, std::array{"--distance"}, "one --direction",
                            "--direction both or --feed");
}

std::string strategy_word(StrategyChoice strategy)
{
    return std::string{word_for<StrategyChoice>(strategy, strategies)};
}

std::string axis_mode_word(AxisMode mode)
{
    return std::string{word_for<AxisMode>(mode, axis_modes)};
}

std::string mode_word(Planner mode)
{
    return std::string{word_for<Planner>(mode, modes)};
}

PlannerOptions planner_options(const PlanOptions& options, Parameter along)
{
    IsoParametricOptions paper = options.planning;
    paper.direction = along;
    if (options.mode == Planner::Paper)
        return paper;
    VerifiedOptions verified;
    verified.direction = along;
    verified.tolerances = options.motion;
    verified.scallop_height = paper.scallop_height;
    verified.patch_borders = paper.patch_borders;
    verified.link = paper.link;
    verified.most_points = paper.most_points;
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
    summary["stop_at_borders"] =
        word_for<PatchBorders>(planning.patch_borders, stop_at_borders);
    summary["step_curvature"] =
        word_for<StepCurvature>(planning.step_curvature, step_curvature);
    summary["march"] = word_for<March>(planning.march, march);
    summary["cross_curvature"] =
        word_for<CrossCurvature>(planning.cross_curvature, cross);
    summary["cross_step_mm"] = planning.cross_step;
    summary["order"] = word_for<PassOrder>(planning.link.order, order);
    summary["safe_height_mm"] = planning.link.safe_height;
    summary["axis"] = vector_json(planning.link.axis);
    summary["count_links"] = word_for<CountedMoves>(options.counted, count_links);
    summary["distance"] = word_for<TravelKind>(options.distance, distance);
}

}  // namespace endmill
