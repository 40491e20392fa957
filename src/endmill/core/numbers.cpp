// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace endmill {

void append_text(std::string& text, double value)
{
    assert(std::isfinite(value));
    std::array<char, 32> buffer;  // the longest shortest double has 24 characters
    const double unsigned_zero = value == 0 ? 0 : value;
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), unsigned_zero);
    assert(error == std::errc{});
    text.append(buffer.data(), end);
}

std::string to_text(double value)
{
    std::string text;
    append_text(text, value);
    return text;
}

std::optional<double> number_from_text(std::string_view text)
{
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    double value = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string counted(std::size_t count, std::string_view thing)
{
    std::string text = std::to_string(count) + ' ';
    text += thing;
    return count == 1 ? text : text + 's';
}

}  // namespace endmill
