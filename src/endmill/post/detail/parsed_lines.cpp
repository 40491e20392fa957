// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/parsed_lines.h"

#include <algorithm>
#include <optional>

#include "endmill/core/error.h"
#include "endmill/post/detail/text_lines.h"

namespace endmill {
namespace {

// Bytes and words of a usual line. Other lines only cost time.
constexpr std::size_t usual_bytes = 20;
constexpr std::size_t usual_words = 4;

bool is_special(std::string_view line)
{
    constexpr std::string_view special = "%Oo:/";
    return !line.empty() && special.find(line.front()) != std::string_view::npos;
}

}  // namespace

ParsedLines::ParsedLines(std::string_view text)
{
    const std::size_t lines = text.size() / usual_bytes + 1;
    words_.reserve(usual_words * lines);
    ends_.reserve(lines);
    is_parsed_.reserve(lines);
    const TextLines of_errors{"?", {}};  // errors are discarded
    bool is_refused = false;
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        const std::string_view line = without_indent(text.substr(0, length));
        text.remove_prefix(std::min(length + 1, text.size()));
        std::optional<GcodeBlock> block;
        try {
            if (!is_refused && !is_special(line))
                block = parse_block(line, of_errors);
        } catch (const FormatError&) {
            is_refused = true;
        }
        if (block)
            append(*block);
        ends_.push_back(static_cast<std::uint32_t>(words_.size()));
        is_parsed_.push_back(block ? 1 : 0);
    }
}

void ParsedLines::append(const GcodeBlock& block)
{
    for (char letter = 'A'; letter <= 'Z'; ++letter)
        if (block.has(letter) && letter != 'G' && letter != 'M')
            words_.push_back({block.value(letter), letter});
    for (const int code : block.g.all())
        words_.push_back({static_cast<double>(code), 'G'});
    for (const int code : block.m.all())
        words_.push_back({static_cast<double>(code), 'M'});
}

GcodeBlock ParsedLines::block(std::size_t line) const
{
    GcodeBlock block;
    for (std::size_t i = line == 0 ? 0 : ends_[line - 1]; i < ends_[line]; ++i) {
        const auto& [number, letter] = words_[i];
        if (letter == 'G')
            block.g.add(static_cast<int>(number));
        else if (letter == 'M')
            block.m.add(static_cast<int>(number));
        block.set(letter, number);
    }
    return block;
}

std::size_t length_of_lines(std::string_view text, std::size_t bytes)
{
    if (text.size() <= bytes)
        return text.size();
    const std::size_t end = text.find('\n', bytes == 0 ? 0 : bytes - 1);
    return end == std::string_view::npos ? text.size() : end + 1;
}

}  // namespace endmill
