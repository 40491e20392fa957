// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace endmill {

/// A line of a program, of which words can be changed while blanks, comments and the other
/// words stay as they are. It knows no grammar: whether the line is one of the language is for
/// `parse_block` to say. Of words twice in a line, such as G, the first one is meant.
class GcodeLine {
public:
    /// \param line without its LF.
    explicit GcodeLine(std::string_view line);

    /// Whether there is a word `letter`, a capital, outside comments.
    bool has(char letter) const { return find(letter) != pieces_.size(); }

    /// The number of the word `letter`, if there is one in plain decimals.
    std::optional<double> number(char letter) const;

    /// Gives the word `letter` this number: in its place, or behind the last word.
    void set(char letter, std::string_view number);

    /// Takes these words away, with the blanks before them.
    void remove(std::string_view letters);

    std::string text() const;  ///< without LF

private:
    struct Piece {
        char letter;  // capital; 0 of what is no word
        std::string text;
    };

    void add_other(std::string_view text);
    std::size_t find(char letter) const;

    std::vector<Piece> pieces_;
};

}  // namespace endmill
