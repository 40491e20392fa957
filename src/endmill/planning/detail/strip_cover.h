// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/planning/detail/marched_surface.h"
#include "endmill/planning/detail/offset_bounds.h"

namespace endmill {

/// A straight move of the ball along a pass.
struct SweptSegment {
    double from_u;  ///< parameter of the first contact
    double to_u;    ///< parameter of the last contact
    Vec3 start;     ///< first centre of the ball, mm
    Vec3 end;       ///< last centre of the ball, mm
};

/// The straight moves of a pass, u rising. A pass of one contact is one move without
/// length.
using SweptPass = std::vector<SweptSegment>;

/// Tests whether balls on straight moves leave at most a height h of material on a
/// surface, measured along its normal.
///
/// A surface point r is covered if r + h N lies within R of the centres of some move. A
/// height above R counts as R, because a normal that meets the swept volume at all meets
/// it at R or below. The test uses bounds on the second derivatives of the offset and is
/// certain except for rounding.
class StripCover {
public:
    /// \param marched the surface; must outlive this.
    /// \param bounds  of that surface; must outlive this.
    /// \param cutter  the ball, radius R.
    /// \param height  h in mm.
    StripCover(const MarchedSurface& marched, const OffsetBounds& bounds,
               const BallCutter& cutter, double height);

    /// Searches the strip low <= v <= high for a place that is not proved to be covered
    /// by a move of the passes on its borders. The proof is given up for cells below 1e-5
    /// R, and after 200 000 cells in one rectangle of the bounds.
    /// \param v     the strip.
    /// \param below moves of the pass at v.low; may be empty.
    /// \param above moves of the pass at v.high; may be empty.
    /// \return nothing if the whole strip is covered.
    std::optional<SurfacePoint> find_uncovered(Interval v, const SweptPass& below,
                                               const SweptPass& above) const;

    /// Whether `move` alone is proved to cover the line at constant v beside it.
    bool covers_line(const SweptSegment& move, double v) const;

private:
    const MarchedSurface* marched_;
    const OffsetBounds* bounds_;
    double radius_;
    double height_;
};

}  // namespace endmill
