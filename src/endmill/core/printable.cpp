// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/text.h"

namespace endmill {
namespace {

struct CodePoint {
    char32_t value;
    std::size_t bytes;  // 0 where the text is not UTF-8
};

constexpr CodePoint not_utf8{0, 0};

// Bytes of a sequence that starts with `lead`, and 0 for a byte that starts none.
std::size_t sequence_length(unsigned char lead)
{
    if (lead < 0x80)
        return 1;
    if (lead < 0xc2 || lead > 0xf4)
        return 0;
    return lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
}

bool is_scalar_value(char32_t value, std::size_t bytes)
{
    const bool overlong =
        (bytes == 3 && value < 0x800) || (bytes == 4 && value < 0x10000);
    const bool surrogate = 0xd800 <= value && value <= 0xdfff;
    return !overlong && !surrogate && value <= 0x10ffff;
}

CodePoint first_code_point(std::string_view text)
{
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t bytes = sequence_length(lead);
    if (bytes == 0 || bytes > text.size())
        return not_utf8;
    if (bytes == 1)
        return {lead, 1};
    char32_t value = lead & (0x7fU >> bytes);
    for (const char byte : text.substr(1, bytes - 1)) {
        const auto next = static_cast<unsigned char>(byte);
        if ((next & 0xc0U) != 0x80)
            return not_utf8;
        value = (value << 6U) | (next & 0x3fU);
    }
    return is_scalar_value(value, bytes) ? CodePoint{value, bytes} : not_utf8;
}

bool is_shown(char32_t value)
{
    const bool control = value < 0x20 || (0x7f <= value && value < 0xa0);
    const bool separator = value == 0x2028 || value == 0x2029;
    const bool direction = value == 0x200e || value == 0x200f || value == 0x061c ||
                           (0x202a <= value && value <= 0x202e) ||
                           (0x2066 <= value && value <= 0x2069);
    return !control && !separator && !direction;
}

}  // namespace

std::string printable(std::string_view text, std::size_t max_characters)
{
    std::string result;
    std::size_t characters = 0;
    while (!text.empty()) {
        const CodePoint next = first_code_point(text);
        const std::size_t bytes = next.bytes == 0 ? 1 : next.bytes;
        if (next.bytes == 0 || is_shown(next.value)) {
            if (characters == max_characters)
                return result + "…";
            result += next.bytes == 0 ? std::string_view{"?"} : text.substr(0, bytes);
            ++characters;
        }
        text.remove_prefix(bytes);
    }
    return result;
}

}  // namespace endmill
