// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/gouge/detail/piece_tree.h"
#include "endmill/gouge/gouge_test.h"
#include "endmill/planning/detail/border_depth.h"

namespace endmill {

/// Of the inner tolerance: how deep moves may go along the normals of the border. The bounds
/// of a verdict are of first order there, and would leave a path planned to the limit open.
inline constexpr double border_share = 0.99;

/// Which straight moves of a ball keep an inner tolerance on a part, as a removal is
/// judged: no point of the part lies deeper in what the ball and its shank clear, and of
/// the normals at the part's border no more is taken than `border_share` of it. An immutable value, which all
/// threads may ask.
class ClearMoves {
public:
    /// \param sides from tool_side_signs, one a surface.
    /// \param axis from the tip to the spindle, unit.
    /// \param tolerance in mm, 0 < tolerance < R.
    /// \throws DomainError unless there is a surface and the tolerance is in range.
    ClearMoves(std::span<const Surface> surfaces, std::span<const double> sides,
               const BallCutter& cutter, const Vec3& axis, double tolerance)
        : gouge_{surfaces, cutter, axis},
          border_{surfaces, sides, cutter, axis, border_share * tolerance},
          tolerance_{tolerance}
    {
    }

    /// Whether `move` is known to keep it: to 2e-3 of the tolerance.
    bool hold(const BallMove& move, FinerPieces& finer) const
    {
        return gouge_.test(move, tolerance_, finer).verdict == GougeVerdict::Clear &&
               border_.is_kept(move);
    }

    const BallCutter& cutter() const { return gouge_.cutter(); }
    double tolerance() const { return tolerance_; }  ///< mm

private:
    GougeTest gouge_;
    BorderDepth border_;
    double tolerance_;
};

}  // namespace endmill
