// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>

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

    /// Notes a move whose start is unknown; it is left out.
    void note_left_out() { ++moves_left_out_; }

    /// Whether a move was left out.
    bool has_motion() const { return moves_left_out_ > 0; }

    /// Notes that the path begins in line `line`.
    void note_start(std::size_t line) { start_line_ = line; }

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
    using UsesOfCodes = std::map<int, Uses>;  // by G code in tenths

    static void count(UsesOfCodes& uses, int code, const TextLines& lines);
    static std::string list(const UsesOfCodes& uses);

    UsesOfCodes idle_codes_;
    UsesOfCodes references_;
    std::size_t moves_left_out_ = 0;  // including the move to the first point, if at feed
    std::size_t start_line_ = 0;      // line of the first point, 0 before it
    std::size_t first_unit_line_ =
        0;  // of the first G20 or G21 after a length, 0 if none
    bool has_unstated_lengths_ = false;
    bool has_inches_ = false;
    bool has_cycles_ = false;
};

}  // namespace endmill
