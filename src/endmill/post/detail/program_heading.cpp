// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/program_heading.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/error.h"
#include "endmill/post/detail/comment_text.h"
#include "endmill/post/detail/plain_number.h"

namespace endmill {
namespace {

// Largest relative change of the tolerance of corners by rounding it for P.
constexpr double negligible_share = 0.01;
constexpr int dwell_decimals = 3;  // of seconds
constexpr double milliseconds_per_s = 1000;

// The comment at the start, in the form of the control and cut to the line that begins
// with `heading`; empty if the control has none.
std::string comment(const GcodeOptions& options, const std::string& heading,
                    std::string_view coordinates)
{
    const Control& control = options.control;
    if (!options.comments || control.comments == CommentStyle::None)
        return "";
    std::string text = opening_comment(options.name, options.cutter, coordinates);
    if (control.capital_comments)
        std::ranges::transform(text, text.begin(), [](char letter) {
            return 'a' <= letter && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A')
                                                  : letter;
        });
    const bool in_parentheses = control.comments == CommentStyle::Parentheses;
    constexpr std::size_t frame = 3;  // a blank and ( )
    if (control.longest_line)
        text.resize(
            std::min(text.size(), *control.longest_line - heading.size() - frame));
    return in_parentheses ? '(' + text + ')' : ';' + text;
}

// "O0001", or empty.
std::string program_number(const Control& control)
{
    constexpr std::size_t digits = 4;
    if (!control.program_number)
        return "";
    const std::string number = std::to_string(*control.program_number);
    return 'O' + std::string(digits - std::min(digits, number.size()), '0') + number;
}

}  // namespace

int decimals_of(const GcodeOptions& options)
{
    const Control& control = options.control;
    return options.decimals.value_or(
        options.unit == ProgramUnit::Inch ? control.decimals_inch : control.decimals_mm);
}

BlockFormat block_format(const GcodeOptions& options)
{
    const Control& control = options.control;
    return {decimals_of(options),          options.line_numbers,
            millimetres_per(options.unit), control.speed_decimals,
            control.always_point,          control.crlf ? "\r\n" : "\n",
            control.largest_line_number,   control.longest_line};
}

std::string dwell(const GcodeOptions& options)
{
    std::string text = "G4 P";
    if (options.control.dwell == DwellUnit::Milliseconds)
        append_trimmed(text, options.dwell_s * milliseconds_per_s, 0);
    else
        append_trimmed(text, options.dwell_s, dwell_decimals);
    return text;
}

std::optional<std::string> coolant_word(const GcodeOptions& options)
{
    if (options.coolant == Coolant::Off)
        return std::nullopt;
    const bool is_flood = options.coolant == Coolant::Flood;
    const auto& word = is_flood ? options.control.flood : options.control.mist;
    if (!word)
        throw DomainError{"gcode: the control " + options.control.name + " has no " +
                          (is_flood ? "flood" : "mist") +
                          " coolant; expected another coolant, or a control with it"};
    return word;
}

std::string blending_block(const GcodeOptions& options, double blend_mm)
{
    const double blend = blend_mm / millimetres_per(options.unit);
    if (blend == 0)
        return "G61";  // a rounded corner would leave the path to the forbidden side
    std::string text;
    // A small tolerance needs more decimals than coordinates.
    for (int decimals = decimals_of(options); decimals <= most_decimals; ++decimals) {
        text = "G64 P";
        const double rounded = append_trimmed(text, blend, decimals);
        if (std::abs(rounded - blend) <= negligible_share * blend)
            return text;
    }
    return "G61";  // too small for nine decimals: the control must not round corners
}

void write_start(BlockWriter& blocks, const GcodeOptions& options,
                 const std::string& path_control, std::string_view coordinates)
{
    const Control& control = options.control;
    if (control.percent)
        blocks.add_line("%");
    std::string heading = program_number(control);
    const std::string text = comment(options, heading, coordinates);
    if (!heading.empty() && !text.empty())
        heading += ' ';
    if (heading += text; !heading.empty())
        blocks.add_line(heading);
    std::string first = options.unit == ProgramUnit::Inch ? "G20" : "G21";
    if (!control.start.empty())
        first += ' ' + control.start.front();
    blocks.add_block(first);
    for (std::size_t k = 1; k < control.start.size(); ++k)
        blocks.add_block(control.start[k]);
    if (!path_control.empty())
        blocks.add_block(path_control);
}

void write_end(BlockWriter& blocks, const GcodeOptions& options)
{
    if (coolant_word(options))
        blocks.add_block(options.control.coolant_off);
    for (const std::string& block : options.control.end)
        blocks.add_block(block);
    if (options.control.percent)
        blocks.add_line("%");
}

}  // namespace endmill
