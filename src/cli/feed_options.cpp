// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_options.h"

#include <array>
#include <string_view>

#include "cli/idle_options.h"
#include "cli/verify_options.h"
#include "cli/verify_stock.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

PeakChoice peak_argument(const std::string& word)
{
    constexpr std::string_view constant = "constant:";
    if (word == "torque")
        return {PeakRule::Torque};
    if (word == "direct")
        return {PeakRule::Direct};
    if (word.starts_with(constant)) {
        const auto factor = number_from_text(word.substr(constant.size()));
        if (factor && *factor >= 1)
            return {PeakRule::Constant, *factor};
    }
    throw CLI::ValidationError(
        "--peak",
        "found \"" + word + "\"; expected constant:R with 1 <= R, torque or direct");
}

void add_tool_options(CLI::App& command, ToolOptions& tool)
{
    command
        .add_option("--tool", tool.file,
                    "tool file (endmill-tool/1): cutter, flutes, helix, limits")
        ->type_name("FILE");
    add_whole_number(command, {"--flutes", "number of flutes", 1, most_flutes},
                     [&tool](int flutes) { tool.flutes = flutes; })
        ->type_name("N");
    add_number(command, {"--helix-deg", "DEG", helix_help, helix_domain}, tool.helix_deg);
    add_number(command,
               {"--max-force-n", "N", "largest force on the tool across its axis"},
               tool.max_force_n);
    add_number(command,
               {"--max-thrust-n", "N", "largest force on the tool along its axis"},
               tool.max_thrust_n);
    add_number(command, {"--max-torque-n-m", "NM", "largest torque on the tool"},
               tool.max_torque_n_m);
}

void add_engagement_options(CLI::App& command, FeedCommandOptions& options)
{
    add_choice<EngagementChoice>(command, "--engagement", options.engagement,
                                 engagement_choices,
                                 "source of the engagement (default auto: the contact "
                                 "where it is known, otherwise the passes)");
    add_choice<PreviousPass>(command, "--first-pass", options.first_pass, first_passes,
                             "engagement of a pass that has no earlier neighbour: full "
                             "slot, or along the edge of the block (default slot)");
    command
        .add_option(
            "--part", options.part.path,
            "surface that the path was planned for; it gives contacts and curvature")
        ->type_name("FILE");
    add_mesh_options(command, options.part);
    add_number(
        command,
        {"--contact-tolerance", "MM",
         "largest gap between the ball and the part at a contact that the path or --part "
         "gives"},
        options.contact_tolerance);
    add_number(command,
               {"--stock-top", "Z",
                "height of the top of the stock in mm (default: that of --stock, of the "
                "block around the part, or where the first move at feed goes down)",
                NumberDomain::any()},
               options.stock_top);
    command.add_option("--stock", options.stock, stock_help)->type_name("STOCK");
    add_number(command,
               {"--resolution", "MM", "cell size of the stock (--engagement stock)"},
               options.resolution);
}

void add_model_options(CLI::App& command, FeedCommandOptions& options)
{
    add_choice<FeedMode>(command, "--mode", options.mode, feed_modes,
                         "rules of the plan (default paper); planned: as corrected, and "
                         "reports the time under the acceleration limit of the "
                         "machine");
    add_chip_option(command, options.chip, "paper; --mode corrected, planned: exact");
    command
        .add_option_function<std::string>(
            "--peak",
            [&options](const std::string& word) { options.peak = peak_argument(word); },
            "rule for the peak load in a spindle revolution. constant:R: R times the "
            "mean; torque: the mean times the peak factor of the chip torque; direct: "
            "computed for each load (default constant:1.8; --mode corrected, planned: "
            "direct)")
        ->type_name("RULE");
    add_number(command,
               {"--accuracy", "EPS", "largest error of a cutting action coefficient",
                accuracy_domain},
               options.accuracy);
    add_choice<CoefficientSource>(
        command, "--coefficients", options.coefficients, coefficient_sources,
        "direct (default): compute; table: interpolate, error up to " +
            to_text(table_error));
    add_number(command,
               {"--min-feed-per-tooth", "MM",
                "smallest feed per tooth (default: the material's, or 0.005)"},
               options.min_feed_per_tooth_mm);
    add_number(command,
               {"--max-feed-per-tooth", "MM",
                "largest feed per tooth (default: the material's)"},
               options.max_feed_per_tooth_mm);
    add_number(command,
               {"--block-time-ms", "MS", "shortest time of a block; 0: no such limit",
                NumberDomain::from_zero()},
               options.block_time_ms);
    add_number(
        command,
        {"--corner-tolerance", "MM", "largest rounding of a corner (--mode planned)"},
        options.corner_tolerance);
}

