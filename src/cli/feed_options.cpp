// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_options.h"

#include <string_view>

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
    add_whole_number(command, {"--flutes", "of the cutter", 1, most_flutes},
                     [&tool](int flutes) { tool.flutes = flutes; })
        ->type_name("N");
    add_number(command, {"--helix-deg", "DEG", helix_help, helix_domain}, tool.helix_deg);
    add_number(command,
               {"--max-force-n", "N", "most that the tool bears across its axis"},
               tool.max_force_n);
    add_number(command, {"--max-thrust-n", "N", "most that it bears along its axis"},
               tool.max_thrust_n);
    add_number(command, {"--max-torque-n-m", "NM", "most torque that it bears"},
               tool.max_torque_n_m);
}

void add_engagement_options(CLI::App& command, FeedCommandOptions& options)
{
    add_choice<EngagementChoice>(command, "--engagement", options.engagement,
                                 engagement_choices,
                                 "where the engagement comes from; auto (default): the "
                                 "contact where it is known, else the passes");
    add_choice<PreviousPass>(command, "--first-pass", options.first_pass, first_passes,
                             "what a pass with none beside it cuts; default slot");
    command
        .add_option("--part", options.part.path,
                    "surface that the path was planned for: contacts and curvature")
        ->type_name("FILE");
    add_mesh_options(command, options.part);
    add_number(command,
               {"--contact-tolerance", "MM", "by which the ball may miss the part"},
               options.contact_tolerance);
    add_number(command,
               {"--stock-top", "Z",
                "height of the stock's top in mm; default that of "
                "--stock, or of the block around the part",
                NumberDomain::any()},
               options.stock_top);
    command
        .add_option("--stock", options.stock,
                    "block (default: around the part), X0,Y0,Z0,X1,Y1,Z1, a closed mesh, "
                    "or the stock.vti of an earlier run")
        ->type_name("STOCK");
    add_number(command, {"--resolution", "MM", "pitch of the stock"}, options.resolution);
}

void add_model_options(CLI::App& command, FeedCommandOptions& options)
{
    add_choice<FeedMode>(command, "--mode", options.mode, feed_modes,
                         "by which rules; default paper");
    add_chip_option(command, options.chip);
    command
        .add_option_function<std::string>(
            "--peak",
            [&options](const std::string& word) { options.peak = peak_argument(word); },
            "largest over mean load: constant:R (paper: 1.8), torque, direct (corrected)")
        ->type_name("RULE");
    add_number(command,
               {"--accuracy", "EPS", "of a cutting action coefficient", accuracy_domain},
               options.accuracy);
    add_choice<bool>(command, "--coefficients", options.has_table, coefficient_sources,
                     "computed one by one, or from a table that is off by up to " +
                         to_text(table_error));
    add_number(command,
               {"--min-feed-per-tooth", "MM", "default the material's, or 0.005"},
               options.min_feed_per_tooth_mm);
    add_number(command, {"--max-feed-per-tooth", "MM", "default the material's"},
               options.max_feed_per_tooth_mm);
    add_number(
        command,
        {"--block-time-ms", "MS", "least time of a block", NumberDomain::from_zero()},
        options.block_time_ms);
    add_number(command,
               {"--corner-tolerance", "MM", "by which a corner may be cut (planned)"},
               options.corner_tolerance);
}

void add_time_options(CLI::App& command, FeedCommandOptions& options)
{
    CLI::Option* const rapid =
        add_number(command, {"--rapid-mm-per-min", "F", "of rapids, for the times"},
                   options.rapid_mm_per_min);
    add_number(command,
               {"--noncut-min", "MIN", "time besides cutting", NumberDomain::from_zero()},
               options.noncut_min)
        ->excludes(rapid);
    add_number(command, {"--constant-feed-mm-per-min", "F", "the feed to compare with"},
               options.constant_feed_mm_per_min);
    add_number(command,
               {"--plunge-feed-mm-per-min", "F",
                "of moves at feed that do not cut and have none"},
               options.plunge_feed_mm_per_min);
}

}  // namespace

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

void add_chip_option(CLI::App& command, std::optional<ChipModel>& chip)
{
    add_choice<ChipModel>(command, "--chip", chip, chip_models,
                          "what the chip's thickness is taken for");
}

void add_feed_options(CLI::App& command, FeedCommandOptions& options)
{
    add_path_options(command, options.path);
    command
        .add_option("--material", options.material, "material file (endmill-material/1)")
        ->type_name("FILE")
        ->required();
    command
        .add_option("--machine", options.machine,
                    "machine file (endmill-machine/1); default: it binds nothing")
        ->type_name("FILE");
    add_tool_options(command, options.tool);
    add_engagement_options(command, options);
    add_model_options(command, options);
    add_time_options(command, options);
    add_reading_options(command, options.path);
    command.add_flag("--allow-infeasible", options.allow_infeasible,
                     "exit 0 also where no feed satisfies the limits");
    add_common_options(command, options.common);
}

}  // namespace endmill
