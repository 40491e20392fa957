// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "endmill/cutter/tool.h"
#include "endmill/files/read_file.h"

namespace endmill {

/// The tool in a file of format "endmill-tool/1": `cutter` as on the command line, and as
/// far as it says so `name`, `source`, `flutes`, `helix_deg`, `length_mm`, `limits`
/// {`cutting_force_n`, `thrust_n`, `torque_n_m`}, `shank` and `holder`, lists of cylinders
/// {`diameter_mm`, `from_mm`, `to_mm`} above the tip.
/// \throws FormatError as `JsonDocument`, with the JSON pointer, for a key that is unknown
///         or a value out of its range; E_FORMAT for another format; and as `read_file`.
Tool read_tool(const std::filesystem::path& path, const ReadLimits& limits = {});

/// The same from what the file holds; `path` is named in messages.
Tool parse_tool(std::string_view content, const std::filesystem::path& path,
                const ReadLimits& limits = {});

}  // namespace endmill
