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

/// The input of `feed`, completed by the defaults of the command line.
struct FeedInput {
    std::string name;
    Program program;
    PathFormat format = PathFormat::Csv;  ///< a machine program is also written again
    std::string text = {};                ///< of a G-code program, whose lines are kept
    GcodeReadOptions reading = {};        ///< options with which the program was read
    PathSummary known;
    Tool tool;
    MillingJob job;
    FeedPlanOptions plan;
    std::vector<Surface> part = {};
    VerifyStock stock = {};
    double stock_top = 0;           ///< mm
    std::string stock_top_by = {};  ///< what gives the top, for the report
};

/// Reads the path, its summary, the tool, material, machine, part and stock. The top of
/// the stock is that of --stock-top, of --stock or of --part, or else of the part that the
/// summary names. Without any of these it is the `entry_height` of the path.
/// \throws DomainError if the cutter, flutes, helix or top of the stock is needed but not
///         known, if the cutter is not a ball, and if the part is a mesh; FormatError for
///         points out of order; FormatError and LimitError as the readers.
FeedInput read_feed_input(const FeedCommandOptions& options);

/// The files that were read. They must not be overwritten.
std::vector<std::string> files_of(const FeedInput& input,
                                  const FeedCommandOptions& options);

}  // namespace endmill
