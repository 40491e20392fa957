// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/text_lines.h"

namespace endmill {

/// What axis words do.
enum class GcodeMotion {
    None,                 ///< G80, and before the first code
    Rapid,                ///< G0
    Straight,             ///< G1
    ClockwiseArc,         ///< G2
    CounterclockwiseArc,  ///< G3
};

/// What the numbers of a program measure in.
enum class GcodeUnit {
    Unsaid,      ///< before the first code: taken as mm
    Inch,        ///< G20
    Millimetre,  ///< G21
};

/// What the G codes of a program leave in force, block after block.
/// Source: [KramerProctorMessina, "Modal Groups"].
struct GcodeModes {
    GcodeMotion motion = GcodeMotion::None;  ///< group 1
    ArcPlane plane = ArcPlane::Xy;           ///< group 2
    GcodeUnit unit = GcodeUnit::Unsaid;      ///< group 6
    bool incremental = false;                ///< G91
    bool absolute_centres = false;           ///< G90.1
    bool inverse_time = false;               ///< G93
    int coordinate_system = 0;               ///< 540 to 593, in tenths; 0 if never named
    bool used_tool_length = false;           ///< whether there was a G43
    bool used_blending = false;              ///< whether there was a G64

    /// mm in the unit of length.
    double mm_per_unit() const { return unit == GcodeUnit::Inch ? 25.4 : 1; }

    /// Puts the codes of `block` into force.
    /// \throws FormatError at the line where `lines` stands for a code that is not of the
    ///         subset, saying which kind it is; two codes of one group; a second
    ///         coordinate system.
    void apply(const GcodeBlock& block, const TextLines& lines);
};

/// \throws FormatError at the line where `lines` stands if an M code of `block` calls a
///         subprogram, moves the tool's centre point or brings back a former state, or if
///         two stop or two turn the spindle.
void check_m_codes(const GcodeBlock& block, const TextLines& lines);

/// Whether `block` goes along an arc: a full circle needs no axis word.
/// \param modes with the block's codes in force.
bool is_arc(const GcodeBlock& block, const GcodeModes& modes);

/// \throws FormatError at the line where `lines` stands if a word stands in a block that has
///         no use for it: it would be one that another control has a use for.
/// \param modes with the block's codes in force.
void check_words(const GcodeBlock& block, const GcodeModes& modes,
                 const TextLines& lines);

}  // namespace endmill
