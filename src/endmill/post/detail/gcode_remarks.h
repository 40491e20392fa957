// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/detail/program_builder.h"
#include "endmill/post/detail/text_lines.h"

namespace endmill {

/// Collects what a person should know about a program that is read: assumed units, motion
/// that is left out, codes without effect, moves to reference positions. Each remark is
/// made once, so that their number does not grow with the file.
class GcodeRemarks {
public:
    /// Notes the lengths of a block before any G20 or G21.
    void note_unstated_lengths(const GcodeBlock& block);

    /// Notes the modes of a block with G codes.
    /// \param block the block at the current line.
    /// \param before modes before the block.
    /// \param after modes with the codes of the block in force.
    /// \param lines the current line.
    /// \param builder takes the remarks that depend on the place in the program.
    void note_modes(const GcodeBlock& block, const GcodeModes& before,
                    const GcodeModes& after, const TextLines& lines,
                    ProgramBuilder& builder);

    /// Counts the M codes of `block` that the reader skips.
    void note_m_codes(const GcodeBlock& block, const TextLines& lines);

    /// Notes a move whose start is unknown; it is left out.
    void note_left_out(bool is_rapid)
    {
        ++moves_left_out_;
        has_left_out_feed_ = has_left_out_feed_ || !is_rapid;
    }

    /// Whether a move was left out.
    bool has_motion() const { return moves_left_out_ > 0; }

    /// Notes that the path begins in line `line` at this height in mm.
    void note_start(std::size_t line, double height_mm)
    {
        start_line_ = line;
        start_height_mm_ = height_mm;
    }

    /// Notes the reference move of `block`.
    void note_reference(const GcodeBlock& block, const TextLines& lines);

    /// Notes a canned cycle.
    void note_cycle(const GcodeModes& modes, ProgramBuilder& builder);

    /// Adds the remarks on the whole program to `builder`.
    void finish(const GcodeModes& modes, bool has_ended, ProgramBuilder& builder) const;

private:
    struct Uses {
        std::size_t count = 0;
        std::size_t first_line = 0;
    };
    using Code =
        std::pair<char, int>;  // the letter; G codes in tenths, M codes as they are
    using UsesOfCodes = std::map<Code, Uses>;

    static void count(UsesOfCodes& uses, Code code, const TextLines& lines);
    static std::string list(const UsesOfCodes& uses);
    bool matters_what_was_left_out(const ProgramBuilder& builder) const;
    std::string skipped_codes() const;

    UsesOfCodes skipped_;
    UsesOfCodes references_;
    std::size_t moves_left_out_ = 0;  // including the move to the first point, if at feed
    bool has_left_out_feed_ = false;
    std::size_t start_line_ = 0;  // line of the first point, 0 before it
    double start_height_mm_ = 0;  // of the first point
    std::size_t first_unit_line_ =
        0;  // of the first G20 or G21 after a length, 0 if none
    bool has_unstated_lengths_ = false;
    bool has_cycles_ = false;
    bool blends_without_limit_ = false;  // a G64 without P
};

}  // namespace endmill
