// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>

namespace endmill {

/// `text` from a file or a command line, made fit for one line on a terminal: without
/// control characters (C0, DEL, C1), line separators and marks that turn the direction
/// of writing; each byte that is not UTF-8 becomes '?'.
/// \param max_characters if more remain, the first so many and "…".
std::string printable(std::string_view text, std::size_t max_characters =
                                                 std::numeric_limits<std::size_t>::max());

}  // namespace endmill
