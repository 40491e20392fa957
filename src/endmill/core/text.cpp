// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/text.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "endmill/core/detail/number_text.h"

namespace endmill {
namespace {

// A character and the length of its encoding.
struct CodePoint {
    char32_t value;
    std::size_t bytes;  // 0 if the text does not begin with valid UTF-8
};

constexpr CodePoint not_utf8{0, 0};

// Length in bytes of the UTF-8 sequence that begins with `lead`; 0 if none begins so.
std::size_t sequence_length(unsigned char lead)
{
    if (lead < 0x80)
        return 1;
    if (lead < 0xc2 || lead > 0xf4)
        return 0;
    return lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
}

// Whether a value decoded from so many bytes is a Unicode scalar value in its shortest
// form.
bool is_scalar_value(char32_t value, std::size_t bytes)
{
    const bool overlong =
        (bytes == 3 && value < 0x800) || (bytes == 4 && value < 0x10000);
    const bool surrogate = 0xd800 <= value && value <= 0xdfff;
    return !overlong && !surrogate && value <= 0x10ffff;
}

// The first character of a text that is not empty.
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

// Whether a character is printed: it moves no cursor, breaks no line and turns no text
// around.
bool is_shown(char32_t value)
{
    const bool control = value < 0x20 || (0x7f <= value && value < 0xa0);
    const bool separator = value == 0x2028 || value == 0x2029;
    const bool direction = value == 0x200e || value == 0x200f || value == 0x061c ||
                           (0x202a <= value && value <= 0x202e) ||
                           (0x2066 <= value && value <= 0x2069);
    return !control && !separator && !direction;
}

// Longer words get no suggestion: the time of a comparison grows with the square of the
// length.
constexpr std::size_t longest_word = 64;

using Row = std::vector<std::size_t>;

// The least number of edits that turns `a` into `b`, where no letter is edited twice
// (optimal string alignment). Row i of the usual table holds the distances of the first i
// letters of `a` from all beginnings of `b`; a swap of neighbours needs the row before
// the last one.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    Row before_last(b.size() + 1);
    Row last(b.size() + 1);
    Row row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
        std::swap(before_last, last);
        std::swap(last, row);
    }
    return last.back();
}

std::string quoted(std::string_view word)
{
    return '"' + std::string{word} + '"';
}

// Length of the unit that both names end in, such as "_mm" of "x_mm" and "y_mm". It says
// nothing about how close the names are.
std::size_t common_unit(std::string_view a, std::string_view b)
{
    const std::size_t underscore = a.rfind('_');
    const bool is_common =
        underscore != std::string_view::npos && b.ends_with(a.substr(underscore));
    return is_common ? a.size() - underscore : 0;
}

// Decimals with at most nine digits after the point and fifteen in all. Different ones are
// different doubles, so the one that gives a double is its shortest text. These are the
// bounds between which that text has no exponent.
constexpr double nano = 1e9;
constexpr int nano_digits = 9;
constexpr std::int64_t units_of_one = 1'000'000'000;
constexpr double most_short = 1e6;  // exclusive, of the magnitude
constexpr double least_short = 0.01;
constexpr double most_short_whole = 10'000;  // exclusive

// Writes the value if it is such a decimal, as coordinates in programs are. Returns the end,
// or null for another value. This takes a fraction of the time of the general case.
char* write_short_decimal(char* end, double value)
{
    const double size = std::abs(value);
    if (!(size < most_short) || (size < least_short && size != 0))
        return nullptr;
    const double above = size * nano + 0.5;
    const auto units = static_cast<std::int64_t>(above);
    if (static_cast<double>(units) / nano != size)
        return nullptr;
    auto fraction = static_cast<std::uint32_t>(units % units_of_one);
    if (fraction == 0 && size >= most_short_whole)
        return nullptr;
    if (value < 0)
        *end++ = '-';
    constexpr std::size_t most_digits =
        7;  // of the whole part, whose type has room for more
    end = std::to_chars(end, end + most_digits, units / units_of_one).ptr;
    if (fraction != 0) {
        *end++ = '.';
        for (int k = nano_digits; k-- > 0; fraction /= 10)
            end[k] = static_cast<char>('0' + fraction % 10);
        end += nano_digits;
        while (end[-1] == '0')
            --end;
    }
    return end;
}

}  // namespace

char* write_number(char* begin, double value)
{
    assert(std::isfinite(value));
    if (char* const end = write_short_decimal(begin, value))
        return end;
    const double unsigned_zero = value == 0 ? 0 : value;
    const auto [end, error] =
        std::to_chars(begin, begin + longest_number_text, unsigned_zero);
    assert(error == std::errc{});
    return end;
}

void append_text(std::string& text, double value)
{
    std::array<char, longest_number_text> buffer;
    text.append(buffer.data(), write_number(buffer.data(), value));
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

std::optional<std::string_view> closest_word(std::string_view word,
                                             std::span<const std::string_view> words)
{
    if (word.size() > longest_word)
        return std::nullopt;
    std::optional<std::string_view> closest;
    std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
    for (const std::string_view candidate : words) {
        const std::size_t distance = edit_distance(word, candidate);
        const std::size_t own = word.size() - common_unit(word, candidate);
        if (distance > 0 && 2 * distance >= own)
            continue;
        if (distance < limit || (distance == limit && !closest)) {
            closest = candidate;
            limit = distance;
        }
    }
    return closest;
}

std::string one_of(std::span<const std::string_view> words, std::string_view word)
{
    assert(!words.empty());
    std::string text = quoted(words.front());
    for (std::size_t i = 1; i < words.size(); ++i)
        text += (i + 1 < words.size() ? ", " : " or ") + quoted(words[i]);
    if (const auto closest = closest_word(word, words))
        text += "; did you mean " + quoted(*closest) + "?";
    return text;
}

}  // namespace endmill
