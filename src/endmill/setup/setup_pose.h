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

/// \file
/// Poses of a part on a machine, the objectives that compare them, and the modes of the search.
///
/// All objectives depend on two ranges, in rad: the width w of the window of the first rotary
/// axis (C in C,A, R1 in A,B), and the height h = m0 + m1 of the other axis. The paper's area
/// w h is not an objective, because it is 0 for every arc of a great circle, however long.
/// Source: docs/mathematics/five-axis-setup.md, section 10.

namespace endmill {

/// A pose of the part on the machine: the machine's axes in coordinates of the part, with
/// all rotary axes at zero.
struct SetupPose {
    Vec3 tool_axis;  ///< unit: C, from the part towards the spindle
    Vec3 r1_axis;    ///< unit: the rotary axis nearest to the part; C,A: the tool axis
    Vec3 r2_axis;    ///< unit: the other rotary axis
};

/// A pose and the ranges of turns that it needs. Both ranges contain 0.
struct FittedPose {
    SetupPose pose;        ///< axes in coordinates of the part
    RotaryRange phi;       ///< rad; C,A: tilt; A,B: turn of R1
    RotaryRange theta;     ///< rad; C,A: turn of C, azimuth 0 is r2 x C; A,B: turn of R2
    double area;           ///< rad^2: range of phi times range of theta, the paper's F
    std::size_t cell = 0;  ///< the cell whose centre is the tool axis; 0 if there is none
    bool is_rigid = true;  ///< false: only a mirror image of the part fits the limits
};

/// [S, L]: the smaller and the larger magnitude of the ends of a range, in rad.
/// Source: [KangSuh, eq. (10), (19)].
std::array<double, 2> magnitudes(const RotaryRange& range);

/// How many axes move in a setup.
enum class SetupStatus {
    Ok,         ///< two rotary axes move
    ThreeAxis,  ///< no rotary axis moves: one direction reaches everything, the area is 0
    FourAxis,   ///< one rotary axis moves: an arc of a great circle, the area is 0
    NoOpenHemisphere  ///< no pose has all directions within 90 degrees of its tool axis
};

/// What a search over tool axes reports. Source: [KangSuh, sections 4 to 6].
struct PoseSearchResult {
    SetupStatus status =
        SetupStatus::Ok;                 ///< of `feasible` if it is set, else of `least`
    std::optional<FittedPose> least;     ///< the best pose without limits: MAR
    std::optional<FittedPose> feasible;  ///< the best pose within the limits
    std::size_t poses_tried = 0;         ///< number of tool axes
    std::size_t poses_skipped =
        0;  ///< tool axes without a fit: directions 90 degrees off
};

/// The rotary axes of a machine, as far as a setup depends on them.
struct RotaryReach {
    MachineConfiguration configuration = {};  ///< axes of the machine
    RotaryLimits limits =
        {};  ///< turns of the tool against the part; of four axes phi counts

    /// Four axes: a cell counts if its centre lies this close to the arc of tool
    /// directions. The default is half a cell of a sphere of 1200 cells.
    Angle arc_tolerance = Angle::degrees(2.95);
};

/// Which of the axes A and B is the first rotary axis. It decides the sense of the second:
/// r2 = C x r1 if A is first, r2 = r1 x C if B is first.
enum class RotaryOrder { AFirst, BFirst };

/// The order of the rotary axes; `AFirst` outside the family A,B.
RotaryOrder rotary_order(const MachineConfiguration& configuration);

/// The axes of a machine on which the part stands in `pose`, in coordinates of the part.
/// A machine with fewer than two rotary axes counts as A,B with R2 at rest.
RotaryFrame pose_frame(const MachineConfiguration& configuration, const SetupPose& pose);

/// The limits within which a cell counts as reached in the frame of `pose_frame`. With
/// four axes theta is the arc tolerance to either side, with three axes it is 0.
RotaryLimits cell_limits(const RotaryReach& reach);

/// The quantity that a setup minimises.
enum class SetupObjective : std::uint8_t {
    FlooredArea,  ///< (w + floor)(h + floor), rad^2
    TotalRange,   ///< w + h, rad
    Tilt          ///< largest turn, rad; C,A: max(m0, m1); A,B: max(w / 2, m0, m1)
};

/// The ranges of a pose in rad, none negative.
struct PoseRanges {
    double width = 0;  ///< w, range of C (C,A) or R1 (A,B)
    double m0 = 0;     ///< C,A: largest polar angle in the window; A,B: largest latitude
    double m1 =
        0;  ///< C,A: the same opposite to the window; A,B: minus the least latitude

    double height() const { return m0 + m1; }  ///< h, rad
};

/// The ranges of a fitted pose as objectives take them.
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

    /// A width such that the objective is less than `target` only for windows narrower
    /// than it. The result is rounded up; it is not positive if no width reaches the
    /// target.
    /// \param target rad^2 or rad, in the unit of the objective.
    /// \param m0, m1 the other ranges, rad.
    double useful_width(double target, double m0, double m1) const;

    /// A height such that the objective is less than `target` only for heights below it.
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

/// What a mode tries at a given tool axis and how it compares limits. Each mode is one
/// enumerator and one row of a table of these rules.
struct SetupRules {
    SetupMode mode;                 ///< the mode that these rules describe
    std::string_view name;          ///< the word of the command line: "paper", "set", ...
    bool has_wide_sectors;          ///< C,A: C may turn by 180 degrees or more
    bool takes_hull_vertices_only;  ///< A,B: beta is taken over the hull's vertices only
    bool has_both_hulls;            ///< A,B: edges of the orthographic hull are tried too
    bool takes_low_directions;  ///< A,B: directions may be 90 degrees off the tool axis
    bool has_signed_limits;     ///< A,B: limits are compared with their signs
};

/// The rules of a mode. Those of `WholeCones` are the ones of `Corrected`.
const SetupRules& setup_rules(SetupMode mode);

/// Finds a mode by its name: "paper-literal", "paper", "corrected" or "set".
/// \return nothing if no mode has this name.
std::optional<SetupMode> setup_mode(std::string_view name);

/// Options of the fits and searches whose tool axes are given: `pose_fit` and
/// `pose_search`.
struct PoseFitOptions {
    RotaryFamily family = RotaryFamily::CA;  ///< of the machine
    SetupMode mode = SetupMode::Paper;       ///< any but `WholeCones`
    RotaryLimits limits{};                   ///< turns of the tool against the part

    RotaryOrder order = RotaryOrder::AFirst;  ///< of the family A,B

    /// Called twice for each tool axis, after its quick bound and after its fit, with the
    /// number of calls so far. Any thread may call, one at a time. An exception ends the
    /// search.
    std::function<void(std::size_t done)> progress = {};
};

/// Checks the options of a fit or search.
/// \throws DomainError if the mode is `WholeCones`, or if a range of `limits` does not
///         contain 0 or is wider than 2 pi.
void check_pose_fit_options(const PoseFitOptions& options);

}  // namespace endmill
