// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/trim_options.h"
#include "cli/trim_sections.h"
#include "endmill/files/output_folder.h"
#include "endmill/trimming/trimming_quality.h"

namespace endmill {

/// The method whose curves are the exact ones.
inline constexpr std::string_view exact_method = "envelope";

/// The runs of one method on all planes.
struct MethodRuns {
    std::string_view name;                     ///< of the method
    std::vector<double> times_ms;              ///< wall times, one for each repetition
    std::vector<Trimmed> trimmed;              ///< one for each plane
    std::vector<CurveDifference> differences;  ///< from the exact curves, a plane each
};

/// Median and quartiles of times in ms.
struct TimeSpread {
    double median = 0;
    double lower_quartile = 0;
    double upper_quartile = 0;
    double least = 0;
    double greatest = 0;
};

/// Median and quartiles of `times_ms`, by linear interpolation between neighbours.
/// \pre there is a time.
TimeSpread time_spread(std::vector<double> times_ms);

/// Trims the sections by every method, or by those of --compare-only, and compares the results
/// with those of the exact method `envelope`. A first run of each method is not timed. Then,
/// with --repeat, every repetition runs all methods once, each time beginning with another
/// one, so that slow changes of the machine affect all of them. All runs are those of this
/// process, on its threads; no other rank takes part.
/// \throws as trim_planes.
std::vector<MethodRuns> run_methods(const TrimInput& input, const TrimOptions& options);

/// The plane in which a method is farthest from the exact curve; the first of several.
std::size_t worst_plane(std::span<const MethodRuns> methods);

/// Times and differences of all methods, and the number of planes that each gets wrong by
/// depth of interference, for summary.json.
Json comparison_summary(std::span<const MethodRuns> methods, const TrimInput& input,
                        const TrimOptions& options);

/// The same as a report for the terminal.
std::string comparison_text(const Json& comparison, const TrimOptions& options);

/// Writes times.csv, differences.csv and comparison.svg.
void write_comparison(std::span<const MethodRuns> methods, const TrimInput& input,
                      const TrimOptions& options, OutputFolder& folder);

/// Draws the curves that the methods left in one plane, with the cutter where they differ
/// most.
std::string compared_picture(std::span<const MethodRuns> methods, const TrimInput& input,
                             const TrimOptions& options, std::size_t plane);

}  // namespace endmill
