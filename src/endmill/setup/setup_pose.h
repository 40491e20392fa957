// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <string_view>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"
#include "endmill/machine/kinematics.h"
#include "endmill/visibility/visibility.h"

/// \file
/// Poses of a part on a machine, objectives that compare them, and modes of the search.
///
/// A pose is the position of the part on the machine. It needs a range of rotation of
/// each rotary axis. The window is the range of the first rotary axis (C in C,A, R1 in
/// A,B), and w is its width. h = m0 + m1 is the range of the other axis. C,A: m0 is the
/// largest polar angle of the directions whose azimuths lie in the window, m1 that of the
/// directions opposite to the window. A,B: m0 is the largest latitude, -m1 the least. All
/// are in rad.
///
/// All objectives depend on w and h. The paper's area w h is not an objective, because it
/// is 0 for every arc of a great circle, of any length.
/// Source: docs/methods/five-axis-setup.md, section 10.

namespace endmill {

/// A pose of the part on the machine: the machine's axes in coordinates of the part, with
/// all rotary axes at zero.
struct SetupPose {
    Vec3 tool_axis;  ///< unit: C, from the part towards the spindle
    Vec3 r1_axis;    ///< unit: the rotary axis nearest to the part; C,A: the tool axis
    Vec3 r2_axis;    ///< unit: the other rotary axis
};

/// A pose and the ranges of the rotary axes that it needs. Both ranges contain 0. They
/// are rotations of the tool against the part.
struct FittedPose {
    SetupPose pose;   ///< axes in coordinates of the part
    RotaryRange phi;  ///< rad; C,A: tilt; A,B: rotation of R1
    /// rad; C,A: rotation of C, where r2 x C has azimuth 0; A,B: rotation of R2.
    RotaryRange theta;
    double area;           ///< rad^2: range of phi times range of theta, the paper's F
    std::size_t cell = 0;  ///< the cell whose centre is the tool axis; 0 if there is none
    /// False: the pose fits the limits only with a reflection, which no rotation of the
    /// part realises.
    bool is_rigid = true;
};

/// [S, L]: the smaller and the larger magnitude of the ends of a range, in rad.
/// Source: [KangSuh, eq. (10), (19)].
std::array<double, 2> magnitudes(const RotaryRange& range);

/// The number of axes that move in a setup.
enum class SetupStatus {
    Ok,         ///< two rotary axes move
    ThreeAxis,  ///< no rotary axis moves: one direction reaches everything, the area is 0
    FourAxis,   ///< one rotary axis moves: an arc of a great circle, the area is 0
    NoOpenHemisphere  ///< no pose has all directions within 90 degrees of its tool axis
};

/// The result of a search over tool axes. Source: [KangSuh, sections 4 to 6].
struct PoseSearchResult {
    /// Status of `feasible` if it is set, otherwise of `least`.
    SetupStatus status = SetupStatus::Ok;
    /// The pose of least area without limits of the axes, MAR in [KangSuh].
    std::optional<FittedPose> least;
    std::optional<FittedPose> feasible;  ///< the best pose within the limits
    std::size_t poses_tried = 0;         ///< number of tool axes
    /// Number of tool axes skipped because a direction lies 90 degrees or more from them
    /// (A,B in the paper's modes).
    std::size_t poses_skipped = 0;
};

/// The data of a machine on which a setup depends: its rotary axes and their limits.
struct RotaryReach {
    MachineConfiguration configuration = {};  ///< axes of the machine
    /// Limits, as rotations of the tool against the part. On a four-axis machine only phi
    /// is used.
    RotaryLimits limits = {};

