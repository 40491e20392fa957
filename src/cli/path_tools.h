// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "endmill/files/machining_data.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/removal.h"

namespace endmill {

/// The tools of a path in the order of cutting.
struct PathTools {
    Tool first;                           ///< before the first change
    std::vector<ToolChange> changes;      ///< to the other tools
    std::vector<NumberedTool> used = {};  ///< each once, ascending by number
};

/// The tools of `path` in the table of --tools. A tool that only moves at rapid speed
/// counts as the tool that follows.
/// \param file name of the path for messages.
/// \throws FormatError E_TOOLS if the path uses a tool without a row; DomainError if it
///         names no tool and the table has several, or if it cuts before its first tool.
PathTools tools_of_path(const ToolPath& path, const std::string& file,
                        const std::string& table_file,
                        const std::vector<NumberedTool>& table);

/// Gives rapids with tool 0, an empty spindle, the tool of the move before them, or else of
/// the first move with another one. A path in which tool 0 cuts does not change.
void put_rapids_of_no_tool_to_others(ToolPath& path);

/// Number and cutter of each tool of a summary; null for none.
Json cutters_json(const std::vector<NumberedTool>& tools);

/// The cutter of all tools, if they have the same one.
std::optional<Cutter> only_cutter(const PathTools& tools);

/// Refuses a path in which several tools cut, if no table describes them, and a path that
/// cuts before its first tool. \throws DomainError
void refuse_several_tools(const ToolPath& path, const std::string& file);

}  // namespace endmill
