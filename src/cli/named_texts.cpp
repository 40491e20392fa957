// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/named_texts.h"

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {

std::vector<std::string> parts_of(const std::string& text, char separator)
{
    std::vector<std::string> parts{""};
    for (const char c : text)
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

std::vector<NamedText> named_texts(const std::string& option, const std::string& list,
                                   const std::string& example)
{
    std::vector<NamedText> items;
    for (const std::string& item : parts_of(list, ',')) {
        const std::size_t equals = item.find('=');
        if (equals == 0 || equals == std::string::npos)
            throw DomainError{option + ": found \"" + printable(item) +
                              "\"; expected a list such as " + example};
        items.push_back({item.substr(0, equals), item.substr(equals + 1)});
    }
    return items;
}

}  // namespace endmill