    /// Four axes: a cell counts as reached if its centre lies within this angle of the
    /// arc of tool directions. The default is half a cell of a sphere of 1200 cells.
    Angle arc_tolerance = Angle::degrees(2.95);
};

/// The first rotary axis of the family A,B. It determines the sense of the second one: r2
/// = C x r1 if A is first, r2 = r1 x C if B is first.
enum class RotaryOrder { AFirst, BFirst };

/// The order of the rotary axes; `AFirst` outside the family A,B.
RotaryOrder rotary_order(const MachineConfiguration& configuration);

/// The axes of a machine on which the part stands in `pose`, in coordinates of the part.
/// A machine with fewer than two rotary axes counts as A,B with R2 at rest.
RotaryFrame pose_frame(const MachineConfiguration& configuration, const SetupPose& pose);

/// The limits within which a cell counts as reached, for the frame of `pose_frame`. With
/// four axes theta is +- the arc tolerance, with three axes it is 0.
RotaryLimits reach_limits(const RotaryReach& reach);

/// The quantity that a setup minimises.
enum class SetupObjective : std::uint8_t {
    FlooredArea,  ///< (w + floor)(h + floor), rad^2
    TotalRange,   ///< w + h, rad
    Tilt          ///< largest rotation, rad; C,A: max(m0, m1); A,B: max(w / 2, m0, m1)
};

/// The ranges of a pose in rad, none negative.
struct PoseRanges {
    double width = 0;  ///< w, range of C (C,A) or R1 (A,B)
    /// C,A: largest polar angle of the directions in the window; A,B: largest latitude.
    double m0 = 0;
    /// C,A: largest polar angle opposite to the window; A,B: minus the least latitude.
    double m1 = 0;

    double height() const { return m0 + m1; }  ///< h, rad
};

/// The ranges w, m0 and m1 of a fitted pose.
/// \param family decides which of phi and theta is the window. \param fit any pose.
PoseRanges pose_ranges(RotaryFamily family, const FittedPose& fit);

/// Evaluates an objective. The value does not decrease when a range grows.
struct PoseMeasure {
    RotaryFamily family = RotaryFamily::CA;                  ///< of the machine
    SetupObjective objective = SetupObjective::FlooredArea;  ///< what to evaluate
    double floor_rad = 5.9 * std::numbers::pi / 180;  ///< floor of FlooredArea, above 0

    /// The objective of these ranges: rad^2 for FlooredArea, else rad. Relative error
    /// below 1e-15.
    double operator()(const PoseRanges& ranges) const;

    /// Upper bound of the width of the window: if the objective is below `target`, the
    /// width is below this value. It is not positive if no width makes the objective
    /// smaller than `target`. Rounded up.
    /// \param target rad^2 or rad, in the unit of the objective.
    /// \param m0, m1 the other ranges, rad.
    double useful_width(double target, double m0, double m1) const;

    /// Upper bound of the height: if the objective is below `target`, the height is below
    /// this value. Rounded up.
    /// \param target rad^2 or rad. \param width of the window, rad.
    /// \pre the objective is not Tilt, which is not a function of the height.
    double useful_height(double target, double width) const;
};

/// The algorithm that finds a setup, from the weakest to the strongest.
enum class SetupMode {
    PaperLiteral,  ///< nearest cells, as printed
    Paper,         ///< nearest cells, as printed without the misprints
    Corrected,     ///< nearest cells, exact for these cells and a given tool axis
    WholeCones     ///< all cells of each cone and all poses, with a certified lower bound
};

/// Finds a mode by its name: "paper-literal", "paper", "corrected" or "set".
/// \return nothing if no mode has this name.
std::optional<SetupMode> setup_mode(std::string_view name);

/// Options of the fits and searches whose tool axes are given: `pose_fit` and
/// `pose_search`.
struct PoseFitOptions {
    RotaryFamily family = RotaryFamily::CA;  ///< of the machine
    SetupMode mode = SetupMode::Paper;       ///< any but `WholeCones`
    RotaryLimits limits{};                   ///< rotations of the tool against the part

    RotaryOrder order = RotaryOrder::AFirst;  ///< of the family A,B

    /// Used by searches. The result is the same for every such function.
    NearestCellsFinder nearest_cells = for_each_nearest_cells;

    /// If set, it is called twice for each tool axis, after its quick bound and after its fit, with the
    /// number of calls so far. Any thread may call, one at a time. An exception ends the
    /// search.
    std::function<void(std::size_t done)> progress = {};
};

/// Checks the options of a fit or search.
/// \throws DomainError if the mode is `WholeCones`, or if a range of `limits` does not
///         contain 0 or is wider than 2 pi.
void check_pose_fit_options(const PoseFitOptions& options);

}  // namespace endmill
