// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/configuration.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr std::array<std::string_view, 6> rotary_pairs{"ab", "ba", "ca",
                                                       "cb", "ac", "bc"};

bool is_linear(char letter)
{
    return letter == 'x' || letter == 'y' || letter == 'z';
}

// The word without the bed, neighbouring linear axes in alphabetic order: the same for all
// words of one relative motion.
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
