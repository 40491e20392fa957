// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_modes.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

// A block is checked in three steps, in this order:
// 1. `GcodeModes::apply` sets the modes. Every G code belongs to a modal group; two codes
//    of one group in a block are refused, so the order of the codes within a block does
//    not matter.
// 2. `check_m_codes` refuses M codes that would change the meaning of the program.
// 3. `check_words` refuses words that have no use under the modes in force.

namespace endmill {
namespace {

// A range of codes that are refused. G codes are in tenths, M codes are whole numbers.
struct Refusal {
    int first;
    int last;
    std::string_view found;
    std::string_view expected;
};

constexpr std::string_view moves_written_out =
    "moves written out: expand them with rs274 -g and give its output";
constexpr std::string_view only_three_axes = "a three-axis program";
constexpr std::string_view one_frame = "coordinates in one coordinate system of the part";

constexpr std::array refused_g_codes{
    Refusal{50, 53, "spline", moves_written_out},
    Refusal{100, 100, "setting of offsets", one_frame},
    Refusal{280, 281, "reference point", one_frame},
    Refusal{300, 301, "reference point", one_frame},
    Refusal{380, 385, "probing", "a program that cuts"},
    Refusal{410, 411, "cutter compensation", "a path of the cutter's tip (G40)"},
    Refusal{420, 421, "cutter compensation", "a path of the cutter's tip (G40)"},
    Refusal{434, 435, "tool-centre-point code", only_three_axes},
    Refusal{500, 510, "scaling", one_frame},
    Refusal{520, 523, "coordinate offset", one_frame},
    Refusal{530, 530, "machine coordinates", one_frame},
    Refusal{680, 693, "rotation", one_frame},
    Refusal{730, 730, "canned cycle", moves_written_out},
    Refusal{740, 740, "canned cycle", moves_written_out},
    Refusal{760, 760, "canned cycle", moves_written_out},
    Refusal{810, 899, "canned cycle", moves_written_out},
    Refusal{920, 923, "coordinate offset", one_frame},
    Refusal{950, 950, "feed per revolution", "G93 or G94"},
    Refusal{960, 960, "constant surface speed", "a spindle speed S in 1/min"},
    Refusal{2340, 2340, "tool-centre-point code", only_three_axes},
};

constexpr std::array refused_m_codes{
    Refusal{70, 73, "saved modal state", moves_written_out},
    Refusal{97, 99, "subprogram", moves_written_out},
    Refusal{128, 128, "tool-centre-point code", only_three_axes},
    Refusal{198, 199, "subprogram", moves_written_out},
};

std::string g_name(int tenths)
{
    const std::string whole = 'G' + std::to_string(tenths / 10);
    return tenths % 10 == 0 ? whole : whole + '.' + std::to_string(tenths % 10);
}

const Refusal* refusal_of(int code, std::span<const Refusal> refused)
{
    for (const Refusal& refusal : refused)
        if (refusal.first <= code && code <= refusal.last)
            return &refusal;
    return nullptr;
}

// Modal groups with the numbers of the source. A block may have one code of each.
enum Group : unsigned {
    NonModal = 0,
    MotionGroup = 1,
    PlaneGroup = 2,
    DistanceGroup = 3,
    CentreGroup = 4,
    FeedGroup = 5,
    UnitGroup = 6,
    CompensationGroup = 7,
    LengthGroup = 8,
    SystemGroup = 12,
    ControlGroup = 13,
    UnknownGroup = 31,
};

bool is_coordinate_system(int code)
{
    return (540 <= code && code <= 590 && code % 10 == 0) || (591 <= code && code <= 593);
}

// The modal group of a G code in tenths.
Group group_of(int code)
{
    switch (code) {
        case 40:
            return NonModal;
        case 0:
        case 10:
        case 20:
        case 30:
        case 800:
            return MotionGroup;
        case 170:
        case 180:
        case 190:
            return PlaneGroup;
        case 200:
        case 210:
            return UnitGroup;
        case 400:
            return CompensationGroup;
        case 430:
        case 490:
            return LengthGroup;
        case 610:
        case 611:
        case 640:
            return ControlGroup;
        case 900:
        case 910:
            return DistanceGroup;
        case 901:
        case 911:
            return CentreGroup;
        case 930:
        case 940:
            return FeedGroup;
        default:
            return is_coordinate_system(code) ? SystemGroup : UnknownGroup;
    }
}

[[noreturn]] void refuse_g_code(int code, const TextLines& lines)
{
    if (const Refusal* const refusal = refusal_of(code, refused_g_codes))
        throw lines.complaint(std::string{refusal->found} + ' ' + g_name(code),
                              std::string{refusal->expected});
    throw lines.complaint("unknown code " + g_name(code), "a G code of the subset");
}

// The machine, not the program, stores the distance between the origins of two coordinate
// systems. A program that uses a single one describes the same path wherever its origin
// lies.
void set_coordinate_system(GcodeModes& modes, int code, const TextLines& lines)
{
    if (modes.coordinate_system != 0 && modes.coordinate_system != code)
        throw lines.complaint(g_name(code) + " after " + g_name(modes.coordinate_system),
                              "one coordinate system");
    modes.coordinate_system = code;
}

void set_mode(GcodeModes& modes, int code)
{
    switch (code) {
        case 0:
            modes.motion = GcodeMotion::Rapid;
            break;
        case 10:
            modes.motion = GcodeMotion::Straight;
            break;
        case 20:
            modes.motion = GcodeMotion::ClockwiseArc;
            break;
        case 30:
            modes.motion = GcodeMotion::CounterclockwiseArc;
            break;
        case 800:
            modes.motion = GcodeMotion::None;
            break;
        case 170:
            modes.plane = ArcPlane::Xy;
            break;
        case 180:
            modes.plane = ArcPlane::Zx;
            break;
        case 190:
            modes.plane = ArcPlane::Yz;
            break;
        case 200:
            modes.unit = GcodeUnit::Inch;
            break;
        case 210:
            modes.unit = GcodeUnit::Millimetre;
            break;
        case 430:
            modes.used_tool_length = true;
            break;
        case 640:
            modes.used_blending = true;
            break;
        case 900:
        case 910:
            modes.distance =
                code == 910 ? DistanceMode::Incremental : DistanceMode::Absolute;
            break;
        case 901:
        case 911:
            modes.centres =
                code == 901 ? DistanceMode::Absolute : DistanceMode::Incremental;
            break;
        case 930:
        case 940:
            modes.feed =
                code == 930 ? FeedRateMode::InverseTime : FeedRateMode::PerMinute;
            break;
        default:  // G4, G40, G49, G61 and G61.1 do not change the path
            break;
    }
}

// The modal group of an M code of which a block may have only one, or 0. Other M codes
// may stand together in a block, as in LinuxCNC: M3 beside M8.
unsigned m_group(int code)
{
    constexpr unsigned stops = 4;
    constexpr unsigned spindle = 7;
    if (code <= 2 || code == 30 || code == 60)
        return stops;
    return 3 <= code && code <= 5 ? spindle : 0;
}

}  // namespace

// The order of the codes does not matter, because each group occurs at most once.
void GcodeModes::apply(const GcodeBlock& block, const TextLines& lines)
{
    std::uint32_t groups = 0;
    for (const int code : block.g.all()) {
        const Group group = group_of(code);
        if (group == UnknownGroup)
            refuse_g_code(code, lines);
        if (((groups >> group) & 1U) != 0)
            throw lines.complaint(
                g_name(code) + " together with another code of its modal group",
                "one code of each modal group");
        groups |= 1U << group;
        if (group == SystemGroup)
            set_coordinate_system(*this, code, lines);
        else
            set_mode(*this, code);
    }
}

void check_m_codes(const GcodeBlock& block, const TextLines& lines)
{
    std::uint32_t groups = 0;
    for (const int code : block.m.all()) {
        const std::string name = 'M' + std::to_string(code);
        if (const Refusal* const refusal = refusal_of(code, refused_m_codes))
            throw lines.complaint(std::string{refusal->found} + ' ' + name,
                                  std::string{refusal->expected});
        const unsigned group = m_group(code);
        if (group != 0 && ((groups >> group) & 1U) != 0)
            throw lines.complaint(name + " together with another code of its modal group",
                                  "one code of each modal group");
        groups |= 1U << group;
    }
}

bool is_arc(const GcodeBlock& block, const GcodeModes& modes)
{
    return (modes.motion == GcodeMotion::ClockwiseArc ||
            modes.motion == GcodeMotion::CounterclockwiseArc) &&
           block.has_any("XYZIJKR");
}

void check_words(const GcodeBlock& block, const GcodeModes& modes, const TextLines& lines)
{
    for (const char letter : {'A', 'B', 'C'})
        if (block.has(letter))
            throw lines.complaint(std::string{"rotary axis word "} + letter,
                                  "a three-axis program: five axes need --machine");
    const bool dwells = block.g.contains(40);
    const bool blends = block.g.contains(640);
    if (dwells && !(block.has('P') && block.value('P') >= 0))
        throw lines.complaint("G4 without P >= 0", "P, the time to wait in s");
    if (block.has('Q') && !blends)
        throw lines.complaint("word Q", "Q only beside G64");
    const bool is_used_otherwise = dwells || blends || block.has('M');
    if (block.has('L') && !block.has('M'))
        throw lines.complaint("word L", "L only beside an M code that takes it");
    const bool along_arc = is_arc(block, modes);
    for (const char letter : {'I', 'J', 'K', 'R', 'P'}) {
        if (!block.has(letter) || along_arc)
            continue;
        const bool is_for_others = letter == 'P' || letter == 'R';
        if (!(is_for_others && is_used_otherwise))
            throw lines.complaint(std::string{"word "} + letter + " without an arc",
                                  "the word in a block with G2 or G3");
    }
    if (block.has('P') && (dwells || blends) && along_arc)
        throw lines.complaint("word P for both an arc and G4 or G64",
                              "two separate blocks");
}

}  // namespace endmill
