// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/interference/drop_cutter.h"
#include "endmill/interference/section_curve.h"

namespace endmill {

/// A vertical plane that a cutter follows: points s d + t (-d_y, d_x) over the xy plane.
struct FeedLine {
    Eigen::Vector2d direction;  ///< d, unit: of growing s
    double t;                   ///< mm, to the left of d from the z axis
};

/// How finely the curves of a mesh are sampled.
struct MeshSectionOptions {
    int samples = 200;        ///< equidistant s over the extent of the mesh, at least 2
    double tolerance = 0.01;  ///< mm, by which no chord gouges more
};

/// The curves that the cutter's reference point follows along each of `lines` while the
/// cutter rests on the mesh: the trimmed curves of a mesh part. A line's curves are in the
/// order of their s; where nothing is beneath the cutter they break.
///
/// Steps are halved until no chord gouges by more than the tolerance: until the mesh rises
/// into the moving cutter by no more, along the axis (see DropCutter::is_clear), or until
/// the step is no longer than the tolerance. Then the cutter is no farther than that from
/// where it would hang over the chord's lower end, free of the mesh, and enters no deeper.
/// The ends of curves are found to the tolerance in s likewise. A gap between two curves
/// that no step ends in, is passed over.
/// On all threads; the result does not depend on their number.
/// \throws DomainError if an option is out of its domain or a line not finite and unit;
///         LimitError if a line would take over 5 million points.
std::vector<std::vector<SectionCurve>> mesh_sections(
    const DropCutter& drop_cutter, std::span<const FeedLine> lines,
    const MeshSectionOptions& options = {});

}  // namespace endmill
