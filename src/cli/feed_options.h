// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "cli/arguments.h"
#include "cli/path_options.h"
#include "cli/surface_facts.h"
#include "endmill/process/feed_plan.h"
#include "endmill/process/segment_cuts.h"

namespace endmill {

/// By which rules `feed` plans.
enum class FeedMode {
    Paper,      ///< as printed, misprints corrected
    Corrected,  ///< exact chip, loads as the flutes turn, exact limits
    Planned     ///< that, and what a machine with bounded acceleration makes of it
};

/// Where the engagement of a cut comes from.
enum class EngagementChoice { Auto, Contact, Passes, Stock };

/// The words of `feed` and `coefficients` for what their options stand for.
inline constexpr std::array feed_modes{Choice<FeedMode>{"paper", FeedMode::Paper},
                                       Choice<FeedMode>{"corrected", FeedMode::Corrected},
                                       Choice<FeedMode>{"planned", FeedMode::Planned}};
/// Ditto.
inline constexpr std::array engagement_choices{
    Choice<EngagementChoice>{"auto", EngagementChoice::Auto},
    Choice<EngagementChoice>{"contact", EngagementChoice::Contact},
    Choice<EngagementChoice>{"passes", EngagementChoice::Passes},
    Choice<EngagementChoice>{"stock", EngagementChoice::Stock}};
/// Ditto.
inline constexpr std::array chip_models{Choice<ChipModel>{"paper", ChipModel::Paper},
                                        Choice<ChipModel>{"exact", ChipModel::Exact}};
/// Ditto.
inline constexpr std::array first_passes{
    Choice<PreviousPass>{"slot", PreviousPass::None},
    Choice<PreviousPass>{"edge", PreviousPass::Edge}};
/// Where cutting action coefficients come from.
enum class CoefficientSource {
    Direct,  ///< each is computed
    Table,   ///< interpolated: off by up to `table_error`
};

/// Ditto.
inline constexpr std::array coefficient_sources{
    Choice<CoefficientSource>{"direct", CoefficientSource::Direct},
    Choice<CoefficientSource>{"table", CoefficientSource::Table}};

/// A right angle is none of a feed or a pick feed.
inline const NumberDomain slope_domain = NumberDomain::between(-90, 90);
/// Of --helix-deg: see `most_helix`.
inline const NumberDomain helix_domain = NumberDomain::from_to(-80, 80);
/// Of --accuracy, as `cutting_coefficients` takes it.
inline const NumberDomain accuracy_domain = NumberDomain::from_to(1e-12, 1e-3);

/// What --helix-deg means, as its help says.
inline constexpr const char* helix_help =
    "angle of the flutes against the axis; in down milling the model's positive helix is "
    "a "
    "left-hand cutter under M03, a right-hand one has the negative angle";

/// More edges than any mill has; the sums over more would take long.
inline constexpr int most_flutes = 100;

/// The rule that --peak names.
struct PeakChoice {
    PeakRule rule = PeakRule::Constant;
    double factor = 1.8;  ///< of PeakRule::Constant
};

/// Largest error of a coefficient from the table: see CoefficientTable.
inline constexpr double table_error = 0.025;

/// As on the command line: "constant:1.8", "torque" or "direct".
std::string peak_word(PeakRule rule, double factor);

/// A tool without a file, or values in place of those in the file.
struct ToolOptions {
    std::string file;
    std::optional<int> flutes;
    std::optional<double> helix_deg;
    std::optional<double> max_force_n;
    std::optional<double> max_thrust_n;
    std::optional<double> max_torque_n_m;
};

/// The options of `endmill feed`.
struct FeedCommandOptions {
    CommonOptions common;
    PathOptions path;
    PartOptions part;  ///< its path empty: no part
    std::string material;
    std::string machine;  ///< empty: none
    ToolOptions tool;
    FeedMode mode = FeedMode::Paper;
    EngagementChoice engagement = EngagementChoice::Auto;
    PreviousPass first_pass = PreviousPass::None;
    std::optional<double> stock_top;  ///< mm
    std::string stock = "block";      ///< as in `verify`
    double resolution = 0.1;          ///< mm, of the stock
    double contact_tolerance = 0.05;  ///< mm
    double accuracy = 1e-6;           ///< of a coefficient
    CoefficientSource coefficients = CoefficientSource::Direct;
    std::optional<ChipModel> chip;   ///< empty: the mode's
    std::optional<PeakChoice> peak;  ///< empty: the mode's
    std::optional<double> min_feed_per_tooth_mm;
    std::optional<double> max_feed_per_tooth_mm;
    double block_time_ms = 10;
    double corner_tolerance = 0.01;  ///< mm
    std::optional<double> rapid_mm_per_min;
    std::optional<double> noncut_min;
    std::optional<double> constant_feed_mm_per_min;
    double plunge_feed_mm_per_min = 200;
    bool allow_infeasible = false;
};

/// Adds --chip, as the commands share it.
void add_chip_option(CLI::App& command, std::optional<ChipModel>& chip);

/// Adds every option of `feed` to `command`.
void add_feed_options(CLI::App& command, FeedCommandOptions& options);

/// \throws DomainError naming an option that has no effect beside the others.
void refuse_idle_feed_options(const FeedCommandOptions& options);

}  // namespace endmill
