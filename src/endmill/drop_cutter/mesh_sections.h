// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/offset/drive_planes.h"
#include "endmill/offset/section_curve.h"

namespace endmill {

/// How finely the curves of a mesh are sampled.
struct MeshSectionOptions {
    int samples = 200;        ///< equidistant s over the extent of the mesh, at least 2
    double tolerance = 0.01;  ///< mm, by which no chord gouges more
};

/// The curves that the cutter's reference point follows in each of `planes` while the
/// cutter rests on the mesh: the trimmed curves of a mesh part. A plane's curves are in the
/// order of their s; where nothing is beneath the cutter they break.
///
/// Steps are halved until no chord gouges by more than the tolerance: until the mesh rises
/// into the moving cutter by no more, along the axis (see DropCutter::is_clear), or until
/// the step is no longer than the tolerance. Then the cutter is no farther than that from
/// where it would hang over the chord's lower end, free of the mesh, and enters no deeper.
/// The ends of curves are found to the tolerance in s likewise. A gap between two curves
/// that no step ends in, is passed over.
/// On all threads; the result does not depend on their number.
/// \return one a plane.
/// \throws DomainError if an option is out of its domain or a position not finite;
///         LimitError if a plane would take over 5 million points.
std::vector<std::vector<SectionCurve>> mesh_sections(
    const DropCutter& drop_cutter, const DrivePlanes& planes,
    const MeshSectionOptions& options = {});

}  // namespace endmill
