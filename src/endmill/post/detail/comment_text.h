// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "endmill/cutter/cutter.h"

namespace endmill {

/// `text` made safe for a comment or a name in a program: at most 80 ASCII characters,
/// without parentheses (they would end the comment), `$` and `%` (they would end a
/// statement or the tape), and control characters. A letter outside ASCII becomes `?`.
std::string comment_text(std::string_view text);

/// The comment at the start of a program: "endmill: NAME, cutter ball:15, tips". The last
/// part states what the coordinates are. It begins with a fixed word, so that no name can turn it into a comment that a control
/// obeys, such as "MSG, ...".
std::string opening_comment(std::string_view name, const std::optional<Cutter>& cutter,
                            std::string_view coordinates = "tips");

}  // namespace endmill
