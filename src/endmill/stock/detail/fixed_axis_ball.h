// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "endmill/core/vec.h"
#include "endmill/stock/detail/ball_chords.h"
#include "endmill/stock/detail/tool_pieces.h"
#include "endmill/stock/dexel_stock.h"

/// \file
/// What a ball-end mill removes on the rays of dexels on a straight move with a fixed axis
/// along x, y or z. The ends of the chords have a closed form, for eight rays at once.

namespace endmill {

/// A straight move of an endless ball-end mill with a fixed axis along x, y or z.
struct FixedAxisBall {
    Vec3 from;      ///< mm, centre of the ball at the start
    Vec3 to;        ///< mm, centre of the ball at the end
    double radius;  ///< mm
    int axis;       ///< 0, 1 or 2: the tool axis runs along x, y or z
    double sign;    ///< 1 if the tool axis points to larger coordinates, else -1
};

/// Returns the move of a piece.
/// \return nothing if the axis turns or has another direction, or the cutter is not an
///         endless ball.
std::optional<FixedAxisBall> fixed_axis_ball(const ToolPiece& piece);

/// A whole number for each of eight rays.
using EightWhole = std::array<std::int32_t, 8>;

/// Intervals on eight rays, in units. One with from >= to is empty.
struct EightIntervals {
    alignas(32) EightWhole from;
    alignas(32) EightWhole to;
};

/// Chords of eight rays, rounded outwards to whole units and limited to the rays.
struct EightWholeChords {
    EightIntervals may;   ///< outside nothing is removed
    EightIntervals sure;  ///< removed for certain
    /// 1 on a ray that grazes the ball: its ends are not accurate, and it has no chord here.
    alignas(32) EightWhole is_grazing;
};

/// The ends of the rays through a straight line of balls. Across the rays a ray is at p from
/// the first centre, and the line of the centres moves by w there, and by a along the rays.
/// With 0 <= u <= 1 the lower end is the least value of
///
///     a u - sqrt(R^2 - |p - u w|^2),
///
/// which is convex in u. Its minimum is at u = p . w / |w|^2 - k sqrt(R^2 - e^2), limited to
/// 0 and 1, with k = a / (|w| sqrt(a^2 + |w|^2)) and the distance e of p from the line. The
/// upper end has + instead of -.
/// Source: docs/methods/removal.md, section 1, with the rays in the place of the tool axis.
struct BallLineEnds {
    double radius;                    ///< mm, R
    double start;                     ///< mm, first centre along the rays
    double way;                       ///< mm, a
    std::array<double, 2> centre;     ///< mm, first centre across the rays
    std::array<double, 2> counts;     ///< 0 if this direction does not count, else 1
    std::array<double, 2> across;     ///< mm, w
    std::array<double, 2> along;      ///< 1/mm, w / |w|^2
    std::array<double, 2> direction;  ///< w / |w|
    double share;                     ///< 1/mm, k
    double low_offset;                ///< added to u for the lower end
    double high_offset;               ///< added to u for the upper end
};

/// A fixed-axis ball on the rays of one field.
///
/// The swept volume is the line of balls and all that lies from it in the direction of the
/// tool axis. On a ray across the tool axis the end is that of the same line without its
/// heights, if the centre of the ball that attains it is not above the ray, else that of the
/// line itself: the end is the minimum of a convex function of u and of the height above the
/// line, which lies inside or on the border.
class FixedAxisBallOnField {
public:
    /// \param field_axis direction of the rays. \param stock has them.
    FixedAxisBallOnField(const FixedAxisBall& ball, int field_axis,
                         const DexelStock& stock);

    /// Whether the rays run along the tool axis.
    bool is_along_axis() const { return height_ < 0; }

    /// Which coordinate across the rays, 0 for the columns or 1 for the rows, is the height
    /// along the tool axis. \pre the rays do not run along it.
    int height() const { return height_; }

    /// A rectangle across the rays, mm in the part: columns, then rows.
    struct Rectangle {
        std::array<double, 2> low;
        std::array<double, 2> high;
    };

    /// An interval that contains all chords.
    const DexelInterval& whole_bound() const { return whole_bound_; }

    /// Returns an interval that contains all chords on the rays of a rectangle; an empty one
    /// if there are none.
    DexelInterval bound(const Rectangle& rays) const;

    /// Whether all rays of a rectangle lie above the centres along the tool axis, so that their
    /// heights do not count. No for rays along it.
    bool is_above(const Rectangle& rays) const;

    /// Finds the chords of the rays of a tile.
    /// \param columns mm, places of the rays of a row, ascending.
    /// \param rows mm, places of the rows, ascending.
    /// \param chords receives one element per row.
    void find_chords(const Eight& columns, std::span<const double> rows,
                     std::span<EightWholeChords> chords) const;

    /// Returns the chords of rays for which `is_above` holds.
    /// \param beside mm, their places in the direction that is not the height.
    EightWholeChords chords_above(const Eight& beside) const;

private:
    DexelInterval bound_of(double half) const;
    double away(std::size_t direction, double low, double high) const;
    double half_square(double away) const;

    int height_;  // -1 if the rays run along the tool axis
    double sign_;
    double radius_;                // mm
    double low_;                   // units, of the centres along the rays
    double high_;                  // units
    double per_unit_;              // units per mm, a power of two
    double units_;                 // length of the rays in units
    std::array<double, 2> least_;  // mm, of the centres across the rays
    std::array<double, 2> most_;   // mm
    DexelInterval whole_bound_;
    double rise_;  // mm, of the centre
    BallLineEnds line_;
    BallLineEnds level_;  // without heights; not used on rays along the tool axis
};

}  // namespace endmill
