// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/configuration.h"

#include <algorithm>
#include <cstddef>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr std::string_view opening = "W/";
constexpr std::string_view closing = "/T";
constexpr std::string_view needed_letters = "xyzB";
constexpr std::string_view rotary_letters = "abc";
constexpr std::size_t most_rotary = 2;
constexpr char first_printable = ' ';
constexpr char last_printable = '~';

bool is_one_of(std::string_view letters, char letter)
{
    return letters.find(letter) != std::string_view::npos;
}

std::string shown(char letter)
{
    const bool is_printable = letter >= first_printable && letter <= last_printable;
    return is_printable ? "\"" + std::string{letter} + "\"" : "an unprintable character";
}

std::string unknown_letter(char letter)
{
    std::string start = shown(letter) + " is no axis";
    if (is_one_of("ACXYZ", letter))
        return start + " (axes are in lower case, only the bed B is not)";
    return start;
}

// What is wrong with the letters between W/ and /T.
std::optional<std::string> letters_fault(std::string_view letters)
{
    std::size_t rotary = 0;
    for (const char letter : letters) {
        const bool is_rotary = is_one_of(rotary_letters, letter);
        if (!is_rotary && !is_one_of(needed_letters, letter))
            return unknown_letter(letter);
        if (std::ranges::count(letters, letter) > 1)
            return (is_rotary ? "two equal rotary axes " : "two letters ") +
                   std::string{letter};
        rotary += is_rotary ? 1 : 0;
    }
    if (!is_one_of(letters, 'B'))
        return "B, the bed, is missing";
    for (const char letter : needed_letters)
        if (!is_one_of(letters, letter))
            return std::string{letter} + " is missing";
    if (rotary > most_rotary)
        return "three rotary axes";
    return std::nullopt;
}

std::string_view letters_of(std::string_view word)
{
    return word.substr(opening.size(), word.size() - opening.size() - closing.size());
}

}  // namespace

std::optional<std::string> configuration_fault(std::string_view word)
{
    if (!word.starts_with(opening))
        return "W/ is missing at its start";
    if (!word.ends_with(closing) || word.size() < opening.size() + closing.size())
        return "/T is missing at its end";
    return letters_fault(letters_of(word));
}

MachineConfiguration configuration_from_word(std::string_view word)
{
    if (const auto fault = configuration_fault(word))
        throw DomainError{"configuration_from_word: " + *fault};
    MachineConfiguration machine{.word = std::string{word}};
    MachineSide side = MachineSide::Table;
    for (const char letter : letters_of(word)) {
        if (letter == 'B')
            side = MachineSide::Head;
        if (is_one_of(rotary_letters, letter))
            machine.rotary.push_back({letter, side});
    }
    machine.rank = static_cast<int>(machine.rotary.size());
    if (machine.rank == 0)
        return machine;
    // C next to the tool turns it about its own axis, wherever the other axis has put that.
    if (machine.rotary.back().letter == 'c')
        --machine.rank;
    else if (machine.rank == 2)
        machine.family =
            machine.rotary.front().letter == 'c' ? RotaryFamily::CA : RotaryFamily::AB;
    return machine;
}

std::string why_not_valid(const MachineConfiguration& configuration)
{
    if (configuration.is_valid())
        return {};
    if (configuration.rotary.size() == 1)
        return "c, the only rotary axis, turns the tool about itself: every direction is "
               "that of a 3-axis machine";
    return "c, the rotary axis next to the tool, turns it about itself: only " +
           std::string{configuration.rotary.front().letter} +
           " tilts it, as on a 4-axis machine";
}

}  // namespace endmill
