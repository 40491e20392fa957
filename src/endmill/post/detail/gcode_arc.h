// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/gcode_block.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/detail/text_lines.h"

namespace endmill {

/// Tolerance in mm for the difference of the radii at the two ends of an arc, and for a
/// radius R that is too small: the larger of 0.01 mm and 0.1 % of `radius_mm`.
/// Source: docs/methods/removal.md, section 5.
double radius_tolerance(double radius_mm);

/// Checks the radii of `arc`.
/// \throws FormatError at the current line of `lines` if a radius is 0, or if the radii
///         differ by more than `radius_tolerance` of the one at the start.
void check_radii(const Arc& arc, const TextLines& lines);

/// Reads the arc that a block with G2 or G3 describes.
class ArcReader {
public:
    /// \param block the block; must outlive the reader.
    /// \param modes with the codes of the block in force; must outlive the reader.
    /// \param lines for error messages; must outlive the reader.
    /// \param max_extent_mm mm, largest magnitude of a word.
    ArcReader(const GcodeBlock& block, const GcodeModes& modes, const TextLines& lines,
              double max_extent_mm)
        : block_{block},
          modes_{modes},
          lines_{lines},
          max_extent_mm_{max_extent_mm}
    {
    }

    /// Checks the words of the arc.
    /// \throws FormatError with file and line if the block has neither a centre nor R, or
    ///         both; for a centre outside the plane or an incomplete absolute centre; for
    ///         a number of turns P that is not a whole number from 1.
    void check_words() const;

    /// The arc between two positions in mm.
    /// \throws FormatError with file and line if R is too small or describes a full
    ///         circle, or as `check_radii`; E_RANGE if a word exceeds the largest extent.
    /// \pre check_words() has not thrown.
    Arc arc(const Vec3& start, const Vec3& end) const;

private:
    double length(char letter) const;
    Vec3 centre_of_words(const Arc& ends) const;
    Vec3 centre_of_r(const Arc& ends) const;

    const GcodeBlock& block_;
    const GcodeModes& modes_;
    const TextLines& lines_;
    double max_extent_mm_;
};

}  // namespace endmill
