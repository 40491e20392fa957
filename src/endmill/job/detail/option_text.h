// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/files/detail/strict_json.h"

namespace endmill {

/// A value of a JSON file as the command line has it: a text unchanged, a number as its
/// shortest text, true or false, or an array of numbers joined by commas.
/// \throws FormatError for another value, and for a text with control characters.
std::string option_text(const JsonValue& value);

/// Whether the text has control characters or is no UTF-8.
bool has_control_characters(const std::string& text);

}  // namespace endmill
