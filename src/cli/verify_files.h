// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "cli/verify_input.h"
#include "cli/verify_summary.h"
#include "endmill/files/output_folder.h"

namespace endmill {

/// Options, input, task and result of a verification.
struct VerifyResult {
    const VerifyInput& input;
    const VerifyOptions& options;
    const VerificationTask& task;
    const Verification& verification;
    const std::optional<Deviation>& of_protected;  ///< gouges of a protected part
};

/// Writes all files of a verification into `folder` and replaces those of an earlier run.
/// \return summary.json
Json write_verification(const VerifyResult& result, OutputFolder& folder);

}  // namespace endmill
