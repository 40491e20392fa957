// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/named_texts.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr std::size_t shown_characters = 40;

[[noreturn]] void refuse(const std::string& option, const std::string& found,
                         const std::string& expected)
{
    throw CLI::ValidationError(option, "found \"" + printable(found, shown_characters) +
                                           "\"; expected " + expected);
}

// "help (default VALUE)"; in parentheses that end the help the default comes first.
std::string with_default(const std::string& help, const std::string& value)
{
    const std::size_t open = help.rfind('(');
    if (!help.ends_with(')') || open == std::string::npos)
        return help + " (default " + value + ")";
    return help.substr(0, open + 1) + "default " + value + "; " + help.substr(open + 1);
}

}  // namespace

NumberDomain NumberDomain::above_zero_to(double high)
{
    return {0, "a number above 0, at most " + to_text(high),
            std::nextafter(high, std::numeric_limits<double>::infinity())};
}

NumberDomain NumberDomain::between(double low, double high)
{
    return {low, "a number between " + to_text(low) + " and " + to_text(high), high};
}

NumberDomain NumberDomain::from_to(double low, double high)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {std::nextafter(low, -infinity),
            "a number from " + to_text(low) + " to " + to_text(high),
            std::nextafter(high, infinity)};
}

double number_argument(const std::string& option, const std::string& text,
                       const NumberDomain& domain)
{
    const auto number = number_from_text(text);
    if (!number || !(*number > domain.above && *number < domain.below))
        refuse(option, text, domain.words);
    return *number;
}

void require_within_extent(const std::string& option, const std::optional<double>& mm,
                           const ReadLimits& limits)
{
    if (mm && !(std::abs(*mm) <= limits.max_extent_mm))
        throw DomainError{option + ": found " + to_text(*mm) + "; expected at most " +
                          to_text(limits.max_extent_mm) + " mm (--max-extent)"};
}

void require_within_extent(const std::string& option, const Cutter& cutter,
                           const ReadLimits& limits)
{
    const double diameter = 2 * cutter.radius();
    if (!(diameter <= limits.max_extent_mm))
        throw DomainError{option + ": found a diameter of " + to_text(diameter) +
                          " mm; expected at most " + to_text(limits.max_extent_mm) +
                          " mm (--max-extent)"};
}

Vec3 vector_argument(const std::string& option, const std::string& text)
{
    const std::vector<std::string> parts = parts_of(text, ',');
    Vec3 vector;
    if (parts.size() != 3)
        refuse(option, text, "three numbers X,Y,Z");
    for (int c = 0; c < 3; ++c) {
        const auto number = number_from_text(parts[static_cast<std::size_t>(c)]);
        if (!number)
            refuse(option, text, "three numbers X,Y,Z");
        vector[c] = *number;
    }
    return vector;
}

CLI::Option* add_number(CLI::App& command, const NumberOption& option, double& target)
{
    const auto take = [option, &target](const std::string& text) {
        target = number_argument(option.name, text, option.domain);
    };
    const std::string help = with_default(option.help, to_text(target));
    return command.add_option_function<std::string>(option.name, take, help)
        ->type_name(option.unit);
}

CLI::Option* add_number(CLI::App& command, const NumberOption& option,
                        std::optional<double>& target)
{
    const auto take = [option, &target](const std::string& text) {
        target = number_argument(option.name, text, option.domain);
    };
    return command.add_option_function<std::string>(option.name, take, option.help)
        ->type_name(option.unit);
}

int whole_number_argument(const std::string& option, const std::string& text, int low,
                          int high)
{
    const auto number = number_from_text(text);
    const bool is_whole = number && *number >= low && *number <= high &&
                          *number == static_cast<int>(*number);
    if (!is_whole)
        refuse(
            option, text,
            "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return static_cast<int>(*number);
}

CLI::Option* add_whole_number(CLI::App& command, const WholeNumberOption& option,
                              std::function<void(int)> use)
{
    const auto take = [option, use = std::move(use)](const std::string& text) {
        use(whole_number_argument(option.name, text, option.low, option.high));
    };
    return command.add_option_function<std::string>(option.name, take, option.help)
        ->type_name("N");
}

std::size_t choice_argument(const std::string& option, const std::string& word,
                            std::span<const std::string_view> words)
{
    const auto found = std::ranges::find(words, word);
    if (found == words.end())
        refuse(option, word, one_of(words, word));
    return static_cast<std::size_t>(found - words.begin());
}

double ball_diameter_argument(const std::string& option, const std::string& text)
{
    const std::vector<std::string> parts = parts_of(text, ':');
    if (parts[0] == "flat" || parts[0] == "bull")
        refuse(option, text, "ball:DIAMETER, the only cutter of this command");
    if (parts[0] != "ball" || parts.size() != 2)
        refuse(option, text, "ball:DIAMETER, such as ball:10");
    const auto diameter = number_from_text(parts[1]);
    if (!diameter)
        refuse(option, text,
               cutter_from_word(text.substr(0, text.find("mm")))
                   ? "a number in mm without a unit, as in " +
                         text.substr(0, text.find("mm"))
                   : "a diameter above 0 mm");
    if (!(*diameter > 0))
        refuse(option, text, "a diameter above 0 mm");
    return *diameter;
}

Cutter cutter_argument(const std::string& option, const std::string& text)
{
    const std::optional<Cutter> cutter = cutter_from_word(text);
    if (!cutter)
        refuse(option, text, expected_cutter(text));
    return *cutter;
}

}  // namespace endmill
