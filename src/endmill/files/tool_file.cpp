// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include "endmill/files/detail/json_format.h"
#include "endmill/files/detail/tool_value.h"
#include "endmill/files/read_file.h"

namespace endmill {

Tool read_tool(const std::filesystem::path& path, const ReadLimits& limits)
{
    return parse_tool(read_file(path, limits), path, limits);
}

Tool parse_tool(std::string_view content, const std::filesystem::path& path,
                const ReadLimits& limits)
{
    const FormatDocument document{content, path, limits, tool_format};
    const JsonValue root = document.root();
    Tool tool = tool_in(root, limits);
    tool.name = name_or_stem(root, path);
    return tool;
}

}  // namespace endmill
