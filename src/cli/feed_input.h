// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/feed_options.h"
#include "cli/verify_stock.h"
#include "endmill/cutter/tool.h"
#include "endmill/files/path_file.h"
#include "endmill/post/program.h"

namespace endmill {

/// All that `feed` reads, with what the command line left open filled in.
struct FeedInput {
    std::string name;
    Program program;
    PathFormat format = PathFormat::Csv;  ///< a machine program is written again, too
    std::string text = {};                ///< of a G-code program: its lines are kept
    GcodeReadOptions reading = {};        ///< how it was read
    PathSummary known;
    Tool tool;
    MillingJob job;
    FeedPlanOptions plan;
    std::vector<Surface> part = {};
    VerifyStock stock = {};
    double stock_top = 0;  ///< mm
};

/// Reads path, its summary, tool, material, machine, part and stock.
/// \throws DomainError if no cutter, flutes, helix or stock's top is known where one is
///         needed, for a cutter other than a ball, and if the part is a mesh; FormatError,
///         LimitError as the readers, and for points out of order.
FeedInput read_feed_input(const FeedCommandOptions& options);

/// The files that were read, which must not be written to.
std::vector<std::string> files_of(const FeedInput& input,
                                  const FeedCommandOptions& options);

}  // namespace endmill
