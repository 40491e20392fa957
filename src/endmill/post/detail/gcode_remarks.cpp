// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_remarks.h"

#include "endmill/core/text.h"

namespace endmill {

void GcodeRemarks::count(UsesOfCodes& uses, int code, const TextLines& lines)
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
        text += (text.empty() ? "" : ", ") + g_name(code) + " (" +
                std::to_string(of_code.count) +
                (of_code.count == 1 ? ", line " : ", from line ") +
                std::to_string(of_code.first_line) + ')';
    return text;
}

void GcodeRemarks::note_modes(const GcodeBlock& block, const GcodeModes& before,
                              const GcodeModes& after, const TextLines& lines,
                              ProgramBuilder& builder)
{
    for (const int code : block.g.all())
        if (is_idle_g_code(code))
            count(idle_codes_, code, lines);
    if (after.unit && !before.unit && has_unstated_lengths_)
        first_unit_line_ = lines.number();
    has_inches_ = has_inches_ || after.unit == ProgramUnit::Inch;
    if (after.used_tool_length && !before.used_tool_length)
        builder.remark(
            (block.has('H') ? "G43 H" + brief(block.value('H')) : std::string{"G43"}) +
            ": the tool length is assumed to be in the control's tool table already");
    if (after.has_surface_speed && !before.has_surface_speed)
        builder.remark(
            "G96: S is a cutting speed, so the path has no spindle speed until G97");
}

void GcodeRemarks::note_unstated_lengths(const GcodeBlock& block)
{
    has_unstated_lengths_ = has_unstated_lengths_ || block.has_any("XYZIJKRF");
}

void GcodeRemarks::note_reference(const GcodeBlock& block, const TextLines& lines)
{
    for (const int code : block.g.all())
        if (code == 280 || code == 300 || code == 530)
            count(references_, code, lines);
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
    if (has_inches_)
        builder.remark("inches (G20) converted to mm");
    if (!modes.unit)
        builder.remark("neither G20 nor G21: lengths are taken as mm");
    else if (first_unit_line_ != 0)
        builder.remark("no G20 or G21 before line " + std::to_string(first_unit_line_) +
                       ": lengths before it are taken as mm");
    if (moves_left_out_ > 0)
        builder.remark(
            "the path begins in line " + std::to_string(start_line_) +
            ", where the position of every axis is known; left out before it: " +
            counted(moves_left_out_, "move"));
    if (modes.used_blending)
        builder.remark("G64: a control may round corners, which the path does not show");
    if (!references_.empty())
        builder.remark("moves to positions of the machine: " + list(references_) +
                       "; each is taken as a rapid straight up, to 5 mm above all points "
                       "before it");
    UsesOfCodes skipped = idle_codes_;
    if (has_cycles_) {
        constexpr int to_initial = 980;
        constexpr int to_r = 990;
        skipped.erase(to_initial);
        skipped.erase(to_r);
    }
    if (!skipped.empty())
        builder.remark("skipped codes that move nothing: " + list(skipped));
}

}  // namespace endmill
