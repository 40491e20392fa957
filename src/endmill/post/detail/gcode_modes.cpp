// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/gcode_modes.h"

#include <algorithm>
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
    "moves written out: --interpreter linuxcnc expands them";
constexpr std::string_view only_axes =
    "positions of the axes, or tips with rotary words (--frame part)";
constexpr std::string_view one_frame = "coordinates in one coordinate system of the part";
constexpr std::string_view offset_applied =
    "coordinates in one coordinate system of the part: --interpreter linuxcnc applies "
    "offsets";
constexpr std::string_view tip_path =
    "a path of the cutter's tip (G40): only the control knows the radius";

constexpr std::array refused_g_codes{
    Refusal{50, 53, "spline", moves_written_out},
    Refusal{70, 70, "diameters of a lathe", "coordinates of a milling machine (G8)"},
    Refusal{100, 100, "setting of offsets", offset_applied},
    Refusal{330, 331, "motion in step with the spindle", "G1 with a feed F"},
    Refusal{380, 385, "probing", "a program that cuts"},
    Refusal{410, 411, "cutter compensation", tip_path},
    Refusal{420, 421, "cutter compensation", tip_path},
    Refusal{434, 435, "tool-centre-point code", only_axes},
    Refusal{510, 511, "scaling or mirroring", one_frame},
    Refusal{520, 523, "coordinate offset", offset_applied},
    Refusal{531, 531, "turn into a tilted plane", one_frame},
    Refusal{680, 683, "rotation or tilted plane", one_frame},
    Refusal{760, 760, "canned cycle", "G73, G74, G81 to G86, G88 or G89"},
    Refusal{870, 870, "back boring, which cuts from below",
            "G73, G74, G81 to G86, G88 or G89"},
    Refusal{811, 899, "canned cycle", "G73, G74, G81 to G86, G88 or G89"},
    Refusal{920, 920, "coordinate offset", offset_applied},
    Refusal{923, 923, "coordinate offset", offset_applied},
    Refusal{950, 950, "feed per revolution", "G93 or G94"},
    Refusal{2340, 2340, "tool-centre-point code", only_axes},
};

// Accepted without effect, in order: the codes cancel polar coordinates, diameters of a
// lathe, scaling, mirroring, modal macros, rotation and offsets (G92.1 and G92.2), or
// store a reference point (G28.1, G30.1). G96 to G99 are here because their modes do not
// move the tool either.
constexpr std::array idle_g_codes{80,  150, 281, 301, 500, 501, 670,
                                  690, 921, 922, 960, 970, 980, 990};

// Those of them that use X, Y and Z on some controls.
constexpr std::array lonely_g_codes{281, 301, 500, 501, 921, 922};

constexpr std::array refused_m_codes{
    Refusal{47, 47, "repetition of the program", moves_written_out},
    Refusal{70, 73, "saved modal state", moves_written_out},
    Refusal{96, 99, "branch or subprogram", moves_written_out},
    Refusal{128, 128, "tool-centre-point code", only_axes},
    Refusal{198, 199, "subprogram", moves_written_out},
    Refusal{200, 999, "unknown code", "M0 to M199"},
};

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
    RetractGroup = 10,
    SystemGroup = 12,
    ControlGroup = 13,
    SpeedGroup = 14,
    IdleGroup = 29,      // no group of the source: codes without effect
    EndCycleGroup = 30,  // G80, which the source counts to the group of motion
    UnknownGroup = 31,
};

bool is_coordinate_system(int code)
{
    return (540 <= code && code <= 590 && code % 10 == 0) || (591 <= code && code <= 593);
}

// Canned cycles that are read.
bool is_canned_cycle(int code)
{
    return code == 730 || code == 740 || (810 <= code && code <= 860 && code % 10 == 0) ||
           code == 880 || code == 890;
}

// The modal group of a G code in tenths.
Group group_of(int code)
{
    switch (code) {
        case 40:
        case 280:
        case 300:
        case 530:
            return NonModal;
        case 0:
        case 10:
        case 20:
        case 30:
            return MotionGroup;
        case 800:
            return EndCycleGroup;
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
        case 960:
        case 970:
            return SpeedGroup;
        case 980:
        case 990:
            return RetractGroup;
        default:
            break;
    }
    if (is_coordinate_system(code))
        return SystemGroup;
    if (is_canned_cycle(code))
        return MotionGroup;
    return is_idle_g_code(code) ? IdleGroup : UnknownGroup;
}

[[noreturn]] void refuse_g_code(int code, const TextLines& lines)
{
    if (const Refusal* const refusal = refusal_of(code, refused_g_codes))
        throw lines.complaint(std::string{refusal->found} + ' ' + g_name(code),
                              std::string{refusal->expected});
    throw lines.complaint("unknown code " + g_name(code), std::string{known_g_codes});
}

// The machine, not the program, stores the distance between the origins of two coordinate
// systems. A program that uses a single one describes the same path wherever its origin
// lies.
void set_coordinate_system(GcodeModes& modes, int code, const TextLines& lines)
{
    if (modes.coordinate_system != 0 && modes.coordinate_system != code)
        throw lines.complaint(
            g_name(code) + " after " + (modes.has_stated_system ? "" : "positions in ") +
                g_name(modes.coordinate_system) +
                (modes.has_stated_system ? "" : ", with which controls begin"),
            "one coordinate system");
    modes.coordinate_system = code;
    modes.has_stated_system = true;
}

