// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/offset/section_curve.h"

namespace endmill {

/// The sampling of the curves of a mesh part.
struct MeshSectionOptions {
    /// Number of equidistant s over the extent of the mesh, at least 2.
    int samples = 200;
    double tolerance = 0.01;  ///< mm, largest gouge of a chord
    /// mm; a chord lies at most this high above the curve. Infinite: not bounded.
    double outer_tolerance = std::numeric_limits<double>::infinity();
    /// Whether curves go on beyond the extent of the mesh as long as the contact moves towards
    /// the border. Otherwise the foot of a slope at the border is not touched. The tip may
    /// then be below the lowest point of the mesh. mesh_passes adds planes beyond the
    /// extent across the feed for the same reason.
    bool beyond_borders = false;
    /// If set, it is called with the finished share, 0 to 1, by any thread.
    std::function<void(double share)> progress = {};
};

/// The curves that the cutter's reference point follows in each of `planes` while the
/// cutter rests on the mesh. They are the trimmed curves of a mesh part. The curves of a
/// plane are ordered by s. A curve ends where no point of the mesh is below the cutter.
///
/// A step is halved until its chord gouges by at most the tolerance, according to
/// DropCutter::is_clear, or until the step is not longer than the tolerance. In the
/// second case the distance of the cutter from its position over the lower end of the
/// chord is at most the tolerance. It does not gouge there, so that the gouge is not
/// deeper than the tolerance. The ends of curves are found to the tolerance in s in the
/// same way. A gap between two curves is missed if no step ends in it. With an outer
/// tolerance a step is also halved until its chord lies at most this high above the curve;
/// the contacts at its two ends give a bound. Runs on all threads; the result does not depend
/// on their number.
/// Source: docs/methods/interference.md, section 6 (R3).
/// \param drop_cutter the mesh and the cutter.
/// \param planes the planes.
/// \param options the sampling.
/// \return one list of curves for each plane.
/// \throws DomainError if an option is outside its domain or a position of a plane is not
///     finite.
/// \throws LimitError if a plane would take more than 5 million points.
std::vector<std::vector<SectionCurve>> mesh_sections(
    const DropCutter& drop_cutter, const DrivePlanes& planes,
    const MeshSectionOptions& options = {});

/// The scallop height that passes in drive planes keep, on slopes and beside walls too.
struct ScallopLimit {
    double height;  ///< mm along the normal of the part, > 0
    /// mm, > 0: the pitch of the planes that leaves this height on level ground, see
    /// level_path_interval.
    double level_interval;
    double allowance = 0;  ///< mm by which the given cutter is larger than the real one
};

/// Drive planes, and the curves in each of them.
struct MeshPasses {
    DrivePlanes planes;                             ///< given and added ones, ascending
    std::vector<std::vector<SectionCurve>> curves;  ///< one list for each plane
    std::size_t added_planes = 0;                   ///< number of planes that were added
};

/// mesh_sections with planes added where the part is steep across the feed, so that the
/// scallop height holds there too. An added plane has curves only where they are needed.
///
/// In the middle of two neighbouring planes the cutter is dropped at samples along s. The
/// limit holds at a sample under four conditions:
/// 1. The point at the scallop height above the contact is inside the cutter at a place in
///    one of the two planes.
/// 2. The cutter's places at s in both planes are at most the level interval apart; on a slope
///    at most as far as the corner radius allows.
/// 3. If a wall across the feed is near, the planes are so near to each other that the shank
///    leaves the height on it.
/// 4. If the contact jumps between the planes, because the cutter touches both sides of an inner
///    corner, condition 1 also holds beside the jump.
///
/// It also holds where the planes are at most the scallop height apart: the lower place of the
/// cutter, which is open above, leaves at most this distance on any wall between them.
/// Elsewhere a plane is added in the middle or at the jump, and both parts are examined again.
/// The strips between the outermost planes and the borders of the mesh are treated in the same
/// way.
/// Source: docs/methods/interference.md, section 6 (R3).
/// \param drop_cutter, planes, options as for mesh_sections; the planes are ascending.
/// \param limit the scallop height.
/// \throws DomainError, LimitError as mesh_sections, if a number of the limit is outside its
///     domain, and if over a million planes would be needed.
MeshPasses mesh_passes(const DropCutter& drop_cutter, const DrivePlanes& planes,
                       const ScallopLimit& limit, const MeshSectionOptions& options = {});

}  // namespace endmill
