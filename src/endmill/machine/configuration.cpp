// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/configuration.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

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

// Letters of axes in upper case are a frequent mistake, because B is one.
std::string unknown_letter(char letter)
{
    std::string start = shown(letter) + " is no axis";
    if (is_one_of("ACXYZ", letter))
        return start + " (axes are in lower case; only B, the bed, is in upper case)";
    return start;
}

// The first error of the letters between W/ and /T.
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

constexpr std::array<std::string_view, 6> rotary_pairs{"ab", "ba", "ca",
                                                       "cb", "ac", "bc"};

bool is_linear(char letter)
{
    return letter == 'x' || letter == 'y' || letter == 'z';
}

// A word without the bed and with neighbouring linear axes in alphabetical order. It is
// the same for all words with the same relative motion.
std::string relative_motion(std::string word)
{
    std::erase(word, 'B');
    auto from = word.begin();
    while (from != word.end()) {
        from = std::find_if(from, word.end(), is_linear);
        const auto to = std::find_if_not(from, word.end(), is_linear);
        std::sort(from, to);
        from = to;
    }
    return word;
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
    // C next to the tool turns the tool about its own axis, whatever the position of the
    // other axis.
    if (machine.rotary.back().letter == 'c')
        --machine.rank;
    else if (machine.rank == 2)
        machine.family =
            machine.rotary.front().letter == 'c' ? RotaryFamily::CA : RotaryFamily::AB;
    return machine;
}

MachineConfiguration configuration_of_family(RotaryFamily family)
{
    return configuration_from_word(family == RotaryFamily::CA ? "W/caBxyz/T"
                                                              : "W/abBxyz/T");
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

std::vector<std::string> rotary_words()
{
    std::vector<std::string> words;
    for (const std::string_view pair : rotary_pairs)
        for (const std::size_t place : {2U, 1U, 0U}) {
            words.emplace_back(pair);
            words.back().insert(place, 1, 'B');
        }
    return words;
}

std::string whole_word(const std::string& rotary_word)
{
    const std::vector<std::string> words = rotary_words();
    require(std::ranges::find(words, rotary_word) != words.end(),
            "whole_word: expected two rotary axes and the bed, such as caB");
    return "W/" + rotary_word + "xyz/T";
}

WordCounts count_words()
{
    WordCounts counts;
    std::set<std::string> motions;
    for (const std::string_view pair : {"ab", "ac", "bc"}) {
        std::string letters = "Bxyz" + std::string{pair};
        std::ranges::sort(letters);
        do {
            ++counts.words;
            motions.insert(relative_motion(letters));
        } while (std::next_permutation(letters.begin(), letters.end()));
    }
    counts.relative_motions = motions.size();
    std::set<RotaryFamily> families;
    for (const std::string& word : rotary_words()) {
        ++counts.rotary_words;
        const MachineConfiguration machine = configuration_from_word(whole_word(word));
        counts.valid += machine.is_valid() ? 1 : 0;
        if (machine.family)
            families.insert(*machine.family);
    }
    counts.families = families.size();
    return counts;
}

}  // namespace endmill