bool has_group(std::uint32_t groups, Group group)
{
    return ((groups >> group) & 1U) != 0;
}

void set_motion(GcodeModes& modes, int code)
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
        default:
            modes.motion = GcodeMotion::Cycle;
            modes.cycle = code / 10;
            break;
    }
}

void set_mode(GcodeModes& modes, int code)
{
    switch (code) {
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
            modes.unit = ProgramUnit::Inch;
            break;
        case 210:
            modes.unit = ProgramUnit::Mm;
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
        case 960:
        case 970:
            modes.has_surface_speed = code == 960;
            break;
        case 980:
        case 990:
            modes.retract = code == 980 ? RetractLevel::Initial : RetractLevel::R;
            break;
        default:  // others, such as G4, G40, G43 and G64, do not change the path
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

void check_axis_words(const GcodeBlock& block, const TextLines& lines)
{
    for (const int code : block.g.all())
        if (is_idle_g_code(code) && std::ranges::binary_search(lonely_g_codes, code) &&
            block.has_any("XYZ"))
            throw lines.complaint("X, Y or Z beside " + g_name(code), "the code alone");
}

// P, the dwell, moves nothing and may be missing. K is the number of holes where L is
// missing, as on Fanuc controls.
void check_cycle_words(const GcodeBlock& block, const GcodeModes& modes,
                       const TextLines& lines)
{
    const bool pecks = modes.cycle == 73 || modes.cycle == 83;
    if (block.has('Q') && !pecks)
        throw lines.complaint("word Q beside G" + std::to_string(modes.cycle),
                              "Q only beside G73 or G83");
    for (const char letter : {'I', 'J'})
        if (block.has(letter))
            throw lines.complaint(std::string{"word "} + letter + " in a canned cycle",
                                  "the words X, Y, Z, R, Q, P and L");
    if (block.has('P') && block.value('P') < 0)
        throw lines.complaint("a dwell P" + brief(block.value('P')), "P >= 0");
    if (block.has('L') && block.has('K'))
        throw lines.complaint("words L and K in a canned cycle", "one number of holes");
}

}  // namespace

std::string g_name(int tenths)
{
    const std::string whole = 'G' + std::to_string(tenths / 10);
    return tenths % 10 == 0 ? whole : whole + '.' + std::to_string(tenths % 10);
}

bool is_idle_g_code(int code)
{
    return code >= idle_g_codes.front() && std::ranges::binary_search(idle_g_codes, code);
}

ReferenceMove reference_move(const GcodeBlock& block)
{
    for (const int code : block.g.all()) {
        if (code == 280 || code == 300)
            return ReferenceMove::ReferencePoint;
        if (code == 530)
            return ReferenceMove::MachineCoordinates;
    }
    return ReferenceMove::None;
}

// The order of the codes does not matter, because each group occurs at most once.
void GcodeModes::apply(const GcodeBlock& block, const TextLines& lines)
{
    std::uint32_t groups = 0;
    for (const int code : block.g.all()) {
        const Group group = group_of(code);
        if (group == UnknownGroup)
            refuse_g_code(code, lines);
        if (group != IdleGroup && has_group(groups, group))
            throw lines.complaint(
                g_name(code) + " together with another code of its modal group",
                "one code of each modal group");
        groups |= 1U << group;
        if (group == SystemGroup)
            set_coordinate_system(*this, code, lines);
        else if (group == MotionGroup)
            set_motion(*this, code);
        else
            set_mode(*this, code);
    }
    const bool has_motion = has_group(groups, MotionGroup);
    if (has_group(groups, EndCycleGroup)) {
        if (has_motion && motion == GcodeMotion::Cycle)
            throw lines.complaint("G80 beside a canned cycle", "two separate blocks");
        if (!has_motion)
            motion = GcodeMotion::None;
    }
    const bool is_straight =
        motion == GcodeMotion::Rapid || motion == GcodeMotion::Straight;
    if (has_motion && !is_straight && reference_move(block) != ReferenceMove::None)
        throw lines.complaint("two codes that both use X, Y and Z",
                              "two separate blocks");
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

bool is_cycle(const GcodeBlock& block, const GcodeModes& modes)
{
    return modes.motion == GcodeMotion::Cycle &&
           reference_move(block) == ReferenceMove::None &&
           (block.has_any("XYZ") || std::ranges::any_of(block.g.all(), is_canned_cycle));
}

void check_words(const GcodeBlock& block, const GcodeModes& modes, const TextLines& lines)
{
    check_axis_words(block, lines);
    if (is_cycle(block, modes))
        return check_cycle_words(block, modes, lines);
    const bool dwells = block.g.contains(40);
    const bool blends = block.g.contains(640);
    if (dwells && !(block.has('P') && block.value('P') >= 0))
        throw lines.complaint("G4 without P >= 0", "P, the time to wait in s");
    if (block.has('Q') && !blends && !block.has('M'))
        throw lines.complaint("word Q", "Q only beside G64, G73 or G83");
    const bool is_used_otherwise =
        dwells || blends || block.has('M') || block.g.contains(300);
    if (block.has('L') && !block.has('M'))
        throw lines.complaint("word L",
                              "L only beside a canned cycle or an M code that takes it");
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
