// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace endmill {

/// The format that the first bytes of `content` suggest, independent of the file's name:
/// "STL", "OBJ", "OFF", "PLY", "STEP", "VTK", "XML", "G-code", "CSV", "UTF-16 text" or
/// "JSON".
/// \return nothing if no format is recognised. The result selects a reader or improves a
///         message; it does not validate the content.
std::optional<std::string_view> recognized_format(std::string_view content);

}  // namespace endmill
