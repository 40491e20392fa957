// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/gcode_reader.h"

#include <algorithm>

#include "endmill/core/error.h"
#include "endmill/post/detail/gcode_line.h"
#include "endmill/post/detail/text_lines.h"

namespace endmill {
namespace {

// In inches in the file of parameters, in the unit of the program after G53: in both more
// than `least_machine_position_mm`, whatever offset is subtracted.
constexpr std::string_view far_away = "900000000";

// Whether the line has the word G53: without blanks, and not as a part of G53.1 or G530.
bool has_machine_coordinates(std::string_view line)
{
    std::string text;
    for (const char byte : line)
        if (!is_blank(byte))
            text += byte == 'g' ? 'G' : byte;
    constexpr std::string_view code = "G53";
    for (std::size_t at = text.find(code); at != std::string::npos;
         at = text.find(code, at + 1)) {
        const std::size_t after = at + code.size();
        if (after == text.size() ||
            std::string_view{".0123456789"}.find(text[after]) == std::string_view::npos)
            return true;
    }
    return false;
}

std::string with_far_target(std::string_view line, std::size_t number,
                            const std::string& file)
{
    if (line.find_first_of("#[oO") != std::string_view::npos)
        throw FormatError{
            "E_GCODE",
            {file, std::to_string(number), "a position of the machine in " + quoted(line),
             "G53 beside plain numbers"}};
    GcodeLine words{line};
    for (const char letter : {'X', 'Y', 'Z'})
        if (words.has(letter))
            words.set(letter, far_away);
    return words.text();
}

}  // namespace

std::string interpreter_parameters()
{
    // 5161 to 5163 are X, Y and Z of G28, 5181 to 5183 those of G30. The interpreter wants
    // the numbers of the coordinate systems and their offsets too; missing ones are 0.
    std::string text;
    for (const char* const number : {"5161", "5162", "5163"})
        text += std::string{number} + ' ' + std::string{far_away} + '\n';
    for (const char* const number : {"5181", "5182", "5183"})
        text += std::string{number} + ' ' + std::string{far_away} + '\n';
    return text + "5220 1\n";
}

std::string with_far_machine_positions(std::string_view program, const std::string& file)
{
    std::string text;
    text.reserve(program.size());
    for (std::size_t number = 1; !program.empty(); ++number) {
        const std::size_t end = std::min(program.find('\n'), program.size());
        const std::string_view line = program.substr(0, end);
        if (has_machine_coordinates(line))
            text += with_far_target(line, number, file);
        else
            text += line;
        if (end < program.size())
            text += '\n';
        program.remove_prefix(std::min(end + 1, program.size()));
    }
    return text;
}

}  // namespace endmill
