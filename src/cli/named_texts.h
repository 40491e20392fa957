// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace endmill {

/// "NAME=TEXT" of a list such as "c=-40,a=25".
struct NamedText {
    std::string name;
    std::string text;
};

/// The items of such a list in their order.
/// \param option for messages. \param example of the whole list, for messages.
/// \throws DomainError for an item without a name or =.
std::vector<NamedText> named_texts(const std::string& option, const std::string& list,
                                   const std::string& example);

/// The parts of `text` between its separators: one more than it has of these.
std::vector<std::string> parts_of(const std::string& text, char separator);

}  // namespace endmill
