// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/planner_options.h"
#include "endmill/surface/surface.h"

/// \file
/// The planner of the paper: passes along iso-parametric lines, with step lengths
/// and path intervals from circles of curvature.

namespace endmill {

/// The contact that determined the distance to the next pass.
struct GoverningPoint {
    SurfacePoint at;       ///< parameters of the contact
    SurfacePoint partner;  ///< parameters (u*, v*) of its neighbour on the next pass
};

/// A planned path.
struct IsoParametricPlan {
    ToolPath path;  ///< all passes and the links between them
    /// One entry for each pass, in order. It is empty for the last pass, for
    /// Governing::Mean, and if nothing limited the interval.
    std::vector<std::optional<GoverningPoint>> governing;
};

/// Plans passes along iso-parametric lines from one border of the surface to the other.
/// Along a pass it takes the longest steps that keep the chord tolerance; between passes
/// it takes the widest interval that keeps the scallop height.
///
/// Circles of curvature approximate the surface. The tolerances hold only with the
/// accuracy of this approximation; the planner does not check the result. Use the
/// functions of `path_error.h` to measure the error, or plan with `plan_verified`.
/// Source: [KimChoi, section 4, section 5]: eq. (1) to (3) along a pass, eq. (4) to (10)
/// across; docs/methods/economic-cl-data.md, section 10.
///
/// \param surface to machine. On a collapsed edge a pass is a single point if the normal
///        has a limit there.
/// \param cutter the ball.
/// \param options see there.
/// \throws DomainError if a tolerance, the scallop height or the axis is out of range.
/// \throws GeometryError with the place if N . axis <= 0, the surface has no normal, the
///         ball does not fit, or a pass makes no progress.
/// \throws LimitError if the path has more than `most_points` points.
IsoParametricPlan plan_iso_parametric(const Surface& surface, const BallCutter& cutter,
                                      const IsoParametricOptions& options);

/// Plans each surface separately, in the given order, and joins the paths by
/// `join_paths`. Pass numbers and governing points continue from one surface to the next.
/// \param surfaces the part; at least one.
/// \param cutter the ball.
/// \param options see there; `most_points` limits the whole path.
/// \throws DomainError, GeometryError and LimitError as for one surface.
IsoParametricPlan plan_iso_parametric(std::span<const Surface> surfaces,
                                      const BallCutter& cutter,
                                      const IsoParametricOptions& options);

/// Estimates the number of points that plan_iso_parametric returns. The estimate
/// evaluates step length and path interval at 8 by 8 places of each patch. It is right to
/// a factor of about two and takes well under a millisecond a patch.
/// \param surface to machine.
/// \param cutter the ball.
/// \param options see there.
/// \throws DomainError as plan_iso_parametric.
double estimated_points(const Surface& surface, const BallCutter& cutter,
                        const IsoParametricOptions& options);

}  // namespace endmill
