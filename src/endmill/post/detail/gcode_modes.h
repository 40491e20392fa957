// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/text_lines.h"
#include "endmill/post/program.h"

namespace endmill {

/// Motion mode: the motion that axis words cause.
enum class GcodeMotion {
    None,                 ///< G80, and before the first code
    Rapid,                ///< G0
    Straight,             ///< G1
    ClockwiseArc,         ///< G2
    CounterclockwiseArc,  ///< G3
    Cycle,                ///< a canned cycle, such as G81
};

/// Height to which a canned cycle retracts.
enum class RetractLevel {
    Unstated,  ///< before the first code: that of G99
    Initial,   ///< G98: height before the first hole
    R,         ///< G99: height of the word R
};

/// Meaning of coordinates.
enum class DistanceMode {
    Absolute,     ///< positions: G90 for ends of moves, G90.1 for centres of arcs
    Incremental,  ///< increments: G91 for ends of moves, G91.1 for centres of arcs
};

/// Meaning of F.
enum class FeedRateMode {
    PerMinute,    ///< G94: units of length per minute
    InverseTime,  ///< G93: 1 over the minutes that the move takes
};

/// The modes that the G codes of a program set, block after block.
/// Source: [KramerProctorMessina, section 3.4].
struct GcodeModes {
    GcodeMotion motion = GcodeMotion::None;            ///< group 1
    ArcPlane plane = ArcPlane::Xy;                     ///< group 2
    DistanceMode distance = DistanceMode::Absolute;    ///< group 3, ends of moves
    DistanceMode centres = DistanceMode::Incremental;  ///< group 4, words I, J, K
    FeedRateMode feed = FeedRateMode::PerMinute;       ///< group 5
    /// Group 6; nothing before the first code, which is taken as mm.
    std::optional<ProgramUnit> unit = {};
    /// Group 12: 540 to 593, in tenths; 0 before the first code and the first position.
    int coordinate_system = 0;
    bool has_stated_system = false;  ///< whether a code of group 12 occurred
    int cycle = 0;  ///< G code of the canned cycle, such as 81; 0 before the first one
    RetractLevel retract = RetractLevel::Unstated;  ///< group 10
    bool has_surface_speed = false;  ///< G96: S is a cutting speed, not a spindle speed

    /// mm per unit of length.
    double mm_per_unit() const { return millimetres_per(unit.value_or(ProgramUnit::Mm)); }

    /// Notes that a position was stated. Without a code it is in the system G54, with
    /// which controls begin.
    void use_coordinate_system()
    {
        constexpr int first_system = 540;
        if (coordinate_system == 0)
            coordinate_system = first_system;
    }

    /// Applies the G codes of `block`.
    /// \throws FormatError at the current line of `lines` for a code outside the subset,
    ///         with its kind; for two codes of one modal group, except G80 beside G0 to
    ///         G3, which is then without effect; for two codes that both use the axis
    ///         words; for a second coordinate system.
    void apply(const GcodeBlock& block, const TextLines& lines);
};

/// A move of a block to a position that the machine knows and the program does not.
enum class ReferenceMove {
    None,                ///< the block has no such move
    ReferencePoint,      ///< G28, G30: to a reference point, through the words X, Y, Z
    MachineCoordinates,  ///< G53: the words X, Y, Z are machine coordinates
};

/// The reference move of `block`.
ReferenceMove reference_move(const GcodeBlock& block);

/// "G43.2" for the code 432.
std::string g_name(int tenths);

/// Whether a G code in tenths is accepted although the reader does not model its mode: it
/// moves nothing, and it cancels a mode that the reader refuses or stores a position that
/// the program does not use.
bool is_idle_g_code(int code);

/// Checks the M codes of `block`.
/// \throws FormatError at the current line of `lines` for an M code that calls a
///         subprogram, controls the tool centre point or restores saved modes, for two
///         codes that stop, or for two that control the spindle.
void check_m_codes(const GcodeBlock& block, const TextLines& lines);

/// Whether `block` describes an arc. A full circle needs no axis word, so I, J, K or R
/// suffice.
/// \param block the block.
/// \param modes with the codes of the block in force.
bool is_arc(const GcodeBlock& block, const GcodeModes& modes);

/// Whether `block` runs the canned cycle in force.
/// \param block the block.
/// \param modes with the codes of the block in force.
bool is_cycle(const GcodeBlock& block, const GcodeModes& modes);

/// Checks that every word of `block` has a use in it. A word without a use is refused,
/// because another control may give it one. RotaryWords checks the words A, B and C.
/// \param block the block.
/// \param modes with the codes of the block in force.
/// \param lines for error messages.
/// \throws FormatError at the current line of `lines`.
void check_words(const GcodeBlock& block, const GcodeModes& modes,
                 const TextLines& lines);

}  // namespace endmill
