// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_line.h"

#include <algorithm>
#include <utility>

#include "endmill/post/detail/plain_number.h"
#include "endmill/post/detail/text_lines.h"

namespace endmill {
namespace {

// Five words and the blanks between them, and two more words.
constexpr std::size_t usual_pieces = 14;

char capital(char byte)
{
    return 'a' <= byte && byte <= 'z' ? static_cast<char>(byte - 'a' + 'A') : byte;
}

bool is_letter(char byte)
{
    return 'A' <= capital(byte) && capital(byte) <= 'Z';
}

// Number of bytes of the word at the beginning of `text`. The word may contain blanks but
// does not end with one.
std::size_t word_length(std::string_view text)
{
    constexpr std::string_view of_numbers = "0123456789.+-";
    std::size_t length = 1;
    for (std::size_t i = 1; i < text.size() && !is_letter(text[i]); ++i) {
        if (of_numbers.find(text[i]) != std::string_view::npos)
            length = i + 1;
        else if (!is_blank(text[i]))
            break;
    }
    return length;
}

// Number of bytes of a comment at the beginning of `text`, or 1 for another byte.
std::size_t other_length(std::string_view text)
{
    if (text.front() == ';')
        return text.size();
    if (text.front() == '(')
        return std::min(text.find(')'), text.size() - 1) + 1;
    return 1;
}

}  // namespace

GcodeLine::GcodeLine(std::string_view line)
{
    pieces_.reserve(usual_pieces);
    while (!line.empty()) {
        const bool is_word = is_letter(line.front());
        const std::size_t length = is_word ? word_length(line) : other_length(line);
        if (is_word)
            pieces_.push_back(
                {capital(line.front()), std::string{line.substr(0, length)}});
        else
            add_other(line.substr(0, length));
        line.remove_prefix(length);
    }
}

// Blanks are pieces of their own, so that a word can be removed together with them.
void GcodeLine::add_other(std::string_view text)
{
    const auto all_blank = [](std::string_view bytes) {
        return std::ranges::all_of(bytes, is_blank);
    };
    if (!pieces_.empty() && pieces_.back().letter == 0 &&
        all_blank(pieces_.back().text) == all_blank(text))
        pieces_.back().text += text;
    else
        pieces_.push_back({0, std::string{text}});
}

std::size_t GcodeLine::find(char letter) const
{
    const auto at = std::ranges::find(pieces_, letter, &Piece::letter);
    return static_cast<std::size_t>(at - pieces_.begin());
}

std::optional<double> GcodeLine::number(char letter) const
{
    const std::size_t at = find(letter);
    if (at == pieces_.size())
        return std::nullopt;
    std::string digits = pieces_[at].text.substr(1);
    std::erase_if(digits, is_blank);
    return plain_number(digits);
}

void GcodeLine::set(char letter, std::string_view number)
{
    const std::string word = letter + std::string{number};
    if (const std::size_t at = find(letter); at != pieces_.size()) {
        pieces_[at].text = word;
        return;
    }
    const auto is_word = [](const Piece& piece) { return piece.letter != 0; };
    const auto last = std::find_if(pieces_.rbegin(), pieces_.rend(), is_word).base();
    const auto at = pieces_.insert(last, {letter, word});
    if (at != pieces_.begin())
        pieces_.insert(at, {0, " "});
}

void GcodeLine::remove(std::string_view letters)
{
    std::vector<Piece> left;
    for (Piece& piece : pieces_) {
        if (piece.letter == 0 || letters.find(piece.letter) == std::string_view::npos)
            left.push_back(std::move(piece));
        else if (!left.empty() && std::ranges::all_of(left.back().text, is_blank))
            left.pop_back();
    }
    pieces_ = std::move(left);
}

std::string GcodeLine::text() const
{
    std::string text;
    for (const Piece& piece : pieces_)
        text += piece.text;
    return text;
}

}  // namespace endmill
