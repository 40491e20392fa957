// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "endmill/cutter/tool.h"
#include "endmill/files/detail/strict_json.h"
#include "endmill/files/read_file.h"

namespace endmill {

/// Format of a tool file.
inline constexpr std::string_view tool_format = "endmill-tool/1";

/// The tool that an object describes by the keys of a tool file. The value of its key
/// `format` is not checked. The name is empty if it is missing.
/// \throws FormatError with the JSON pointer for an unknown key or a value out of range.
Tool tool_in(const JsonValue& root, const ReadLimits& limits);

}  // namespace endmill
