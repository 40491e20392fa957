// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/trim_options.h"
#include "cli/trim_sections.h"
#include "endmill/path/tool_path.h"
#include "endmill/trimming/cut_out.h"

namespace endmill {

/// How what a method left is off the upper envelope of the sections.
struct Comparison {
    std::size_t wrong = 0;        ///< sections that step back, or lie too far below it
    double deepest_below_mm = 0;  ///< the envelope, of all sections
};

/// What one method made of the sections.
struct TrimResult {
    std::string method;
    TrimmingOptions options;
    std::vector<Trimmed> trimmed;            ///< one a plane
    std::vector<std::vector<CutOut>> loops;  ///< one a plane
    ToolPath path;                           ///< empty for curves
    double trim_ms = 0;                      ///< wall time of the method
    std::optional<Comparison> comparison;    ///< if all methods are compared
    std::optional<double> min_clearance;     ///< mm; none for curves, or without a path
    std::optional<double> sampling_error;    ///< mm
    std::optional<std::size_t> unrefined;    ///< if it was refined
};

/// Folds that are left.
std::size_t unresolved(const TrimResult& result);

/// Deepest gouge in mm; none where the clearance is not known.
std::optional<double> max_gouge(const TrimResult& result);

/// The summary of one method.
Json trim_summary(const TrimInput& input, const TrimOptions& options,
                  const TrimResult& result);

/// The report for a person: counts, time and clearance.
std::string trim_text(const Json& summary);

/// A table that compares methods on the same sections, a line for each method.
/// \param methods their summaries by name.
std::string methods_text(const Json& methods);

}  // namespace endmill
