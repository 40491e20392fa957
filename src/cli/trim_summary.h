// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/trim_options.h"
#include "cli/trim_sections.h"
#include "endmill/path/tool_path.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/trimming_quality.h"

namespace endmill {

/// The result of one method.
struct TrimResult {
    std::string method;
    TrimmingOptions options;
    std::vector<Trimmed> trimmed;                  ///< one for each plane
    std::vector<std::vector<CutOut>> loops;        ///< one list for each plane
    ToolPath path;                                 ///< empty for curves
    std::size_t dropped_points = 0;                ///< that thinning took from the path
    double thin_tolerance = 0;                     ///< mm, within which it did
    double trim_ms = 0;                            ///< wall time of the method
    std::optional<EnvelopeComparison> comparison;  ///< only with --method all
    std::optional<double> min_clearance;   ///< mm; empty for curves or without a path
    std::optional<std::string> nearest;    ///< the place of the clearance, in words
    std::optional<double> sampling_error;  ///< mm
    std::optional<std::size_t> unrefined;  ///< only with --refine
};

/// Number of folds that are left.
std::size_t unresolved(const TrimResult& result);

/// Depth of the deepest gouge in mm; empty if the clearance is not known.
std::optional<double> max_gouge(const TrimResult& result);

/// The summary of one method.
Json trim_summary(const TrimInput& input, const TrimOptions& options,
                  const TrimResult& result);

/// The report on the terminal: counts, time and clearance.
std::string trim_text(const Json& summary);

/// A table that compares methods on the same sections, with one line for each method.
/// \param methods their summaries by name.
std::string methods_text(const Json& methods);

}  // namespace endmill
