// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/cutter/cutter.h"
#include "endmill/strategy/strategy_options.h"
#include "endmill/surface/part.h"

namespace endmill {

/// Plans passes of any cutter in parallel upright planes. The cutter is dropped on a mesh of
/// the part; planes are added where the scallop height asks for it. Straight links at feed
/// join passes where they are clear of the mesh. Points of the path have no contacts. Planes are
/// placed by samples, so that the path should be judged.
///
/// Without a direction, every 5 degrees is tried with coarse curves, and the direction whose
/// passes are shortest by tips is taken. The result is the same on any number of threads.
/// Source: docs/methods/planar-passes.md, section 3; docs/methods/interference.md, section 6
/// (R3).
/// \param part    surfaces or a mesh.
/// \param cutter  held along +z.
/// \param options height, tolerance, direction, links and progress.
/// \throws GeometryError if the part rises above the safe height of a lift.
/// \throws LimitError if the path has more than options.most_points points, or as
///         mesh_passes and sampled do.
CoveringPath dropped_path(const Part& part, const Cutter& cutter,
                          const StrategyOptions& options);

}  // namespace endmill
