// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/cutter/cutter.h"
#include "endmill/gouge/detail/swept_axis.h"
#include "endmill/gouge/gouge_test.h"
#include "endmill/planning/detail/marched_surface.h"
#include "endmill/planning/detail/offset_bounds.h"
#include "endmill/surface/detail/patch_sides.h"

namespace endmill {

/// Tests whether straight moves of a ball remove material along the normals of a part's
/// border deeper than a limit. The border consists of the sides of patches that meet no
/// other side.
///
/// Beside a border the ball reaches below the part. There the depth along the normal
/// exceeds the depth that GougeTest bounds, which is R less the distance d to the centre.
/// If the direction to the centre has the angle a to the normal, the depth along the
/// normal is sqrt(R^2 - d^2 sin^2 a) - d cos a. It is greatest on the border itself:
/// where it is greatest inside the part, the centre stands upright on the part, and both
/// depths are equal. A border point r is therefore cut to less than the depth t if r lies
/// outside the region that the move clears, or if r - t N does.
/// Source: paper/notes/border-depth.md, section 1 and paper/notes/border-depth.md,
/// section 3.
///
/// The answer is certain except for rounding, because the border is divided into pieces
/// with bounded second derivatives. An immutable value that all threads may use.
class BorderDepth {
public:
    /// \param surfaces the part.
    /// \param sides  from tool_side_signs, one for each surface.
    /// \param cutter the ball, radius R.
    /// \param axis   unit, from the tip to the spindle.
    /// \param depth  t in mm, 0 < t < R.
    /// \throws DomainError if there is not one side for each surface, or t is out of
    ///         range.
    BorderDepth(std::span<const Surface> surfaces, std::span<const double> sides,
                const BallCutter& cutter, const Vec3& axis, double depth);

    /// Whether `move`, with the shank above the ball, is proved to stay within the depth
    /// along the normals of all border points. False also where the proof would need the
    /// depth to less than 2e-3 of the limit.
    bool is_kept(const BallMove& move) const;

private:
    // A chord of a curve; the curve deviates from it by at most `deviation` mm.
    struct Chord {
        Vec3 from;
        Vec3 to;
        double deviation;
    };
    // A piece of the border, and the curve at `depth_` below it along the normals.
    struct Piece {
        Chord border;
        Chord under;
    };
    // A node of a binary tree of boxes around pieces of the border. The tree is separate
    // from the PieceTree of module gouge, because its leaves are curves with a second
    // curve below them; those of PieceTree are pieces of patches.
    struct Node {
        Eigen::AlignedBox3d box;
        // For an inner node the number of its second child; the first child follows the
        // node. For a leaf ~number of its piece.
        std::int32_t link;
    };

    void add_pieces(const MarchedSurface& marched, const OffsetBounds& bounds,
                    const PatchSide& side);
    void add_nodes(std::size_t first, std::size_t end);
    bool is_kept(const Piece& piece, const SweptAxis& swept_axis) const;

    double radius_;
    Vec3 axis_;
    double depth_;
    std::vector<Piece> pieces_;
    std::vector<Node> nodes_;  // the root is first; empty if the part has no border
};

}  // namespace endmill
