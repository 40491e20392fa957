// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace endmill {

/// Two pictures in SVG as one: `left`, and `right` beside it, both with their upper edge
/// at the top. \pre both are texts of `SvgPicture`.
std::string side_by_side(const std::string& left, const std::string& right);

}  // namespace endmill
