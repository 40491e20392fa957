// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "endmill/files/read_file.h"

namespace endmill {

/// Parses a JSON text (RFC 8259, UTF-8, with or without a byte order mark) more strictly
/// than the JSON library does by default.
/// \param file name of the file for messages.
/// \throws FormatError E_JSON with line and column for a syntax error, invalid UTF-8, a
///         NUL byte, NaN, infinity, an overflowing number, content after the end, or
///         nesting deeper than 64; with a JSON pointer for a repeated key or a number
///         that underflows to zero.
/// \throws LimitError if the tree would exceed the memory limit. The estimate is made
///         from the text before the tree is built and is an upper bound.
std::unique_ptr<const nlohmann::json> json_tree(std::string_view text,
                                                const std::string& file,
                                                const ReadLimits& limits);

/// "/" and `key` as RFC 6901 escapes it in a pointer, shortened and `printable`.
std::string json_pointer_step(std::string_view key);

}  // namespace endmill
