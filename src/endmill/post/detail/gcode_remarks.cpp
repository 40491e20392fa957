// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_remarks.h"

#include <algorithm>
#include <array>

#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr int dwell = 40;
constexpr int tool_length = 430;
constexpr int blending = 640;
constexpr int to_initial_level = 980;
constexpr int to_r = 990;

// M codes that act on the path: the end of the program, the spindle and the tool.
constexpr std::array followed_m_codes{2, 3, 4, 5, 6, 30};

// Codes of almost every program: stops, coolant, overrides in force, a dwell, the tool
// length, rounding within P. Alone they need no remark.
bool is_usual(char letter, int code)
{
    constexpr std::array g_codes{dwell, tool_length, blending};
    constexpr std::array m_codes{0, 1, 7, 8, 9, 48};
    return letter == 'G' ? std::ranges::find(g_codes, code) != g_codes.end()
                         : std::ranges::find(m_codes, code) != m_codes.end();
}

}  // namespace

void GcodeRemarks::count(UsesOfCodes& uses, Code code, const TextLines& lines)
{
    Uses& of_code = uses[code];
    if (of_code.count++ == 0)
        of_code.first_line = lines.number();
}

// "G69 (1, line 3), G97 (2, from line 4)".
std::string GcodeRemarks::list(const UsesOfCodes& uses)
{
    std::string text;
    for (const auto& [code, of_code] : uses)
        text += (text.empty() ? "" : ", ") +
                (code.first == 'G' ? g_name(code.second)
                                   : code.first + std::to_string(code.second)) +
                " (" + std::to_string(of_code.count) +
                (of_code.count == 1 ? ", line " : ", from line ") +
                std::to_string(of_code.first_line) + ')';
    return text;
}

void GcodeRemarks::note_modes(const GcodeBlock& block, const GcodeModes& before,
                              const GcodeModes& after, const TextLines& lines,
                              ProgramBuilder& builder)
{
    for (const int code : block.g.all())
        if (is_idle_g_code(code) || is_usual('G', code))
            count(skipped_, {'G', code}, lines);
    if (block.g.contains(blending) && !block.has('P'))
        blends_without_limit_ = true;
    if (after.unit && !before.unit && has_unstated_lengths_)
        first_unit_line_ = lines.number();
    if (after.has_surface_speed && !before.has_surface_speed)
        builder.remark(
            "G96: S is a cutting speed, so the path has no spindle speed until G97");
}

void GcodeRemarks::note_m_codes(const GcodeBlock& block, const TextLines& lines)
{
    for (const int code : block.m.all())
        if (std::ranges::find(followed_m_codes, code) == followed_m_codes.end())
            count(skipped_, {'M', code}, lines);
}

void GcodeRemarks::note_unstated_lengths(const GcodeBlock& block)
{
    has_unstated_lengths_ = has_unstated_lengths_ || block.has_any("XYZIJKRF");
}

void GcodeRemarks::note_reference(const GcodeBlock& block, const TextLines& lines)
{
    for (const int code : block.g.all())
        if (code == 280 || code == 300 || code == 530)
            count(references_, {'G', code}, lines);
}

void GcodeRemarks::note_cycle(const GcodeModes& modes, ProgramBuilder& builder)
{
    has_cycles_ = true;
    if (modes.retract == RetractLevel::Unstated)
        builder.remark(
            "neither G98 nor G99 before a canned cycle: it retracts to R, as under G99; "
            "some controls begin with G98");
    if (modes.cycle == 88)
        builder.remark("G88: the retract by hand is taken as a rapid");
}

void GcodeRemarks::finish(const GcodeModes& modes, bool has_ended,
                          ProgramBuilder& builder) const
{
    if (!has_ended)
        builder.remark("no M2, M30 or closing %: the program may be cut short");
    if (!modes.unit)
        builder.remark("neither G20 nor G21: lengths are taken as mm");
    else if (first_unit_line_ != 0)
        builder.remark("no G20 or G21 before line " + std::to_string(first_unit_line_) +
                       ": lengths before it are taken as mm");
    if (matters_what_was_left_out(builder))
        builder.remark(
            "the path begins in line " + std::to_string(start_line_) +
            ", where the position of every axis is known; left out before it: " +
            counted(moves_left_out_, "move"));
    if (!references_.empty())
        builder.remark("moves to positions of the machine: " + list(references_) +
                       "; each is taken as a rapid straight up, to 5 mm above all points "
                       "before it");
    if (const std::string skipped = skipped_codes(); !skipped.empty())
        builder.remark("skipped codes that move nothing: " + skipped);
}

// A safe start states one axis after the other by rapids, from above all cuts. Feeds that
// are left out may have cut, and rapids at the height of a cut may have hit the stock.
bool GcodeRemarks::matters_what_was_left_out(const ProgramBuilder& builder) const
{
    return moves_left_out_ > 0 &&
           (has_left_out_feed_ || start_height_mm_ <= builder.highest_cut_mm());
}

// All skipped codes; none if all are usual. G98 and G99 are not skipped beside a cycle.
std::string GcodeRemarks::skipped_codes() const
{
    UsesOfCodes skipped = skipped_;
    if (has_cycles_) {
        skipped.erase({'G', to_initial_level});
        skipped.erase({'G', to_r});
    }
    const bool is_all_usual = std::ranges::all_of(skipped, [](const auto& uses) {
        return is_usual(uses.first.first, uses.first.second);
    });
    return is_all_usual && !blends_without_limit_ ? "" : list(skipped);
}

}  // namespace endmill
