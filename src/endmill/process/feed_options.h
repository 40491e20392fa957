// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/cutting_material.h"
#include "endmill/process/milling_machine.h"
#include "endmill/process/milling_tool.h"
#include "endmill/process/segment_feed.h"

namespace endmill {

class CoefficientTable;

/// What cuts what, where.
struct MillingJob {
    CuttingMaterial material;
    MillingTool tool;
    MachineLimits machine = {};
};

/// How the largest load of a turn is found. Torque and Direct need the tool's helix.
/// Source: spec of ball-end milling, section 4; the paper uses a factor R_m that it does not
/// print.
enum class PeakRule {
    Constant,  ///< a given factor times the mean, for every load
    Torque,  ///< likewise, the factor being that of the chip's torque of the helical flutes
    Direct  ///< each load of the helical flutes as it runs, no factor
};

/// Choices of a feed plan. The defaults are those of mode `paper`.
struct FeedPlanOptions {
    ChipModel chip = ChipModel::Paper;
    PeakRule peak = PeakRule::Constant;
    double peak_factor = 1.8;           ///< R_m of PeakRule::Constant, from 1
    LimitForm form = LimitForm::Paper;  ///< of force and power
    std::optional<double> max_feed_per_tooth_mm = {};  ///< none: the material's, if any
    std::optional<double> min_feed_per_tooth_mm = {};  ///< none: the material's, or 0.005
    double block_time_ms = 10;  ///< least time of a block; 0: no such rule
    double accuracy = 1e-6;     ///< largest error of a cutting action coefficient
    /// Where PeakRule::Constant has its coefficients from; none: each is computed. Of the same
    /// chip, and outlives the plan.
    const CoefficientTable* table = nullptr;
};

/// The options of mode `corrected`: exact chip, direct peaks, exact limits.
FeedPlanOptions corrected_feed_options();

/// The feeds per tooth that may be used, as `options` or else the material say.
FeedRange feed_range(const CuttingMaterial& material, const FeedPlanOptions& options);

/// The rules that `job` and `options` make. The torque's limit is the smaller of the tool's
/// and the spindle's.
/// \throws DomainError unless all is sound, the peak factor is from 1, and the least feed per
///         tooth is at most the largest.
FeedRules feed_rules(const MillingJob& job, const FeedPlanOptions& options);

}  // namespace endmill
