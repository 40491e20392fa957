// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/detail/text_lines.h"

namespace endmill {

/// A move of a canned cycle along the axis of the hole.
struct HoleMove {
    double level;              ///< mm, where it ends
    bool is_feed;              ///< whether it is at feed; otherwise it is a rapid
    bool is_reversed = false;  ///< whether the spindle is reversed on it alone (tapping)
};

/// The moves of a block with a canned cycle: at every hole a rapid at the level of
/// approach over the hole, a rapid to R, and the moves in the hole.
struct CannedCycle {
    PlaneAxes axes;     ///< the hole is along the normal
    Vec3 first_hole;    ///< mm, position of the first hole in the plane
    Vec3 step;          ///< mm, from hole to hole; 0 under G90
    std::size_t holes;  ///< number of holes, at least 1
    bool begins_at_r;   ///< whether a rapid to R precedes, over the start position
    double approach;    ///< mm, level of the rapid to the first hole
    double r;           ///< mm, level of R
    double clear;       ///< mm, level after a hole, and of the rapid to the next one
    std::vector<HoleMove> hole;  ///< moves in a hole, from R on
};

/// Words of canned cycles that stay in force from block to block, and the initial level.
///
/// The moves are those of LinuxCNC. Other controls differ in details: the level to which
/// a drill returns after a peck (here 0.254 mm above the last depth), and the retract
/// level before any G98 or G99 (here R; on Fanuc controls the initial level).
/// R, Q and the depth must be given in the first block of a cycle, and again after
/// another cycle or another motion. The initial level is that before the first of
/// consecutive cycles.
class CannedCycles {
public:
    /// The moves of `block`, which runs the cycle in force.
    /// \param block the block. \pre is_cycle(block, modes)
    /// \param modes with the codes of the block in force.
    /// \param position mm, before the block.
    /// \param room number of points that the path can still take.
    /// \param lines for error messages.
    /// \throws FormatError with file and line for a missing R, Q or depth, an R below the
    ///         depth, a Q that is not above 0, a number of holes that is not a whole number
    ///         from 1, a change of the unit of length since the last of consecutive cycles.
    /// \throws LimitError if the moves are more than `room`.
    CannedCycle next(const GcodeBlock& block, const GcodeModes& modes,
                     const Vec3& position, std::size_t room, const TextLines& lines);

    /// Forgets the words and the initial level, at another motion or G80.
    void end() { code_ = 0; }

private:
    void take_words(const GcodeBlock& block, const GcodeModes& modes, char depth_letter,
                    const TextLines& lines);
    void set_levels(CannedCycle& cycle, RetractLevel retract, double start) const;

    int code_ = 0;            // of the last block; 0 if it had no cycle
    double mm_per_unit_ = 1;  // of the last block with a cycle
    double initial_level_ = 0;
    double r_ = 0;  // words as given, in mm
    double depth_ = 0;
    double peck_ = 0;
};

}  // namespace endmill
