// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "endmill/process/cutting_force.h"

namespace endmill {

/// The options of `endmill coefficients`.
struct CoefficientsOptions {
    CommonOptions common;
    std::optional<double> mu_deg;           ///< required
    std::optional<double> lambda_deg;       ///< required
    std::optional<double> pick_feed_ratio;  ///< required with a previous pass
    std::optional<double> depth_ratio;      ///< required
    PreviousPass previous = PreviousPass::Beside;
    std::optional<ChipModel> chip;
    std::optional<int> flutes;
    std::optional<double> helix_deg;
    std::string material;  ///< file; empty: none
    std::optional<double> feed_per_tooth_mm;
    std::optional<double> diameter_mm;  ///< of the ball
    Milling milling = Milling::Down;
    double accuracy = 1e-10;
    bool has_profile = false;
    double runout_mm = 0;
    double runout_deg = 0;
};

/// Adds every option of `coefficients` to `command`.
void add_coefficients_options(CLI::App& command, CoefficientsOptions& options);

}  // namespace endmill
