// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace endmill {

/// A line of a program whose words can be changed while blanks, comments and the other
/// words stay as they are. The class does not check the grammar; `parse_block` does. If a
/// letter occurs several times, as G may, its first word is meant.
class GcodeLine {
public:
    /// \param line the line without its LF.
    explicit GcodeLine(std::string_view line = {}) { assign(line); }

    /// Replaces the line by another one, in the memory of this one.
    void assign(std::string_view line);

    /// Whether there is a word `letter` (a capital) outside comments.
    bool has(char letter) const { return find(letter) != pieces_.size(); }

    /// The number of the word `letter`, if the word exists and its number is a plain
    /// decimal.
    std::optional<double> number(char letter) const;

    /// Sets the number of the word `letter`. A new word is inserted after the last word.
    void set(char letter, std::string_view number);

    /// Removes the words of these letters, with the blanks before them.
    void remove(std::string_view letters);

    const std::string& text() const { return text_; }  ///< the line without LF

private:
    // A part of the text. The parts follow one another.
    struct Piece {
        char letter;      // capital; 0 for blanks, comments and other bytes
        bool is_blank;    // whether all bytes are blanks
        std::size_t end;  // in the text
    };

    std::size_t begin(std::size_t piece) const
    {
        return piece == 0 ? 0 : pieces_[piece - 1].end;
    }
    void add_other(std::size_t length);
    void insert(std::size_t piece, char letter, std::string_view text);
    void erase(std::size_t piece);
    void resize(std::size_t piece, std::size_t from, std::size_t to);
    std::size_t find(char letter) const;

    std::string text_;
    std::vector<Piece> pieces_;
};

}  // namespace endmill
