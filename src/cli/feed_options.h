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

/// The rules by which `feed` plans.
enum class FeedMode {
    Paper,      ///< as printed, misprints corrected
    Corrected,  ///< exact chip, loads as the flutes turn, exact limits
    Planned     ///< Corrected, and the times of a machine with bounded acceleration
};

/// The source of the engagement of a cut.
enum class EngagementChoice { Auto, Contact, Passes, Stock };

/// The words of --mode.
inline constexpr std::array feed_modes{Choice<FeedMode>{"paper", FeedMode::Paper},
                                       Choice<FeedMode>{"corrected", FeedMode::Corrected},
                                       Choice<FeedMode>{"planned", FeedMode::Planned}};
/// The words of --engagement.
inline constexpr std::array engagement_choices{
    Choice<EngagementChoice>{"auto", EngagementChoice::Auto},
    Choice<EngagementChoice>{"contact", EngagementChoice::Contact},
    Choice<EngagementChoice>{"passes", EngagementChoice::Passes},
    Choice<EngagementChoice>{"stock", EngagementChoice::Stock}};
/// The words of --chip.
inline constexpr std::array chip_models{Choice<ChipModel>{"paper", ChipModel::Paper},
                                        Choice<ChipModel>{"exact", ChipModel::Exact}};
/// The words of --first-pass.
inline constexpr std::array first_passes{
    Choice<PreviousPass>{"slot", PreviousPass::None},
    Choice<PreviousPass>{"edge", PreviousPass::Edge}};
/// The source of the cutting action coefficients.
enum class CoefficientSource {
    Direct,  ///< each coefficient is computed
    Table,   ///< interpolated, with errors up to `table_error`
};

/// The words of --coefficients.
inline constexpr std::array coefficient_sources{
    Choice<CoefficientSource>{"direct", CoefficientSource::Direct},
    Choice<CoefficientSource>{"table", CoefficientSource::Table}};

/// Domain of the angles of feed and pick feed, which a right angle is not part of.
inline const NumberDomain slope_domain = NumberDomain::between(-90, 90);
/// Domain of --helix-deg: see `most_helix`.
inline const NumberDomain helix_domain = NumberDomain::from_to(-80, 80);
/// Domain of --accuracy, the one of `cutting_coefficients`.
inline const NumberDomain accuracy_domain = NumberDomain::from_to(1e-12, 1e-3);

/// Help text of --helix-deg.
inline constexpr const char* helix_help =
    "helix angle under M03: positive for a right-hand cutter in up milling, negative for "
    "a right-hand cutter in down milling";

/// Largest number of flutes. No end mill has more, and larger sums would take long.
inline constexpr int most_flutes = 100;

/// The rule that --peak names.
struct PeakChoice {
    PeakRule rule = PeakRule::Constant;
    double factor = 1.8;  ///< of PeakRule::Constant
};

/// Largest error of a coefficient from the table: see CoefficientTable.
inline constexpr double table_error = 0.025;

/// The rule as --peak takes it: "constant:1.8", "torque" or "direct".
std::string peak_word(PeakRule rule, double factor);

/// Options of the tool. They replace the values of the tool file, if there is one.
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
    PartOptions part;  ///< without a part its path is empty
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

/// Adds --chip, which `feed` and `coefficients` share.
/// \param default_words the default, as the help text states it.
void add_chip_option(CLI::App& command, std::optional<ChipModel>& chip,
                     const std::string& default_words);

/// Adds every option of `feed` to `command`.
void add_feed_options(CLI::App& command, FeedCommandOptions& options);

/// \throws DomainError naming an option that has no effect with the other options.
void refuse_idle_feed_options(const FeedCommandOptions& options);

}  // namespace endmill
