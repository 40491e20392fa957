// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "five-axis-setup/equations/random_sets.h"
#include "support/named_cells.h"

/// \file
/// Equations (14) to (21) of the family A,B and the lines of the procedure AB_Type, on
/// random sets of directions about the tool axis +z; returned cells as in sector_checks.h.
/// Source: [KangSuh, section 4.2]; docs/methods/five-axis-setup.md, sections 6 and 7.

namespace endmill {

/// The hull by a projection to the plane against the hull on the sphere, by their
/// vertices.
NamedCells hulls_by_projection(RandomSets random, int sets);

/// The edges of a hull: edges_less_vertices, equal for all sets. An edge is a pair of
/// neighbouring vertices, the last and the first included, with all directions on one side.
NamedCells hull_edges(RandomSets random, int sets);

/// (14): mean numbers of vertices that meet the condition for a supporting vertex:
/// as_printed, and as_text (the second vertex of the product is any vertex). One direction
/// of each set is outside the hull of the others.
NamedCells supporting_vertices(RandomSets random, int sets);

/// (15), (16): largest_residual of the four perpendicular pairs, at every hull edge.
NamedCells axis_residuals(RandomSets random, int sets);

/// (17): directions within 90 degrees of the tool axis whose beta changes its sign if it is taken about
/// R2 at zero and not about the turned R2.
NamedCells signs_about_initial_axis(RandomSets random, int directions);

/// (18): the number of unit vectors on the basis circle that satisfy it, `as_printed`,
/// equal for all directions within 90 degrees of the tool axis.
NamedCells projection_roots(RandomSets random, int directions);

/// (19): rectangles at hull edges whose range of beta is larger over all directions than
/// over the hull's vertices.
NamedCells extremes_over_vertices(RandomSets random, int sets);

/// (20): random rectangles and machines for which (20) holds, but neither the part nor the
/// part turned by 180 degrees about the tool axis fits. `cases` counts those for which it
/// holds.
NamedCells unsigned_limits(RandomSets random, int pairs);

/// AB_Type: the ranges at a hull edge if one index counts edges and vertices, so that each
/// vertex is turned about the axes of its own edge, against (19). R1 and R2, which the
/// procedure lacks, are those of (15) and (16). `cases` counts hull edges.
NamedCells ranges_by_one_index(RandomSets random, int sets);

/// AB_Type: strict comparisons against <= of (20), on a machine with exactly the ranges of
/// the candidate.
NamedCells strict_rectangle_comparisons(RandomSets random, int sets);

/// AB_Type: as `reported_sector`, with the limits of (20).
NamedCells reported_rectangle(RandomSets random, int sets);

/// (21): the solid angle at the R1 of least F over the least solid angle, R1 in steps of
/// one degree: `differ` (by more than 0.1 %), mean_ratio and largest_ratio.
NamedCells rectangle_against_solid_angle(RandomSets random, int sets);

/// The least F of the paper's rectangles over that of all rectangles: `differ` (by more
/// than 5 %), mean_ratio and largest_ratio.
NamedCells near_optimal_rectangles(RandomSets random, int sets);

}  // namespace endmill
