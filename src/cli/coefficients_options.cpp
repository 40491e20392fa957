// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/coefficients_options.h"

#include <array>

#include "cli/arguments.h"
#include "cli/feed_options.h"

namespace endmill {
namespace {

constexpr std::array previous_passes{Choice<PreviousPass>{"pass", PreviousPass::Beside},
                                     Choice<PreviousPass>{"none", PreviousPass::None},
                                     Choice<PreviousPass>{"edge", PreviousPass::Edge}};
constexpr std::array milling_words{Choice<Milling>{"down", Milling::Down},
                                   Choice<Milling>{"up", Milling::Up}};

void add_geometry(CLI::App& command, CoefficientsOptions& options)
{
    const NumberDomain any = NumberDomain::any();
    add_number(command,
               {"--mu-deg", "DEG", "angle of the pick feed about the feed", slope_domain},
               options.mu_deg)
        ->required();
    add_number(
        command,
        {"--lambda-deg", "DEG", "angle of the feed above the horizontal", slope_domain},
        options.lambda_deg)
        ->required();
    add_number(command,
               {"--pick-feed-ratio", "RP", "ratio of pick feed to ball radius",
                NumberDomain::from_zero()},
               options.pick_feed_ratio);
    add_number(
        command,
        {"--depth-ratio", "RL",
         "ratio of the stock's height above the tip to the ball radius; 0 or below: air",
         any},
        options.depth_ratio)
        ->required();
    add_choice<PreviousPass>(
        command, "--previous", options.previous, previous_passes,
        "earlier cut. pass (default): a parallel pass beside this one; none: a full "
        "slot; edge: the ball runs along the edge of the block");
}

void add_forces(CLI::App& command, CoefficientsOptions& options)
{
    add_whole_number(command, {"--flutes", "number of flutes", 1, most_flutes},
                     [&options](int flutes) { options.flutes = flutes; })
        ->type_name("N");
    add_number(command, {"--helix-deg", "DEG", helix_help, helix_domain},
               options.helix_deg);
    command
        .add_option("--material", options.material, "material file (endmill-material/1)")
        ->type_name("FILE");
    add_number(command,
               {"--feed-per-tooth", "MM", "feed per tooth, for the forces",
                NumberDomain::from_zero()},
               options.feed_per_tooth_mm);
    command
        .add_option_function<std::string>(
            "--cutter",
            [&options](const std::string& word) {
                options.diameter_mm = ball_diameter_argument("--cutter", word);
            },
            "ball:DIAMETER in mm, for the forces")
        ->type_name("CUTTER");
    add_choice<Milling>(
        command, "--milling", options.milling, milling_words,
        "side of the feed on which the stock lies: right (down, default) or left (up)");
}

}  // namespace

void add_coefficients_options(CLI::App& command, CoefficientsOptions& options)
{
    add_geometry(command, options);
    add_chip_option(command, options.chip, "paper");
    add_forces(command, options);
    add_number(command,
               {"--accuracy", "EPS", "largest error of a coefficient", accuracy_domain},
               options.accuracy);
    CLI::Option* const profile =
        command.add_flag("--profile", options.has_profile,
                         "write profile.csv: forces and torque for each degree");
    add_number(command,
               {"--runout-mm", "MM", "radial runout of the cutter's axis (--profile)",
                NumberDomain::from_zero()},
               options.runout_mm)
        ->needs(profile);
    add_number(command,
               {"--runout-deg", "DEG",
                "azimuth of the runout while flute 0 is at azimuth 0 (--profile)",
                NumberDomain::any()},
               options.runout_deg)
        ->needs(profile);
    add_common_options(command, options.common);
}

}  // namespace endmill
