// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/kinematics.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/setup/setup_pose.h"
#include "endmill/visibility/visibility.h"

/// \file
/// The clamping position of a part at which the linear axes keep the greatest distance
/// from their limits, and the first of several poses that they reach.
/// Source: docs/methods/five-axis-setup.md, section 10.

namespace endmill {

/// Distance in mm by which a position may pass a linear limit and still count as within.
/// It covers the rounding of coordinates of metres; no axis is positioned so finely.
inline constexpr double travel_rounding = 1e-6;

/// A clamping position and the travel that it leaves unused.
struct ClampingFit {
    Vec3 clamp;  ///< mm, where the part's origin is, along the machine's axes
    /// mm, least distance of X, Y, Z from their limits. Below 0: a position exceeds a
    /// limit by as much. Infinite for an axis without limits.
    Vec3 slack;

    double least_slack() const { return slack.minCoeff(); }  ///< mm
    /// Whether the linear axes reach the whole part, to `travel_rounding`.
    bool is_within() const { return least_slack() >= -travel_rounding; }
};

/// A bound on the clamping position s of one axis at one rotation of the table: the axis
/// stays within its limits where low <= direction . s <= high.
struct ClampingBound {
    int axis;        ///< 0 to 2: X, Y, Z
    Vec3 direction;  ///< unit
    double low;      ///< mm; may be -infinity
    double high;     ///< mm; may be infinity
};

/// Finds clamping positions for poses of one part on one machine. With the rotary axes at
/// rest the positions of X, Y and Z move by G s if the part moves by s, with the rotation
/// G of the table. The limits are therefore linear in s, and the best clamping is the
/// solution of a small linear program.
///
/// Each facet is reached from the direction that `facet_reach` chooses. Facets with equal
/// visibility cones are reached from the same direction at every pose. Only the vertices
/// of the convex hull of their centroids decide the travel there. An immutable value that
/// all threads may use.
class ClampingSearch {
public:
    /// \param part the mesh that `visibility` belongs to.
    /// \param visibility cones of its facets.
    /// \param centres unit, one for each cell; must outlive this.
    /// \param machine valid.
    /// \param limits of the rotations, from `reach_limits`.
    /// \param tool_length mm, from the spindle nose to the tip.
    ClampingSearch(const TriangleMesh& part, const PartVisibility& visibility,
                   std::span<const Vec3> centres, const Machine& machine,
                   const RotaryLimits& limits, double tool_length);

    /// The bounds on the clamping position at a pose.
    /// \return nothing if a facet is not reached within the rotary limits, or if there is
    ///         none to reach.
    std::optional<std::vector<ClampingBound>> bounds(const SetupPose& pose) const;

private:
    std::span<const Vec3> centres_;
    Machine machine_;
    RotaryLimits limits_;
    double tool_length_;
    VisibilityMap cones_;                   // one facet for each different cone
    std::vector<std::vector<Vec3>> hulls_;  // of the centroids of each cone, mm
};

/// The bounds on the clamping position that known positions of a machine set.
/// \param machine   its linear limits are used.
/// \param positions of all axes, for a part whose origin is clamped at 0, 0, 0.
std::vector<ClampingBound> clamping_bounds(const Machine& machine,
                                           std::span<const AxisPositions> positions);

/// The slack of a given clamping position.
ClampingFit clamping_fit(std::span<const ClampingBound> bounds, const Vec3& clamp);

/// The greatest least slack over all axes and clamping positions, in mm. Infinite without
/// bounds.
double greatest_slack(std::span<const ClampingBound> bounds);

/// The best clamping position. The least slack over all axes is as large as possible,
/// then that of the other axes in turn. Of equally good positions the one nearest to
/// `wanted` is chosen, by the sum of its coordinate differences. The slacks are exact to
/// 1e-6 mm.
/// \param bounds from `ClampingSearch`.
/// \param wanted mm; decides along directions without limits.
ClampingFit best_clamping(std::span<const ClampingBound> bounds, const Vec3& wanted);

/// The search for a pose whose travel lies within the limits of the linear axes.
struct TravelSearch {
    std::size_t poses = 0;  ///< number of poses examined
    /// Of these, poses at which a facet has no direction within the rotary limits.
    std::size_t out_of_reach = 0;
    /// The pose found. If no pose fits, the one that exceeds the limits by the least.
    std::optional<FittedPose> pose = {};
    std::optional<ClampingFit> clamping = {};  ///< of `pose`; nothing without a pose

    bool fits() const { return clamping && clamping->is_within(); }  ///< a pose was found
};

/// Finds the first pose that fits the limits of the linear axes. Without one it finds the
/// pose that exceeds them by the least. Poses are examined in parallel; the result does
/// not depend on the number of threads.
/// \param search for the part and the machine.
/// \param poses  in the order of preference.
/// \param clamp  mm, the clamping position; nothing: the best one of each pose.
TravelSearch travel_search(const ClampingSearch& search,
                           std::span<const FittedPose> poses,
                           const std::optional<Vec3>& clamp);

}  // namespace endmill
