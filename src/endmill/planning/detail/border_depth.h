// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/cutter/cutter.h"
#include "endmill/gouge/detail/swept_axis.h"
#include "endmill/gouge/gouge_test.h"
#include "endmill/planning/detail/offset_bounds.h"
#include "endmill/planning/detail/pass_march.h"
#include "endmill/surface/detail/patch_sides.h"

namespace endmill {

/// Whether a ball's straight moves take away more than a depth along the normals of a
/// part's border: where its surfaces end and meet no other.
///
/// Beyond a border the ball reaches under the part, and what it takes there along the
/// normal is more than any point of the part is deep in it, which is all that GougeTest
/// knows: for a border point at the distance d from the centre, the way to it leaning by an
/// angle a from the normal, sqrt(R^2 - d^2 sin^2 a) - d cos a. It is greatest on the border
/// itself: anywhere else its greatest value stands upright on the part, and there both are
/// the same. So a border point r is under no gouge if it lies outside what the move clears,
/// or r less the depth along N does. Derived in paper/notes/border-depth.md.
///
/// Certain but for rounding: the border is cut into pieces whose bends are bounded. An
/// immutable value, which all threads may ask.
class BorderDepth {
public:
    /// \param sides from tool_side_signs, one a surface.
    /// \param axis from the tip to the spindle, unit.
    /// \param depth in mm, 0 < depth < R.
    BorderDepth(std::span<const Surface> surfaces, std::span<const double> sides,
                const BallCutter& cutter, const Vec3& axis, double depth);

    /// Whether `move` and the shank above it take away no more than the depth along the
    /// normal of any border point. No also where that could not be shown to 2e-3 of the
    /// depth.
    bool is_kept(const BallMove& move) const;

private:
    // A piece of the border by a chord, and by that of the curve `depth` under it; `stray`
    // mm is how far the curves may lie from them.
    struct Chord {
        Vec3 from;
        Vec3 to;
        double stray;
    };
    struct Piece {
        Chord border;
        Chord under;
    };
    // A box around the border below it: two children, or a piece.
    struct Node {
        Eigen::AlignedBox3d box;
        std::int32_t link;  // the second child, the first is the next node; or ~piece
    };

    void add_pieces(const MarchedSurface& marched, const OffsetBounds& bounds,
                    const PatchSide& side);
    void add_nodes(std::size_t first, std::size_t end);
    bool is_kept(const Piece& piece, const SweptAxis& swept_axis) const;

    double radius_;
    Vec3 axis_;
    double depth_;
    std::vector<Piece> pieces_;
    std::vector<Node> nodes_;  // the root first; none without a border
};

}  // namespace endmill
