// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/verify_options.h"
#include "cli/verify_stock.h"
#include "endmill/cutter/tool.h"
#include "endmill/post/program.h"
#include "endmill/verification/verification.h"

namespace endmill {

/// All that `verify` reads, with what the command line left open filled in.
struct VerifyInput {
    std::string name;
    Program program;
    Tool tool;
    DeviationLimits limits;
    std::optional<PartFile> part = {};
    std::string part_path = {};  ///< empty without a part
    VerifyStock stock = {};
};

/// Reads the path, its summary, the tool, the part and the stock.
/// \throws DomainError if no cutter is known, or --stock is none; GeometryError, naming
///         the file, for a path without a move or a stock that is not closed; FormatError,
///         LimitError as the readers.
VerifyInput read_verify_input(const VerifyOptions& options);

/// The files that were read, which must not be written to.
std::vector<std::string> files_of(const VerifyInput& input, const VerifyOptions& options);

/// The task; refers to `input`.
VerificationTask verification_task(const VerifyInput& input,
                                   const VerifyOptions& options);

}  // namespace endmill
