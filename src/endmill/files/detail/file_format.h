// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace endmill {

/// The format that the beginning of a file's `content` shows, whatever its name says:
/// "STL", "OBJ", "OFF", "PLY", "STEP", "VTK", "XML", "G-code", "CSV", "UTF-16 text" or
/// "JSON"; none if nothing is recognised. A guess for messages, not a check.
std::optional<std::string_view> recognized_format(std::string_view content);

}  // namespace endmill
