// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/comment_text.h"

namespace endmill {
namespace {

// Characters.
constexpr std::size_t longest_comment = 80;

}  // namespace

std::string comment_text(std::string_view text)
{
    std::string clean;
    for (const char character : text) {
        const auto byte = static_cast<unsigned char>(character);
        // Further bytes of a letter in UTF-8 are dropped; its first byte becomes '?'.
        const bool is_continuation = (byte & 0xC0U) == 0x80U;
        const bool is_control = byte < 0x20U || byte == 0x7FU;
        if (is_continuation || is_control ||
            std::string_view{"()$%"}.find(character) != std::string_view::npos)
            continue;
        if (clean.size() == longest_comment)
            break;
        clean += byte < 0x80U ? character : '?';
    }
    return clean;
}

std::string opening_comment(std::string_view name, const std::optional<Cutter>& cutter,
                            std::string_view coordinates)
{
    std::string text = "endmill: ";
    if (const std::string clean = comment_text(name); !clean.empty())
        text += clean + ", ";
    if (cutter)
        text += "cutter " + cutter_word(*cutter) + ", ";
    return text += coordinates;
}

}  // namespace endmill
