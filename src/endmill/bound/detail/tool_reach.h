// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/bound/bound_problem.h"
#include "endmill/core/vec.h"

namespace endmill {

/// The tool at one place, and how far it takes material: all points within R + gamma of
/// the half-line from the centre upwards, or of the centre for the ball alone.
class ToolReach {
public:
    /// \param problem cutter, stray and tool.
    /// \param centre of the ball, mm.
    ToolReach(const BoundProblem& problem, const Vec3& centre)
        : centre_{centre},
          reach_{problem.cutter.radius() + problem.stray},
          is_upright_{problem.tool == CoveringTool::BallAndFlank}
    {
    }

    const Vec3& centre() const { return centre_; }  ///< of the ball, mm
    double reach() const { return reach_; }         ///< R + gamma, mm

    /// From the nearest point of the half-line or centre to `point`, mm.
    Vec3 from_nearest(const Vec3& point) const
    {
        Vec3 difference = point - centre_;
        if (is_upright_ && difference.z() > 0)
            difference.z() = 0;
        return difference;
    }

    /// Phi in mm: below 0 at raised points that are covered.
    double excess(const Vec3& point) const { return from_nearest(point).norm() - reach_; }

private:
    Vec3 centre_;
    double reach_;
    bool is_upright_;
};

}  // namespace endmill
