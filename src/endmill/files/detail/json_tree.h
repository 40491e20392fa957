// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "endmill/files/read_file.h"

namespace endmill {

/// The tree that a JSON text (RFC 8259, UTF-8, with or without a byte order mark) spells,
/// read more strictly than the library does by itself.
///
/// \param file the name for messages.
/// \throws FormatError E_JSON with line and column for an error of syntax, bad UTF-8, a
///         NUL byte, NaN, infinity, an overflowing number, content after the end, or
///         nesting deeper than 64; with a JSON pointer for a duplicate key or a number
///         that underflows to zero.
/// \throws LimitError if the tree would exceed the memory limit; the estimate counts its
///         values, before any is made, and is never below what they take.
std::unique_ptr<const nlohmann::json> json_tree(std::string_view text,
                                                const std::string& file,
                                                const ReadLimits& limits);

/// "/" and `key` as RFC 6901 writes it in a pointer, shortened and `printable`.
std::string json_pointer_step(std::string_view key);

}  // namespace endmill
