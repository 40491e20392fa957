// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace endmill {

/// A line of canonical output: "   12 N..... NAME(argument, argument)".
struct CanonicalLine {
    std::string_view name;       ///< name of the command: capitals, digits, _ and .
    std::string_view arguments;  ///< text between the first ( and the last )
};

/// The parts of `line`, or std::nullopt if it has another form.
std::optional<CanonicalLine> canonical_line(std::string_view line);

/// Removes the next argument with its comma from `arguments`.
/// \return the argument without surrounding blanks, or std::nullopt if none is left.
std::optional<std::string_view> take_argument(std::string_view& arguments);

}  // namespace endmill
