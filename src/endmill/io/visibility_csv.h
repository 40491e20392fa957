// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "endmill/accessibility/visibility.h"
#include "endmill/io/output_folder.h"

namespace endmill {

/// Writes the map as the paper has it, to `sink`: after `facet` the columns `cell_0`, `cell_1`
/// and so on, a row a facet; 0 where the facet is accessible, else 1. Source: [KangSuh,
/// section 2].
void write_visibility_csv(const VisibilityMap& map, const OutputFolder::Sink& sink);

/// The columns `facet` and `visible_fraction`: the share of the sphere that its cone has,
/// cells by their solid angles; unknown for a facet without area.
/// \param solid_angles_sr of the cells. \throws DomainError unless there is one a cell.
std::string cones_csv(const PartVisibility& visibility,
                      std::span<const double> solid_angles_sr);

}  // namespace endmill
