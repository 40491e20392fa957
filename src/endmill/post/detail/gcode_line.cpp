// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_line.h"

#include <algorithm>
#include <cstddef>

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

bool is_of_number(char byte)
{
    return ('0' <= byte && byte <= '9') || byte == '.' || byte == '+' || byte == '-';
}

// Number of bytes of the word at the beginning of `text`. The word may contain blanks but
// does not end with one.
std::size_t word_length(std::string_view text)
{
    std::size_t length = 1;
    for (std::size_t i = 1; i < text.size() && !is_letter(text[i]); ++i) {
        if (is_of_number(text[i]))
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

void GcodeLine::assign(std::string_view line)
{
    text_ = line;
    pieces_.clear();
    pieces_.reserve(usual_pieces);
    for (std::size_t at = 0; at < line.size();) {
        const std::string_view rest = line.substr(at);
        const bool is_word = is_letter(rest.front());
        const std::size_t length = is_word ? word_length(rest) : other_length(rest);
        if (is_word)
            pieces_.push_back({capital(rest.front()), false, at + length});
        else
            add_other(length);
        at += length;
    }
}

// Blanks are pieces of their own, so that a word can be removed together with them.
void GcodeLine::add_other(std::size_t length)
{
    const std::size_t at = begin(pieces_.size());
    const bool all_blank =
        std::ranges::all_of(std::string_view{text_}.substr(at, length), is_blank);
    if (!pieces_.empty() && pieces_.back().letter == 0 &&
        pieces_.back().is_blank == all_blank)
        pieces_.back().end += length;
    else
        pieces_.push_back({0, all_blank, at + length});
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
    std::string digits = text_.substr(begin(at) + 1, pieces_[at].end - begin(at) - 1);
    std::erase_if(digits, is_blank);
    return plain_number(digits);
}

// Adapts the ends of the pieces from `piece` on, whose text changes its length.
void GcodeLine::resize(std::size_t piece, std::size_t from, std::size_t to)
{
    for (; piece < pieces_.size(); ++piece)
        pieces_[piece].end = pieces_[piece].end + to - from;
}

// Inserts a piece before another one.
void GcodeLine::insert(std::size_t piece, char letter, std::string_view text)
{
    const std::size_t at = begin(piece);
    text_.insert(at, text);
    pieces_.insert(pieces_.begin() + static_cast<std::ptrdiff_t>(piece),
                   {letter, letter == 0, at});
    resize(piece, 0, text.size());
}

void GcodeLine::erase(std::size_t piece)
{
    const std::size_t length = pieces_[piece].end - begin(piece);
    text_.erase(begin(piece), length);
    resize(piece, length, 0);
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(piece));
}

void GcodeLine::set(char letter, std::string_view number)
{
    const std::string word = letter + std::string{number};
    if (const std::size_t at = find(letter); at != pieces_.size()) {
        const std::size_t length = pieces_[at].end - begin(at);
        text_.replace(begin(at), length, word);
        resize(at, length, word.size());
        return;
    }
    const auto is_word = [](const Piece& piece) { return piece.letter != 0; };
    const auto last = std::find_if(pieces_.rbegin(), pieces_.rend(), is_word).base();
    const auto at = static_cast<std::size_t>(last - pieces_.begin());
    insert(at, letter, word);
    if (at != 0)
        insert(at, 0, " ");
}

void GcodeLine::remove(std::string_view letters)
{
    for (std::size_t piece = 0; piece < pieces_.size();) {
        const char letter = pieces_[piece].letter;
        if (letter == 0 || letters.find(letter) == std::string_view::npos) {
            ++piece;
            continue;
        }
        erase(piece);
        if (piece > 0 && pieces_[piece - 1].is_blank)
            erase(--piece);
    }
}

}  // namespace endmill
