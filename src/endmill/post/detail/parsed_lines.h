// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "endmill/post/detail/gcode_block.h"

namespace endmill {

/// The words of consecutive lines of a program, which are parsed before the interpreter
/// comes to these lines, so that several threads can parse. Errors are left to the
/// interpreter, which knows whether a line is executed and what its number is.
class ParsedLines {
public:
    /// Parses lines.
    /// \param text whole lines, divided as by TextLines. It is not kept.
    explicit ParsedLines(std::string_view text);

    /// Number of lines.
    std::size_t size() const { return ends_.size(); }

    /// Whether the words of a line are known. Those of a line that does not begin with a word
    /// or a comment (%, O, :, /) are not, nor are those of a line that `parse_block` refuses
    /// and of the lines after it.
    bool is_parsed(std::size_t line) const { return is_parsed_[line] != 0; }

    /// The words of a line, as `parse_block` returns them. \pre is_parsed(line)
    GcodeBlock block(std::size_t line) const;

private:
    // A word takes much less memory than a GcodeBlock, which has room for all letters.
    struct Word {
        double number;  // of G and M: the code as GcodeBlock stores it
        char letter;
    };

    void append(const GcodeBlock& block);

    std::vector<Word> words_;
    std::vector<std::uint32_t> ends_;  // of each line: end of its words
    std::vector<char> is_parsed_;      // of each line
};

/// Length in bytes of the first lines of `text` that have at least `bytes` bytes together;
/// all of it if it is shorter.
std::size_t length_of_lines(std::string_view text, std::size_t bytes);

}  // namespace endmill
