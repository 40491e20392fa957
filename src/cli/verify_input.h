// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/verify_options.h"
#include "endmill/cutter/tool.h"
#include "endmill/post/program.h"
#include "endmill/simulation/verification.h"

namespace endmill {

/// All that `verify` reads, with what the command line left open filled in.
struct VerifyInput {
    std::string name;
    Program program;
    Tool tool;
    DeviationLimits limits;
    std::optional<PartFile> part;
    std::string part_file;  ///< empty without a part
    Block block;            ///< the stock, or the box around another
    std::optional<HeightStock> stock;
    std::vector<std::string> files;  ///< that must not be written to
};

/// Reads the path, its summary, the tool, the part and the stock.
/// \throws DomainError if no cutter is known, or --stock is none; FormatError, LimitError
///         as the readers.
VerifyInput read_verify_input(const VerifyOptions& options);

/// The task; refers to `input`.
VerificationTask verification_task(const VerifyInput& input,
                                   const VerifyOptions& options);

}  // namespace endmill
