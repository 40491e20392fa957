// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "endmill/core/detail/units.h"
#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/text_lines.h"

namespace endmill {

/// Motion mode: the motion that axis words cause.
enum class GcodeMotion {
    None,                 ///< G80, and before the first code
    Rapid,                ///< G0
    Straight,             ///< G1
    ClockwiseArc,         ///< G2
    CounterclockwiseArc,  ///< G3
};

/// Unit of the lengths of a program.
enum class GcodeUnit {
    Unsaid,      ///< before the first code: taken as mm
    Inch,        ///< G20
    Millimetre,  ///< G21
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
    GcodeUnit unit = GcodeUnit::Unsaid;                ///< group 6
    /// Group 12: 540 to 593, in tenths; 0 before the first code.
    int coordinate_system = 0;
    bool used_tool_length = false;  ///< whether a G43 occurred
    bool used_blending = false;     ///< whether a G64 occurred

    /// mm per unit of length.
    double mm_per_unit() const { return unit == GcodeUnit::Inch ? mm_per_inch : 1; }

    /// Applies the G codes of `block`.
    /// \throws FormatError at the current line of `lines` for a code outside the subset,
    ///         with its kind; for two codes of one modal group; for a second coordinate
    ///         system.
    void apply(const GcodeBlock& block, const TextLines& lines);
};

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

/// Checks that every word of `block` has a use in it. A word without a use is refused,
/// because another control may give it one.
/// \param block the block.
/// \param modes with the codes of the block in force.
/// \param lines for error messages.
/// \throws FormatError at the current line of `lines`.
void check_words(const GcodeBlock& block, const GcodeModes& modes,
                 const TextLines& lines);

}  // namespace endmill
