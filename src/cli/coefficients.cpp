// SPDX-License-Identifier: GPL-3.0-or-later
// endmill coefficients: the cutting action coefficients of one engagement, and its forces.

#include <array>
#include <memory>
#include <numbers>
#include <vector>

#include "build_facts.h"
#include "cli/answer.h"
#include "cli/coefficients_options.h"
#include "cli/console.h"
#include "cli/surface_facts.h"
#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/machining_data.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/result_csv.h"
#include "endmill/process/cutting_force.h"

namespace endmill {
namespace {

constexpr int profile_angles = 360;

BallEngagement engagement_of(const CoefficientsOptions& options)
{
    if (options.previous == PreviousPass::Beside && !options.pick_feed_ratio)
        throw DomainError{
            "--pick-feed-ratio: expected a number from 0, or --previous none or edge"};
    return {.mu = Angle::degrees(options.mu_deg.value()).radians(),
            .lambda = Angle::degrees(options.lambda_deg.value()).radians(),
            .pick_feed_ratio = options.pick_feed_ratio.value_or(0),
            .depth_ratio = options.depth_ratio.value(),
            .previous = options.previous};
}

// The cutter of the options. A default radius suffices for ratios, which do not depend
// on it.
MillingTool tool_of(const CoefficientsOptions& options)
{
    return {.radius = options.diameter_mm.value_or(2) / 2,
            .flutes = options.flutes.value_or(1),
            .helix = Angle::degrees(options.helix_deg.value_or(0)).radians()};
}

bool has_forces(const CoefficientsOptions& options)
{
    return !options.material.empty() && options.feed_per_tooth_mm &&
           options.diameter_mm && options.flutes;
}

// Options that have no effect without others.
void refuse_idle(const CoefficientsOptions& options)
{
    if (options.pick_feed_ratio && options.previous != PreviousPass::Beside)
        throw DomainError{
            "--pick-feed-ratio: has no effect with --previous none or edge; expected "
            "--previous pass"};
    const auto refuse = [](const char* option, const char* expected) {
        throw DomainError{std::string{option} + ": has no effect alone; expected " +
                          expected};
    };
    constexpr const char* forces =
        "all of --material, --feed-per-tooth, --cutter and --flutes, for the forces";
    if (options.diameter_mm && !has_forces(options))
        refuse("--cutter", forces);
    if (options.feed_per_tooth_mm && !has_forces(options))
        refuse("--feed-per-tooth", forces);
    if (!options.material.empty() && !has_forces(options))
        refuse("--material", forces);
    if (options.helix_deg && !options.flutes)
        refuse("--helix-deg", "--flutes");
    if (options.flutes && !options.helix_deg && !has_forces(options))
        refuse("--flutes", "--helix-deg, for the peak factor, or what the forces need");
}

// The frame is mirrored when milling down, the helix is not.
void remark_helix(const CoefficientsOptions& options)
{
    const bool has_turn = options.flutes && options.helix_deg;
    if (!has_turn || options.milling != Milling::Down || !(*options.helix_deg > 0) ||
        options.previous == PreviousPass::None)
        return;
    warn(options.common,
         "--helix-deg " + to_text(*options.helix_deg) +
             ": in down milling the model takes this angle as a left-hand cutter under "
             "M03; a right-hand cutter needs --helix-deg " +
             to_text(-*options.helix_deg));
}

void add_coefficients(Json& summary, const CuttingCoefficients& c)
{
    const std::array all{c.I1, c.I2, c.I3, c.I4, c.I5, c.I6, c.I7, c.I8};
    for (std::size_t k = 0; k < all.size(); ++k)
        summary["I" + std::to_string(k + 1)] = all[k];
}

void add_force(Json& summary, const CuttingForce& force)
{
    summary["force_x_n"] = force.x_n;
    summary["force_y_n"] = force.y_n;
    summary["force_z_n"] = force.z_n;
    summary["torque_n_m"] = force.torque_n_m;
}

std::string profile_text(const MillingCut& cut)
{
    std::vector<double> angles;
    angles.reserve(profile_angles);
    for (int k = 0; k < profile_angles; ++k)
        angles.push_back(2 * std::numbers::pi * k / profile_angles);
    return force_profile_csv(angles, force_profile(cut, angles));
}

// \return the folder that was written to, if any.
std::string write_results(const CoefficientsOptions& options, const Json& summary,
                          const std::optional<std::string>& profile)
{
    if (options.common.output.empty() && !profile)
        return {};
    OutputFolder folder{output_folder("profile", "coefficients", options.common),
                        options.common.full_folder};
    if (!options.material.empty())
        folder.protect(options.material);
    folder.write("summary.json", summary.dump(2) + "\n");
    if (profile)
        folder.write("profile.csv", *profile);
    folder.remove_unless_written("profile.csv");
    folder.publish();
    return folder.path().string();
}

ExitCode run_coefficients(const CoefficientsOptions& options)
{
    refuse_idle(options);
    const BallEngagement engagement = engagement_of(options);
    const ChipModel chip = options.chip.value_or(ChipModel::Paper);
    const MillingTool tool = tool_of(options);
    const CuttingCoefficients coefficients =
        cutting_coefficients(engagement, chip, options.accuracy);
    Json summary;
    add_coefficients(summary, coefficients);
    summary["engaged_angle_deg"] = Angle::radians(engaged_angle(engagement)).degrees();
    if (options.flutes && options.helix_deg)
        summary["peak_factor"] = peak_factor(engagement, chip, tool);
    std::optional<std::string> profile;
    if (has_forces(options)) {
        const CuttingMaterial material =
            read_material(options.material, options.common.limits);
        add_force(summary, mean_force(coefficients, material, tool,
                                      *options.feed_per_tooth_mm, options.milling));
        if (options.has_profile && options.helix_deg)
            profile = profile_text(
                {engagement,
                 chip,
                 material,
                 tool,
                 *options.feed_per_tooth_mm,
                 options.milling,
                 {options.runout_mm, Angle::degrees(options.runout_deg).radians()}});
    }
    if (options.has_profile && !profile)
        throw DomainError{
            "--profile: expected --material, --feed-per-tooth, --cutter, --flutes and "
            "--helix-deg"};
    remark_helix(options);
    const std::string folder = write_results(options, summary, profile);
    const std::string text = answer_lines(summary);
    print_result(options.common, summary,
                 folder.empty() ? text : text + "written to " + printable(folder) + "\n");
    return ExitCode::Yes;
}

}  // namespace

void add_coefficients_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "coefficients",
        "compute cutting action coefficients and forces of a ball-end mill");
    const auto options = std::make_shared<CoefficientsOptions>();
    add_coefficients_options(*command, *options);
    command->footer(
        "I1 to I8 are means of one tooth over a spindle revolution, in ball radii. "
        "--flutes and\n"
        "--helix-deg add peak_factor, the ratio of largest to mean torque. --material,\n"
        "--feed-per-tooth, --cutter and --flutes add the mean forces on the work: x "
        "along\n"
        "the feed, y across it towards the stock, z upwards.\n\n"
        "Prints the result. With --output or --profile it also writes summary.json to\n"
        "--output (default ./profile-coefficients).\n\n"
        "Example:\n"
        "  endmill coefficients --mu-deg 0 --lambda-deg -17 --pick-feed-ratio 0.5 "
        "--depth-ratio 1 --flutes 2 --helix-deg 30 --cutter ball:10 --feed-per-tooth 0.1 "
        "--material datasets/materials/steel.json");
    command->callback([options, &action] {
        action = [options] { return run_coefficients(*options); };
    });
}

}  // namespace endmill
