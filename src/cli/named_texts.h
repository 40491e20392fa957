// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace endmill {

/// One item "NAME=TEXT" of a list such as "c=-40,a=25".
struct NamedText {
    std::string name;
    std::string text;
};

/// Splits such a list into its items.
/// \param option name of the option, for messages.
/// \param example a complete list, for messages.
/// \throws DomainError for an item without a name or =.
std::vector<NamedText> named_texts(const std::string& option, const std::string& list,
                                   const std::string& example);

/// The parts of `text` between its separators. There is one part more than separators.
std::vector<std::string> parts_of(const std::string& text, char separator);

}  // namespace endmill
