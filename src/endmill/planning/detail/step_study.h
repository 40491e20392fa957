// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The cutter, the chord tolerance and the direction that a path was planned for.
struct PassSettings {
    BallCutter ball;
    double tolerance;  ///< mm
    Parameter direction;
};

/// Errors of one straight step of a pass, in mm.
struct StepErrors {
    double chord;  ///< largest distance of the contact curve from its chord
    /// Largest depth of the contact curve inside the volume the ball sweeps.
    double gouge;
};

/// Errors of each cutting move of `path`, in order.
/// \pre the path was planned over `surface` with `settings`.
std::vector<StepErrors> step_errors(const Surface& surface, const ToolPath& path,
                                    const PassSettings& settings);

/// A copy of `path` in which each cutting move is replaced by `pieces` moves between
/// contacts on the surface. For many pieces the ball rolls along the contact curve.
ToolPath rolled_path(const Surface& surface, const ToolPath& path, const BallCutter& ball,
                     int pieces);

/// Number of CL points that `verified_pass` places on the passes of `path`, for the
/// tolerance of `settings` as chord and as motion tolerance.
std::size_t verified_points(const Surface& surface, const ToolPath& path,
                            const PassSettings& settings);

/// The curves of a step that must stay within the tolerance of their chords.
enum class LimitedCurves {
    Contacts,            ///< the contact curve
    ContactsAndCentres,  ///< the contact curve and the curve of ball centres
};

/// The greatest length of a step.
enum class LongestStep {
    ToEnd,  ///< to the end of the pass
    Paper,  ///< the paper's step for the curvature at its start
};

/// Conditions on the steps of `greedy_points`.
struct StepRule {
    LimitedCurves limited = LimitedCurves::Contacts;  ///< curves that are tested
    LongestStep longest = LongestStep::ToEnd;         ///< greatest length
};

/// Number of CL points of the longest steps that satisfy `rule` on the passes of `path`.
/// Each pass is sampled at 4097 points; steps end at samples.
std::size_t greedy_points(const Surface& surface, const ToolPath& path,
                          const PassSettings& settings, const StepRule& rule);

}  // namespace endmill
