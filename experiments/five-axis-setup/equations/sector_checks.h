// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "five-axis-setup/equations/random_sets.h"
#include "support/named_cells.h"

/// \file
/// Equations (6) to (13) of the family C,A and the lines of the procedure CA_Type, on
/// random sets of directions. Each function returns `cases` and `differ`, the number of
/// cases and of those in which two readings differ, and what else it states.
/// Source: [KangSuh, section 4.1]; docs/methods/five-axis-setup.md, sections 5 and 7.

namespace endmill {

/// (6): the least double sector below 180 degrees by the gaps after a direction and after
/// its antipode, against the least one between any two ends.
NamedCells sectors_against_all_ends(RandomSets random, int sets);

/// (7): the widths of both printed intervals against theta_j of (8); adds
/// largest_difference_deg, modulo 360 degrees.
NamedCells interval_widths(RandomSets random, int sets);

/// (8): the two printed forms of theta_j against each other; adds largest_difference_deg.
NamedCells width_forms(RandomSets random, int sets);

/// (12): its third line as printed, theta_L + theta_S <= Phi_L + Phi_S, against the limit
/// Theta_L + Theta_S; one random machine for each candidate.
NamedCells third_condition(RandomSets random, int sets);

/// CA_Type: alpha_(j+1) <= alpha_j^c against alpha_(j+1) <= alpha_l^c of (6).
NamedCells choice_of_second_end(RandomSets random, int sets);

/// CA_Type: theta_j as printed there against (8).
NamedCells width_of_procedure(RandomSets random, int sets);

/// CA_Type: theta_L and theta_S as printed there, each computed from both lower-case
/// thetas, against (9); one random machine for each candidate, whose ranges the thetas
/// have at first.
NamedCells parts_of_width(RandomSets random, int sets);

/// CA_Type: phi_L and phi_S as maxima of alpha against maxima of beta, (11).
NamedCells length_of_procedure(RandomSets random, int sets);

/// CA_Type: strict comparisons against <= of (12), on a machine with exactly the ranges of
/// the candidate.
NamedCells strict_comparisons(RandomSets random, int sets);

/// CA_Type: on a machine with exactly the ranges of one candidate, chosen at random, the
/// pose that the procedure reports, that of the least F, against the limits. `differ`
/// counts the sets in which it exceeds them although the flag is 'feasible'.
NamedCells reported_sector(RandomSets random, int sets);

/// (13): the solid angle of the double sector of least F over the least solid angle of all
/// candidates: `differ` (by more than 0.1 %), mean_ratio and largest_ratio.
NamedCells area_against_solid_angle(RandomSets random, int sets);

}  // namespace endmill
