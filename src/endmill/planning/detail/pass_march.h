// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "endmill/planning/iso_parametric.h"

namespace endmill {

/// A surface to march along u on, and the sign of its normals. Marching along v, or
/// backwards, is marching along u on the surface transposed or reversed.
struct MarchedSurface {
    Surface surface;
    double side;  ///< from tool_side_sign
};

/// The next pass as one place of this pass allows it.
struct PassCandidate {
    /// Its parameter; infinite where the place does not limit it.
    double v = std::numeric_limits<double>::infinity();
    SurfacePoint at{};       ///< the place
    SurfacePoint partner{};  ///< its (u*, v*)
};

/// A pass, its contacts with rising u, and what it allows.
struct MarchedPass {
    Pass contacts;
    std::optional<PassCandidate> next;  ///< none on the last pass
};

/// Computes the pass along u at `v`: the longest steps that keep the chord tolerance,
/// and from its points, by the rule `options.governing`, where the next pass lies. A
/// pass on a collapsed edge is one contact, if its normals have one limit.
/// Source: [KimChoi, eq. (1)-(10)].
/// \throws GeometryError, with the place, where the ball does not fit, the surface has
/// no normal, or a step makes no progress.
MarchedPass march_pass(const MarchedSurface& marched, double v, bool is_last,
                       const BallCutter& cutter, const IsoParametricOptions& options);

/// `at` with its parameters in the order of the surface that is planned on.
SurfacePoint in_surface_order(const SurfacePoint& at, Parameter direction);

/// In widths of a patch: a point so near the end of a pass, and a pass so near the
/// border, stand there.
/// Source: the project's reading of [KimChoi, section 4].
inline constexpr double end_width = 1e-6;

}  // namespace endmill
