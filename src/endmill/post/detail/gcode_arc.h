// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/detail/text_lines.h"
#include "endmill/post/gcode_reader.h"

namespace endmill {

/// How far the radii at both ends of an arc may differ, and a radius be too small: the
/// larger of 0.01 mm and 0.1 % of `radius_mm`.
/// Source: spec of the removal, section 5.
double radius_tolerance(double radius_mm);

/// \throws FormatError at the line where `lines` stands if a radius of `arc` is 0, or both
///         differ by more than `radius_tolerance` of that at the start.
void check_radii(const Arc& arc, const TextLines& lines);

/// Reads the arc that a block of G2 or G3 describes.
class ArcReader {
public:
    /// All of them outlive this; `modes` with the codes of the block in force.
    ArcReader(const GcodeBlock& block, const GcodeModes& modes, const TextLines& lines,
              const GcodeReadOptions& options)
        : block_{block},
          modes_{modes},
          lines_{lines},
          options_{options}
    {
    }

    /// \throws FormatError with the line if the block has neither centre nor R, or both; a
    ///         centre out of the plane, or half of an absolute one; turns P that are no
    ///         whole number from 1.
    void check_words() const;

    /// The arc between two positions in mm.
    /// \throws FormatError with the line if R is too small or is to make a full circle, or
    ///         as `check_radii`; E_RANGE if a word is beyond the largest extent.
    /// \pre check_words() has not thrown.
    Arc arc(const Vec3& start, const Vec3& end) const;

private:
    double length(char letter) const;
    Vec3 centre_of_words(const Arc& ends) const;
    Vec3 centre_of_r(const Arc& ends) const;

    const GcodeBlock& block_;
    const GcodeModes& modes_;
    const TextLines& lines_;
    const GcodeReadOptions& options_;
};

}  // namespace endmill
