// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "endmill/machine/configuration.h"
#include "endmill/machine/feasible_directions.h"
#include "support/named_cells.h"

namespace endmill {

/// Columns of `motion_cells`.
std::vector<std::string> motion_columns();

/// Measures of a feasible tool motion:
/// - solid_angle_sr; edges, the curves of its border; length_deg, their length together;
///   with four axes length_off_deg, the difference of this length from the rotary range;
/// - great_edges, those in a plane through the centre of the sphere; parallel_edges, those
///   at a constant angle other than 90 degrees from R1;
/// - off_great_circle, the largest distance of a border curve from a plane through the
///   centre, root mean square over its points;
/// - r1_tool_deg, r2_tool_deg: angles of the rotary axes with the tool axis at zero, with
///   five axes;
/// - shape: point or arc; disc if a direction belongs to the set exactly if its angle with
///   the tool axis is small enough; band if exactly its angle with R1 decides; else other;
/// - asymmetric_cells: with five axes, the number of `cells` in the set whose images by
///   half a turn about the tool axis are not in the set.
/// \param border_step as in FeasibleDirections::border. \param cells unit vectors spread
/// over the sphere, by which shape and symmetry are decided.
NamedCells motion_cells(const MachineConfiguration& machine,
                        const FeasibleDirections& set, double border_step,
                        std::span<const Vec3> cells);

}  // namespace endmill
