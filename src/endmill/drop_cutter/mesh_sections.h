// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
/// same way. A gap between two curves is missed if no step ends in it. Runs on all
/// threads; the result does not depend on their number.
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

}  // namespace endmill
