// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/planning/linking.h"
#include "endmill/surface/largest_cutter.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// Which point of a pass decides how far the next one lies.
enum class Governing {
    Min,       ///< the one that allows least: the scallop holds at every CL point
    DenseMin,  ///< the same over 16 more samples a patch
    Mean,      ///< the mean of what the CL points allow
    First,     ///< the first one marched
    Max,       ///< the one that allows most
};

/// What happens where the next pass would lie beyond the border.
enum class LastPath {
    Border,  ///< a pass on the border
    None,    ///< no more pass
    Half,    ///< a pass on the border if at least half an interval is left
};

/// What happens where no further step fits on a pass.
enum class EndPoint {
    Force,  ///< the end of the line becomes a CL point
    Free,   ///< the pass stops at its last point
};

/// Which curvature the step length follows.
enum class StepCurvature {
    Curve,   ///< of the line as a space curve
    Normal,  ///< of the surface along the line
};

/// In which sense passes are computed, which decides where their points fall.
enum class March {
    Forward,    ///< always with the rising parameter
    Alternate,  ///< every other one from its far end
};

/// How the curvature across the feed is found.
enum class CrossCurvature {
    Exact,  ///< by the second fundamental form
    Chord,  ///< by the paper's eq. (8)
};

/// What the paper asks for and what it leaves open, with this project's defaults.
struct IsoParametricOptions {
    Parameter direction = Parameter::U;  ///< along which the passes run
    double chord_tolerance = 0.5;        ///< delta, mm
    double scallop_height = 0.5;         ///< h, mm
    Governing governing = Governing::Min;
    LastPath last_path = LastPath::Border;
    EndPoint end_point = EndPoint::Force;
    bool stop_at_borders = false;  ///< a CL point on every patch border
    StepCurvature step_curvature = StepCurvature::Curve;
    March march = March::Forward;
    CrossCurvature cross_curvature = CrossCurvature::Exact;
    double cross_step = 0.5;  ///< epsilon of eq. (7), mm; for CrossCurvature::Chord
    LinkOptions link = {};    ///< order, tool axis, safe height
    std::size_t most_points = 40'000'000;             ///< beyond it LimitError is thrown
    std::function<void(double share)> progress = {};  ///< called after each pass, if set
};

/// The place that decided the distance to the next pass.
struct GoverningPoint {
    SurfacePoint at;
    SurfacePoint partner;  ///< where the scallop height is reached: its (u*, v*)
};

/// A path and how its passes came about.
struct IsoParametricPlan {
    ToolPath path;
    /// One a pass, in order; none for the last pass, for Governing::Mean, and where
    /// nothing limited the next pass.
    std::vector<std::optional<GoverningPoint>> governing;
};

/// Plans passes along iso-parametric lines from one border of the surface to the other:
/// on each line the longest steps that keep the chord tolerance, between lines the widest
/// interval that keeps the scallop height.
/// Source: [KimChoi, section 4 and 5]: eq. (1)-(3) along a pass, eq. (4)-(10) across.
/// It holds its tolerances only as far as the paper's circles stand for the surface.
///
/// \throws DomainError if a tolerance, the scallop height or the axis is out of range.
/// \throws GeometryError, with the place, where N . axis <= 0, the surface has no normal,
/// the ball does not fit, or a pass makes no progress. A pass on a collapsed edge is one
/// point, if the normal has a limit there.
/// \throws LimitError if the path has more than `most_points` points.
IsoParametricPlan plan_iso_parametric(const Surface& surface, const BallCutter& cutter,
                                      const IsoParametricOptions& options);

/// A path over each of `surfaces` by itself, in their order, joined by `join_paths`; the
/// governing points follow each other, numbers of passes count on.
/// \throws as the above; `most_points` is that of all.
IsoParametricPlan plan_iso_parametric(std::span<const Surface> surfaces,
                                      const BallCutter& cutter,
                                      const IsoParametricOptions& options);

/// Rough number of points that plan_iso_parametric would return, within a factor of two
/// or so: from the intervals at 8 by 8 places a patch. Takes well under a millisecond a
/// patch.
double estimated_points(const Surface& surface, const BallCutter& cutter,
                        const IsoParametricOptions& options);

/// Diameters in mm of the balls to choose from, the largest first.
inline constexpr std::array<double, 8> stock_diameters{20, 15, 10, 6, 4, 3, 2, 1};

/// Whether `ball` is smaller than the largest that fits, of which there may be none.
bool fits(const BallCutter& ball, const std::optional<CutterLimit>& limit);

/// Diameter in mm of the largest ball of `stock_diameters` that fits.
/// \return nothing if none does.
std::optional<double> default_diameter(const std::optional<CutterLimit>& limit);

/// Default of the tolerances and of the scallop height of a verified plan, in mm: a common
/// requirement for a finished surface.
inline constexpr double verified_tolerance = 0.01;

/// Chord tolerance and scallop height in mm for `ball` as the paper chooses them: a
/// thirtieth of its diameter, as 0.5 mm with a ball of 15 mm in [KimChoi, fig. 12].
double default_tolerance(const BallCutter& ball);

/// Height in mm along `axis`, a unit vector, at which the cutter moves freely: 5 mm above
/// the highest point of the surfaces, to within 1e-9 of their diagonals.
double default_safe_height(std::span<const Surface> surfaces, const Vec3& axis);

}  // namespace endmill