void add_time_options(CLI::App& command, FeedCommandOptions& options)
{
    CLI::Option* const rapid = add_number(
        command,
        {"--rapid-mm-per-min", "F",
         "speed of rapids, from which the time of all non-cutting moves is computed"},
        options.rapid_mm_per_min);
    add_number(command,
               {"--noncut-min", "MIN",
                "given time of all non-cutting moves, in place of --rapid-mm-per-min",
                NumberDomain::from_zero()},
               options.noncut_min)
        ->excludes(rapid);
    add_number(
        command,
        {"--constant-feed-mm-per-min", "F", "constant feed to compare the plan with"},
        options.constant_feed_mm_per_min);
    add_number(command,
               {"--plunge-feed-mm-per-min", "F",
                "feed of moves that do not cut and have no feed of their own"},
               options.plunge_feed_mm_per_min);
}

}  // namespace

void refuse_idle_feed_options(const FeedCommandOptions& options)
{
    const CommonOptions& common = options.common;
    if (options.mode != FeedMode::Planned)
        refuse_idle_options(
            common, std::array{"--corner-tolerance"},
            "--mode " + std::string{word_for<FeedMode>(options.mode, feed_modes)},
            "--mode planned");
    if (options.coefficients == CoefficientSource::Table)
        refuse_idle_options(common, std::array{"--accuracy"}, "--coefficients table",
                            "--coefficients direct");
    const bool is_by_stock = options.engagement == EngagementChoice::Stock;
    if (!is_by_stock && !may_be_mesh(options.stock))
        refuse_idle_options(
            common, std::array{"--resolution"},
            "--engagement " + std::string{word_for<EngagementChoice>(options.engagement,
                                                                     engagement_choices)},
            "--engagement stock, or a mesh as --stock");
    if (options.part.path.empty() && !may_be_mesh(options.stock))
        refuse_idle_mesh_options(common);
}

std::string peak_word(PeakRule rule, double factor)
{
    switch (rule) {
        case PeakRule::Constant:
            return "constant:" + to_text(factor);
        case PeakRule::Torque:
            return "torque";
        case PeakRule::Direct:
            return "direct";
    }
    return {};
}

void add_chip_option(CLI::App& command, std::optional<ChipModel>& chip,
                     const std::string& default_words)
{
    add_choice<ChipModel>(
        command, "--chip", chip, chip_models,
        "chip thickness: as the paper approximates it, or exact (default " +
            default_words + ")");
}

void add_feed_options(CLI::App& command, FeedCommandOptions& options)
{
    add_path_options(command, options.path);
    command
        .add_option("--material", options.material, "material file (endmill-material/1)")
        ->type_name("FILE")
        ->required();
    command
        .add_option(
            "--machine", options.machine,
            "machine file (endmill-machine/1) with its limits (default: no limits)")
        ->type_name("FILE");
    add_tool_options(command, options.tool);
    add_engagement_options(command, options);
    add_model_options(command, options);
    add_time_options(command, options);
    add_tools_options(command, options.path);
    add_reading_options(command, options.path);
    command.add_flag("--allow-infeasible", options.allow_infeasible,
                     "exit 0 even if no feed satisfies the limits somewhere");
    add_html_option(command, options.common);
    add_common_options(command, options.common);
}

}  // namespace endmill
