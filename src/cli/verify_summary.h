// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/verify_options.h"
#include "endmill/files/machining_data.h"
#include "endmill/post/program.h"
#include "endmill/verification/verification.h"

namespace endmill {

/// The input of a verification that its summary reports.
struct VerifyContext {
    std::string name;
    std::string part;   ///< its file; empty without one
    std::string stock;  ///< in words
    Cutter cutter;      ///< of the first tool
    DeviationLimits limits;
    const Program& program;
    std::vector<NumberedTool> tools;  ///< that the path uses; empty without --tools
};

/// The words of the cutters, as "ball:6" or "T1 ball:6, T2 flat:10".
std::string cutter_words(const Cutter& first, const std::vector<NumberedTool>& tools);

/// summary.json of `verify`. Deviations are null without a part.
/// \param charts of the part, if there is one.
Json verify_summary(const VerifyContext& context, const VerifyOptions& options,
                    const Verification& verification, const PartCharts* charts);

/// One sentence for each rule that the path breaks or may break, apart from the limits
/// of the deviation. The rules forbid rapids that cut, and a shank or holder in the
/// material or part.
std::vector<std::string> broken_rules(const Verification& verification);

/// The report on the terminal: the verdict with its grounds, gouge, remaining stock,
/// removal and path.
std::string verify_text(const Json& summary, const VerifyOptions& options,
                        const Verification& verification);

}  // namespace endmill
