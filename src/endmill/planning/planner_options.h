// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/planning/linking.h"
#include "endmill/surface/largest_cutter.h"
#include "endmill/surface/surface.h"

/// \file
/// The options of the two planners, and functions that choose default values.

namespace endmill {

/// The two planners.
enum class Planner {
    Paper,     ///< plan_iso_parametric: as published, misprints corrected
    Verified,  ///< plan_verified: proves that the moves keep their tolerances
};

/// What the planner does where a pass crosses a border between patches.
enum class PatchBorders {
    Cross,  ///< steps cross the border
    Stop,   ///< puts a CL point on the border
};

/// The contacts of a pass that determine the next pass. Each contact gives a candidate
/// for the parameter of the next pass.
enum class Governing {
    Min,       ///< the smallest candidate: the scallop height holds at every CL point
    DenseMin,  ///< the smallest candidate of the CL points and of 17 more places a patch
    Mean,      ///< the mean of the candidates of the CL points
    First,     ///< the candidate of the first CL point that has one
    Max,       ///< the largest candidate of the CL points
};

/// The last pass, if the next one would lie beyond the border.
enum class LastPath {
    Border,  ///< a pass on the border is added
    None,    ///< no further pass is added
    Half,    ///< as Border if at least half an interval remains, else as None
};

/// The end of a pass, if no further step fits on it.
enum class EndPoint {
    Force,  ///< the end of the pass becomes a CL point
    Free,   ///< the pass ends at its last CL point
};

/// The curvature that determines the step length.
enum class StepCurvature {
    Curve,   ///< curvature of the pass as a space curve
    Normal,  ///< normal curvature of the surface along the pass
};

/// The direction in which the CL points of a pass are computed. The places of the points
/// depend on it.
enum class March {
    Forward,    ///< every pass with rising parameter
    Alternate,  ///< every second pass from the other end
};

/// The computation of the curvature across the feed.
enum class CrossCurvature {
    Exact,  ///< from the second fundamental form
    Chord,  ///< from a chord, eq. (8) of the paper
};

/// Options of plan_iso_parametric. The paper leaves some choices open; each of them is an
/// enum here. Source: docs/methods/economic-cl-data.md, section 7, with the reasons
/// for the defaults.
struct IsoParametricOptions {
    Parameter direction = Parameter::U;     ///< the parameter that varies along a pass
    double chord_tolerance = 0.5;           ///< delta, mm
    double scallop_height = 0.5;            ///< h, mm
    Governing governing = Governing::Min;   ///< contact that sets the path interval
    LastPath last_path = LastPath::Border;  ///< end of the sequence of passes
    EndPoint end_point = EndPoint::Force;   ///< end of a pass
    PatchBorders patch_borders = PatchBorders::Cross;  ///< steps at borders of patches
    /// Curvature in the formula of the step length.
    StepCurvature step_curvature = StepCurvature::Curve;
    March march = March::Forward;  ///< direction in which a pass is computed
    /// Curvature in the formula of the path interval.
    CrossCurvature cross_curvature = CrossCurvature::Exact;
    double cross_step = 0.5;  ///< epsilon of eq. (7), mm; for CrossCurvature::Chord
    LinkOptions link = {};    ///< order of the passes, tool axis, safe height
    std::size_t most_points = 40'000'000;  ///< a longer path throws LimitError
    /// If set, it is called after each pass with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// Limits of the error of a ball's straight moves. One of them may be 0: the line of a
/// pass then deviates from the swept volume to one side only.
struct MotionTolerances {
    double inner;  ///< mm; greatest gouge depth, anywhere on the part
    double outer;  ///< mm along the normal; largest remaining stock along a pass

    /// Whether exactly one of the tolerances is 0.
    bool is_one_sided() const { return (inner == 0) != (outer == 0); }
};

/// Default tolerance and scallop height in mm of a verified plan: a usual requirement on
/// a finished surface.
inline constexpr double verified_tolerance = 0.01;

/// Options of plan_verified.
struct VerifiedOptions {
    Parameter direction = Parameter::U;  ///< the parameter that varies along a pass
    /// Limits of the moves along a pass; one of them may be 0.
    MotionTolerances tolerances{verified_tolerance, verified_tolerance};
    double scallop_height = verified_tolerance;        ///< h between passes, mm
    PatchBorders patch_borders = PatchBorders::Cross;  ///< steps at borders of patches
    LinkOptions link = {};  ///< order of the passes, tool axis, safe height
    std::size_t most_points = 40'000'000;  ///< a longer path throws LimitError
    /// If set, it is called with the finished share, 0 to 1, by any thread. A share may be
    /// less than one that another thread has reported.
    std::function<void(double share)> progress = {};
};

/// Diameters in mm of the balls from which default_diameter chooses, in falling order.
inline constexpr std::array<double, 8> stock_diameters{20, 15, 10, 6, 4, 3, 2, 1};

/// Whether the radius of `ball` is below `limit`. Every ball fits if there is no limit.
bool fits(const BallCutter& ball, const std::optional<CutterLimit>& limit);

/// Diameter in mm of the largest ball of `stock_diameters` that fits.
/// \return nothing if none fits.
std::optional<double> default_diameter(const std::optional<CutterLimit>& limit);

/// Chooses the diameter of the ball in mm.
/// \param requested a diameter; default_diameter chooses if there is none.
/// \param limit     of the surface.
/// \return nothing if the requested ball does not fit, or no standard ball.
std::optional<double> fitting_diameter(const std::optional<double>& requested,
                                       const std::optional<CutterLimit>& limit);

/// Default chord tolerance and scallop height in mm of an iso-parametric plan for `ball`:
/// a thirtieth of the diameter. The paper uses 0.5 mm with a ball of 15 mm.
/// Source: [KimChoi, fig. 12].
double default_tolerance(const BallCutter& ball);

/// The tolerances that a user states. Those that are missing have defaults.
struct RequestedTolerances {
    std::optional<double> chord = {};           ///< mm
    std::optional<double> scallop_height = {};  ///< mm
    std::optional<double> inner = {};           ///< mm; see MotionTolerances
    std::optional<double> outer = {};           ///< mm; see MotionTolerances
};

/// The tolerances of a plan.
struct PlanTolerances {
    double chord;           ///< mm
    double scallop_height;  ///< mm
    MotionTolerances
        motion;  ///< the verified planner keeps them; both planners are judged by them
};

/// Completes the requested tolerances. The default chord tolerance is
/// `verified_tolerance`, or default_tolerance for Planner::Paper. Each other default is
/// the chord tolerance.
/// \param requested the tolerances of the user.
/// \param planner   the planner that will use them.
/// \param ball      the cutter.
PlanTolerances plan_tolerances(const RequestedTolerances& requested, Planner planner,
                               const BallCutter& ball);

/// Default height of the tip in mm along `axis` for rapid moves: 5 mm above the highest
/// point of the surfaces.
/// \param surfaces the part; at least one.
/// \param axis unit, from the tip to the spindle.
///
/// The error is below 1e-9 of the surfaces' diagonals.
double default_safe_height(std::span<const Surface> surfaces, const Vec3& axis);

}  // namespace endmill
