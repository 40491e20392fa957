// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/verify_options.h"
#include "endmill/post/program.h"
#include "endmill/verification/verification.h"

namespace endmill {

/// What was verified, with what the command line left open filled in.
struct VerifyContext {
    std::string name;
    std::string part;   ///< its file; empty without one
    std::string stock;  ///< in words
    Cutter cutter;
    DeviationLimits limits;
    const Program& program;
};

/// Which bounds were made as close as the verdict needs. A gouge settles it, and too much
/// left settles that much: what bounds the rest then is that of the first rays.
struct RefinedBounds {
    bool gouge;
    bool scallop;
};

/// Those of a deviation.
RefinedBounds refined_bounds(const Deviation& deviation, const DeviationLimits& limits);

/// summary.json of `verify`. Deviations are null without a part.
/// \param charts of the part, if there is one.
Json verify_summary(const VerifyContext& context, const VerifyOptions& options,
                    const Verification& verification, const PartCharts* charts);

/// A sentence for each rule that the path breaks, or may break, whatever it leaves on the
/// part: rapids that cut, and a shank or holder in the material or the part.
std::vector<std::string> broken_rules(const Verification& verification);

/// The summary for a person.
std::string verify_text(const Json& summary, const Verification& verification);

}  // namespace endmill
