// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "endmill/cutter/cutter.h"

namespace endmill {

/// `text` made fit for a comment or a name in a program: ASCII, at most 80 characters, no
/// parentheses, which would end the comment, no `$` and `%`, which would end a statement
/// or the tape, no control characters. What is not ASCII becomes `?`, a letter each.
std::string comment_text(std::string_view text);

/// What a program says of itself: "endmill: NAME, cutter ball:15, tips". It begins with a
/// word of ours, so that no name can make it one of the comments that a control obeys,
/// such as "MSG, ...".
std::string opening_comment(std::string_view name, const std::optional<Cutter>& cutter);

}  // namespace endmill
