// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/option_text.h"

#include <cmath>
#include <cstdint>

#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr const char* expected_value =
    "a number, a text, true, false or an array of numbers";

// Options that take a whole number refuse the form 1e+07 of a large one.
std::string number_text(double number)
{
    constexpr double most_digits = 1e15;
    if (std::trunc(number) == number && std::abs(number) < most_digits)
        return std::to_string(static_cast<std::int64_t>(number));
    return to_text(number);
}

std::string joined_numbers(const JsonValue& value)
{
    std::string text;
    for (std::size_t i = 0; i < value.size(); ++i) {
        const JsonValue item = value.item(i);
        text += (i == 0 ? "" : ",") + number_text(item.number());
    }
    if (text.empty())
        throw value.complaint("an empty array", expected_value);
    return text;
}

}  // namespace

bool has_control_characters(const std::string& text)
{
    return printable(text) != text;
}

std::string option_text(const JsonValue& value)
{
    if (value.is_truth())
        return value.truth() ? "true" : "false";
    if (value.is_array())
        return joined_numbers(value);
    if (!value.is_text()) {
        if (!value.is_number())
            throw value.complaint(value.shown(), expected_value);
        return number_text(value.number());
    }
    std::string text = value.text();
    if (text.empty())
        throw value.complaint("an empty text", expected_value);
    if (has_control_characters(text))
        throw value.complaint(value.shown(), "a text without control characters");
    return text;
}

}  // namespace endmill
