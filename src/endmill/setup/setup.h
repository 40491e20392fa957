// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <numbers>
#include <optional>
#include <string>

#include "endmill/core/answer.h"
#include "endmill/machine/kinematics.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/setup/clamping.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/setup/setup_travel.h"
#include "endmill/setup/whole_cone_search.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

/// \file
/// The best setup of a part on a machine of three, four or five axes. Start here:
/// `find_setup` chooses the search that suits the machine and the mode.

namespace endmill {

/// Objective and effort of the mode `WholeCones`. All other modes minimise the area.
struct WholeConeCriteria {
    SetupObjective objective = SetupObjective::FlooredArea;  ///< what becomes least
    double floor_rad = 5.9 * std::numbers::pi / 180;         ///< of FlooredArea, above 0
    double gap = 0.05;                ///< relative gap at which the search stops, above 0
    std::size_t max_nodes = 200'000;  ///< number of nodes at which the search stops

    /// Called as WholeConeSearchOptions::progress.
    std::function<void(const WholeConeSearchProgress&)> progress = {};
};

/// The machine for which a setup is searched, and the options of the search.
struct SetupRequest {
    RotaryReach reach = {};              ///< the machine
    SetupMode mode = SetupMode::Paper;   ///< used with five axes
    WholeConeCriteria whole_cones = {};  ///< used by the mode `WholeCones` only

    /// Used by the search over cells as PoseFitOptions::nearest_cells.
    NearestCellsFinder nearest_cells = for_each_nearest_cells;

    /// Called by the search over cells as PoseFitOptions::progress, twice for each cell.
    std::function<void(std::size_t done)> cell_progress = {};
};

/// What the search over whole cones proves about the objective of a setup.
struct SetupCertificate {
    double lower_bound;      ///< no pose has a smaller objective; rad^2 or rad
    std::size_t unresolved;  ///< nodes too small to split that are not excluded
};

/// The best setup that was found, and what is proved about it.
struct PartSetup {
    /// Whether one setup within the limits reaches the whole part. A search over cells
    /// answers for the tested poses only, unless `is_proved` is true.
    Answer machinable = Answer::Undecided;
    /// Whether the answer holds for all poses, not only for the tested ones.
    bool is_proved = false;
    SetupStatus status = SetupStatus::Ok;  ///< of `shown()`
    std::optional<FittedPose> feasible;    ///< the best pose within the limits
    std::optional<FittedPose> least;       ///< the best pose without limits of the axes
    std::size_t poses_tried = 0;    ///< poses or axes tried; `WholeCones`: nodes bounded
    std::size_t poses_skipped = 0;  ///< tool axes or rotary axes without a fit

    /// Value of the minimised quantity for `shown()`: the area in rad^2, or the objective
    /// of the mode `WholeCones` in rad^2 or rad. Nothing without a pose.
    std::optional<double> objective;

    /// Set by the mode `WholeCones` with five axes, unless a facet that no cell reaches
    /// excludes every pose. It bounds the poses that compete with `shown()`: those within
    /// the limits, or all poses if none within the limits was found.
    std::optional<SetupCertificate> certificate;

    /// The pose to report: the best within the limits, or else the best without limits.
    const std::optional<FittedPose>& shown() const { return feasible ? feasible : least; }
};

/// Finds the best setup of a part on a machine.
///
/// - Five axes: `five_axis_setup`.
/// - Four axes: the shortest arc of tool directions about each of 5120 rotary axes. The
///   arc about a given axis is exact, the choice of axes is not certified.
/// - Three axes: the cell that reaches the most facets. All cells are tried, so that the
///   answer is certain.
/// - A configuration that is not valid: not machinable, without a pose.
///
/// A facet that has an area and that no cell reaches makes the part not machinable on
/// every machine. The result then describes the ranges that the other facets need.
/// Source: [KangSuh, sections 4 to 6]; docs/methods/five-axis-setup.md, sections 8
/// and 10.
/// \param grid cells of the sphere of directions.
/// \param visibility cones of the part's facets over these cells.
/// \param request machine, mode and objective.
/// \throws DomainError as `pose_search` and `whole_cone_search`; or if the arc tolerance
///         is not within 0 and 45 degrees.
PartSetup find_setup(const SphereGrid& grid, const PartVisibility& visibility,
                     const SetupRequest& request);

/// Finds the best setup on a machine of five axes for the cones of a map. Empty cones are
/// left out. The search over whole cones starts from the poses of `SetupMode::Corrected`,
/// so that its result is never worse than theirs.
/// \param grid cells of the sphere of directions. \param map cones over these cells.
/// \param request machine, mode and objective.
/// \throws DomainError as `pose_search` and `whole_cone_search`, or if the machine does
///         not have two rotary axes that tilt the tool.
PartSetup five_axis_setup(const SphereGrid& grid, const VisibilityMap& map,
                          const SetupRequest& request);

/// The floored area (w + floor)(h + floor) of the pose that a setup shows, in square
/// degrees. It serves to compare setups on different machines. w and h are the width and
/// the height of its `PoseRanges`, the ranges of the two rotary axes. h is 0 with four
/// axes; w and h are 0 with three.
/// \param setup found on a machine of this configuration.
/// \param configuration the machine. \param floor_deg degrees.
/// \return nothing if the setup shows no pose.
std::optional<double> floored_area_deg2(const PartSetup& setup,
                                        const MachineConfiguration& configuration,
                                        double floor_deg);

/// The rank of a machine for a part; the least rank is the best machine.
struct SetupRank {
    Answer machinable;  ///< whether one setup on the machine reaches the whole part
    double area_deg2;   ///< floored area of the setup, infinite without a pose
    std::string word;   ///< of the configuration

