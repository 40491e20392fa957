// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/files/read_file.h"

namespace endmill {

/// Largest accepted length, feed or speed in mm, mm/min or rpm. No machine reaches it,
/// and the file readers use the same limit.
inline constexpr double most_of_machine = 1e9;

/// The numbers that an option accepts.
struct NumberDomain {
    double above = -std::numeric_limits<double>::infinity();  ///< open lower end
    std::string words = "a number";                           ///< for messages
    double below = std::numeric_limits<double>::infinity();   ///< open upper end

    static NumberDomain any() { return {}; }  ///< every finite number
    static NumberDomain positive() { return {0, "a number above 0"}; }  ///< above 0
    static NumberDomain from_zero()                                     ///< 0 and above
    {
        return {-std::numeric_limits<double>::denorm_min(), "a number from 0"};
    }
    /// Above 0, at most `high`.
    static NumberDomain above_zero_to(double high);
    /// Above 0, at most `most_of_machine`.
    static NumberDomain of_machine() { return above_zero_to(most_of_machine); }
    /// Between `low` and `high`, both excluded.
    static NumberDomain between(double low, double high);
    /// From `low` to `high`, both included.
    static NumberDomain from_to(double low, double high);
};

/// Parses `text` as a finite number in `domain`.
/// \throws CLI::ValidationError naming `option`.
double number_argument(const std::string& option, const std::string& text,
                       const NumberDomain& domain);

/// Refuses an option's coordinate beyond the limit for coordinates in files.
/// \throws DomainError naming `option` if `mm` exceeds the limit.
void require_within_extent(const std::string& option, const std::optional<double>& mm,
                           const ReadLimits& limits);

/// Refuses a cutter that is wider than the limit for coordinates in files.
/// \throws DomainError naming `option` if the diameter exceeds the limit.
void require_within_extent(const std::string& option, const Cutter& cutter,
                           const ReadLimits& limits);

/// Parses three comma-separated numbers. \throws CLI::ValidationError
Vec3 vector_argument(const std::string& option, const std::string& text);

/// An option that takes one finite number.
struct NumberOption {
    std::string name;
    std::string unit;  ///< as the help text shows it
    std::string help;
    NumberDomain domain = NumberDomain::positive();
};

/// Adds `option`. The value of `target` is the default.
CLI::Option* add_number(CLI::App& command, const NumberOption& option, double& target);

/// The same without a default.
CLI::Option* add_number(CLI::App& command, const NumberOption& option,
                        std::optional<double>& target);

/// Parses `text` as a whole number from `low` to `high`.
/// \throws CLI::ValidationError naming `option`.
int whole_number_argument(const std::string& option, const std::string& text, int low,
                          int high);

/// An option that takes a whole number from `low` to `high`.
struct WholeNumberOption {
    std::string name;
    std::string help;
    int low;
    int high;
};

/// Adds `option`, whose number goes to `use`.
CLI::Option* add_whole_number(CLI::App& command, const WholeNumberOption& option,
                              std::function<void(int)> use);

/// A word that an option accepts, and its value.
template <typename Value>
struct Choice {
    std::string_view word;
    Value value;
};

/// The words yes and no, with yes as the default.
inline constexpr std::array yes_first{Choice<bool>{"yes", true},
                                      Choice<bool>{"no", false}};

/// The index of `word` in `words`. \throws CLI::ValidationError with a suggestion.
std::size_t choice_argument(const std::string& option, const std::string& word,
                            std::span<const std::string_view> words);

/// Adds an option that takes one of a few words. `choices` must outlive `command`.
/// \param target a Value, or an optional Value that stays empty unless the option is
/// given.
template <typename Value, typename Target>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Target& target,
                        std::span<const Choice<Value>> choices, const std::string& help)
{
    std::vector<std::string_view> words;
    std::string shown;
    for (const Choice<Value>& choice : choices) {
        words.push_back(choice.word);
        shown += (shown.empty() ? "" : "|") + std::string{choice.word};
    }
    const auto take = [name, words, choices, &target](const std::string& word) {
        target = choices[choice_argument(name, word, words)].value;
    };
    return command.add_option_function<std::string>(name, take, help)->type_name(shown);
}

/// The word for `value`.
template <typename Value>
std::string_view word_for(Value value, std::span<const Choice<Value>> choices)
{
    for (const Choice<Value>& choice : choices)
        if (choice.value == value)
            return choice.word;
    return {};
}

/// The diameter in mm of a ball given as "ball:DIAMETER".
/// \throws CLI::ValidationError for any other text; the message names other cutters.
double ball_diameter_argument(const std::string& option, const std::string& text);

/// Parses a cutter of any kind. \throws CLI::ValidationError
Cutter cutter_argument(const std::string& option, const std::string& text);

}  // namespace endmill
