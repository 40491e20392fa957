// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/path_tools.h"
#include "cli/verify_options.h"
#include "cli/verify_stock.h"
#include "endmill/cutter/tool.h"
#include "endmill/post/program.h"
#include "endmill/strategy/protected_part.h"
#include "endmill/verification/verification.h"

namespace endmill {

/// The input of `verify`, completed by the defaults of the command line.
struct VerifyInput {
    std::string name;
    Program program;
    Tool tool;  ///< the first one
    DeviationLimits limits;
    InaccessibleStock inaccessible = InaccessibleStock::Count;
    RemovalEngine engine = RemovalEngine::ThreeAxis;
    std::optional<PartFile> part = {};
    std::string part_path = {};                       ///< empty without a part
    std::shared_ptr<const Part> guard_part = {};      ///< that the path must not enter
    std::shared_ptr<const ProtectedPart> guard = {};  ///< the same, for the ball
    std::string guard_path = {};                      ///< empty without it
    std::string skip_file = {};                       ///< list of facets; may be empty
    std::vector<int> cut_faces = {};                  ///< from 1; empty: all
    std::vector<std::size_t> skipped = {};            ///< facets by numbers in the file
    VerifyStock stock = {};
    std::vector<ToolChange> changes = {};       ///< to other tools, with --tools
    std::vector<NumberedTool> tools = {};       ///< that the path uses, with --tools
    std::optional<MachineMotion> machine = {};  ///< by which the path was read
    std::optional<Vec3> upright_axis = {};      ///< the tool axis that was turned to +z
};

/// Reads the path, its summary, the tool, the part and the stock.
/// \throws DomainError if the cutter is not known or --stock is not a stock;
///         GeometryError, naming the file, for a path without moves or a stock that is
///         not closed; FormatError, LimitError as the readers.
VerifyInput read_verify_input(const VerifyOptions& options);

/// The files that were read. They must not be overwritten.
std::vector<std::string> files_of(const VerifyInput& input, const VerifyOptions& options);

/// The verification task. It refers to `input`.
VerificationTask verification_task(const VerifyInput& input,
                                   const VerifyOptions& options);

}  // namespace endmill
