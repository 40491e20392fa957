// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/planning/detail/offset_bounds.h"
#include "endmill/planning/detail/pass_march.h"

namespace endmill {

/// A straight move of the ball along a pass: by the parameters and its centres in mm.
struct SweptSegment {
    double from_u;
    double to_u;
    Vec3 start;
    Vec3 end;
};

/// The straight moves of a pass, u rising; a pass of one contact is one of no length.
using SweptPass = std::vector<SweptSegment>;

/// Whether balls on straight moves leave no more material on a surface than a height h
/// along its normal: r + h N lies within R of a move's centres; a height above R counts as
/// R, at which the normal meets what the ball takes if it does at all. From bounds on the bends
/// of that offset: certain but for rounding.
class StripCover {
public:
    /// \param marched, bounds outlive this; the bounds are those of its surface.
    /// \param height h in mm.
    StripCover(const MarchedSurface& marched, const OffsetBounds& bounds,
               const BallCutter& cutter, double height);

    /// A place of the strip low <= v <= high, of all u, that no move of the passes along
    /// its borders is known to bring down to h. Not known is also what remains open below
    /// 1e-5 R, or beyond 200 000 cells in a rectangle of the bounds.
    /// \return nothing if there is none.
    std::optional<SurfacePoint> find_uncovered(Interval v, const SweptPass& below,
                                               const SweptPass& above) const;

    /// Whether the move alone brings the line v = constant beside it down to h.
    bool covers_line(const SweptSegment& move, double v) const;

private:
    const MarchedSurface* marched_;
    const OffsetBounds* bounds_;
    double radius_;
    double height_;
};

}  // namespace endmill
