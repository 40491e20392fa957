// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/rotary_words.h"

#include <cmath>

#include "endmill/core/angle.h"

namespace endmill {
namespace {

constexpr double full_turn_deg = 360;
// Degrees, beyond every axis that turns without end, as in machine files.
constexpr double most_turn_deg = 1e6;
constexpr std::array rotary_letters{'A', 'B', 'C'};

char lower(char letter)
{
    return static_cast<char>(letter - 'A' + 'a');
}

}  // namespace

double unwrapped_word(RotaryWrap wrap, double word, bool is_negative, double now)
{
    if (wrap == RotaryWrap::Unwrapped)
        return word;
    if (wrap == RotaryWrap::Shortest) {
        const double turn = std::remainder(word - now, full_turn_deg);
        return now + (turn == -full_turn_deg / 2 ? full_turn_deg / 2 : turn);
    }
    const double within = std::abs(word);
    const double at = within + full_turn_deg * std::floor(now / full_turn_deg);
    if (!is_negative)
        return at < now ? at + full_turn_deg : at;
    return at > now ? at - full_turn_deg : at;
}

RotaryWords::RotaryWords(const std::optional<RotaryReading>& reading) : reading_{reading}
{
}

bool RotaryWords::moves(const GcodeBlock& block) const
{
    for (const char letter : rotary_letters)
        if (block.has(letter) && has_axis(letter))
            return true;
    return false;
}

void RotaryWords::check(const GcodeBlock& block, const TextLines& lines) const
{
    for (const char letter : rotary_letters) {
        if (!block.has(letter))
            continue;
        const double value = block.value(letter);
        const std::string word = letter + brief(value);
        if (!reading_ && value != 0)
            throw lines.complaint(word, std::string{letter} +
                                            "0, or the machine of the program (--machine "
                                            "and --frame)");
        if (!reading_)
            continue;
        const auto axis = axis_of(letter);
        if (!axis && value != 0)
            throw lines.complaint(
                word + " on the machine " + reading_->setup.machine.configuration.word,
                "words of " + letters());
        if (!axis)
            continue;
        const bool is_signed = reading_->wraps[*axis] == RotaryWrap::Signed;
        if (is_signed && !(std::abs(value) < full_turn_deg))
            throw lines.complaint(word + " on a wrapped rotary axis",
                                  "less than 360 degrees with a sign");
        if (!(std::abs(value) <= most_turn_deg))
            throw lines.range_complaint(word, "at most a million degrees");
    }
}

void RotaryWords::apply(const GcodeBlock& block, DistanceMode mode)
{
    for (const char letter : rotary_letters) {
        const auto axis = block.has(letter) ? axis_of(letter) : std::nullopt;
        if (!axis)
            continue;
        const double value = block.value(letter);
        is_stated_[*axis] = is_stated_[*axis] || mode == DistanceMode::Absolute;
        double& degrees = degrees_[*axis];
        degrees = mode == DistanceMode::Incremental
                      ? degrees + value
                      : unwrapped_word(reading_->wraps[*axis], value, std::signbit(value),
                                       degrees);
    }
}

void RotaryWords::set(char letter, double degrees)
{
    degrees_[axis_of(letter).value()] = degrees;
}

RotaryPositions RotaryWords::positions() const
{
    RotaryPositions positions{0, 0};
    if (!reading_)
        return positions;
    for (std::size_t k = 0; k < positions.size(); ++k)
        positions[k] =
            reading_->setup.machine.word_signs[k] * Angle::degrees(degrees_[k]).radians();
    return positions;
}

std::string RotaryWords::letters() const
{
    std::string letters;
    for (const char letter : rotary_letters)
        if (has_axis(letter))
            letters += (letters.empty() ? "" : " and ") + std::string{letter};
    return letters.empty() ? "no rotary axes" : letters;
}

std::string RotaryWords::unstated_letters() const
{
    std::string letters;
    for (const char letter : rotary_letters)
        if (const auto axis = axis_of(letter); axis && !is_stated_[*axis])
            letters += (letters.empty() ? "" : " and ") + std::string{letter};
    return letters;
}

std::optional<std::size_t> RotaryWords::axis_of(char letter) const
{
    if (!reading_)
        return std::nullopt;
    const auto& rotary = reading_->setup.machine.configuration.rotary;
    for (std::size_t k = 0; k < rotary.size(); ++k)
        if (rotary[k].letter == lower(letter))
            return k;
    return std::nullopt;
}

}  // namespace endmill