    /// Compares by `machinable` in the order Yes, Undecided, No; then by `area_deg2`; then
    /// by `word`.
    friend std::partial_ordering operator<=>(const SetupRank& a, const SetupRank& b);
    /// Whether all members are equal.
    friend bool operator==(const SetupRank&, const SetupRank&) = default;
};

/// Ranks a setup: machinable machines first, then undecided, then not machinable ones;
/// then by floored area; then by the machine's word. The travel of linear axes does not
/// count, because it changes with the clamping position.
/// \param setup found on a machine of this configuration.
/// \param configuration the machine. \param floor_deg floor of the area, degrees.
SetupRank setup_rank(const PartSetup& setup, const MachineConfiguration& configuration,
                     double floor_deg);

/// A part to set up: its facets and the directions from which each is accessible.
struct PartWithCones {
    const TriangleMesh& mesh;          ///< coordinates in mm
    const SphereGrid& grid;            ///< cells of the sphere of directions
    const PartVisibility& visibility;  ///< cones of the facets of `mesh` over these cells
};

/// How the travel of the linear axes takes part in the search for a setup.
enum class TravelRule {
    Checked,       ///< after the search, for the pose and the clamping position found
    WithinLimits,  ///< only a pose that has a clamping position within the limits is found
};

/// How the part is clamped, and the tool that machines it.
struct Clamping {
    /// mm, where the part's origin is, along the machine's axes. Nothing: the origin of
    /// the machine, or with TravelRule::WithinLimits the best position.
    std::optional<Vec3> origin = {};
    double tool_length = 0;                   ///< mm, from the spindle nose to the tip
    TravelRule travel = TravelRule::Checked;  ///< whether travel bounds the search
};

/// The best setup of a part on one machine, and whether the linear axes reach it.
struct MachineSetup {
    Machine machine;  ///< the machine of the setup
    PartSetup best;   ///< as `find_setup` found it

    /// Rotation of the part for the pose that `best` shows. Nothing without a pose.
    std::optional<Eigen::Matrix3d> part_to_machine = {};

    /// Travel of the linear axes, whether they have limits or not. Nothing if it was not
    /// computed, and nothing if a facet is out of reach (`within_travel` is then No).
    std::optional<SetupTravel> travel = {};

    Vec3 clamp{0, 0, 0};  ///< mm, clamping position of `travel`

    /// Set with TravelRule::WithinLimits, if there is a pose within the rotary limits.
    std::optional<TravelSearch> travel_search = {};

    /// Yes: the linear axes reach all facets. No: they do not, or at this pose a facet has
    /// no cell within the rotary limits. Undecided: there is no pose within the rotary
    /// limits, or no clamping.
    Answer within_travel = Answer::Undecided;

    /// Whether any linear axis has a limit. Otherwise `within_travel` decides nothing.
    bool has_linear_limits() const { return machine.linear != LinearLimits{}; }

    /// Whether the part is machinable in one setup on this machine: within the limits of
    /// the rotary axes, and not proved to be beyond those of the linear axes.
    bool is_machinable() const;
};

/// Finds the best setup of a part on a machine and the travel of its linear axes.
///
/// With TravelRule::WithinLimits on a machine with linear limits, `best.feasible` is the
/// first pose that fits the linear limits, in the order of the objective. First comes the
/// pose that `find_setup` finds, then those of `sampled_poses`. For each pose the best
/// clamping position is computed, unless one is given. If none fits, `best` stays as
/// `find_setup` found it, and `travel_search` shows the pose that comes closest.
/// \param part facets and their cones.
/// \param machine the machine. If it is not valid, the result has no pose.
/// \param request mode and objective. Of `request.reach` only the arc tolerance is used;
///        the axes and their limits are those of `machine`.
/// \param clamping nothing if the linear axes are unknown, as for a family of machines.
///        The travel is then not computed.
/// \throws DomainError as `find_setup`.
MachineSetup machine_setup(const PartWithCones& part, const Machine& machine,
                           SetupRequest request, const std::optional<Clamping>& clamping);

/// The floored area of the pose that a setup shows, in square degrees.
/// \param setup on any machine. \param floor_deg degrees.
/// \return nothing if the setup shows no pose.
std::optional<double> floored_area_deg2(const MachineSetup& setup, double floor_deg);

/// Ranks a setup as `setup_rank` does for the rotary axes alone. A setup that was searched
/// for with TravelRule::WithinLimits and not found counts as not machinable.
/// \param setup on any machine. \param floor_deg floor of the area, degrees.
SetupRank setup_rank(const MachineSetup& setup, double floor_deg);

}  // namespace endmill
