// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace endmill {

/// A line of canonical output: "   12 N..... NAME(argument, argument)".
struct CanonicalLine {
    std::string_view name;       ///< capitals, digits, _ and .
    std::string_view arguments;  ///< between the first ( and the last )
};

/// The parts of `line`; none if it is no such line.
std::optional<CanonicalLine> canonical_line(std::string_view line);

/// The next argument of `arguments`, without blanks around it, which is cut off with its
/// comma; none if nothing is left.
std::optional<std::string_view> take_argument(std::string_view& arguments);

}  // namespace endmill
