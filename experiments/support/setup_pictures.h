// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/experiment.h"
#include "support/studied_part.h"

namespace endmill {

/// Keeps NAME-setup.svg, the part in its pose, and NAME-sphere.svg, the directions that it asks
/// for. Facets count as reached at zero if the cell nearest to the tool axis reaches them.
/// \param marked directions of the part that the sphere shows as discs.
void write_setup_pictures(Experiment& run, const std::string& name,
                          const StudiedPart& part, const ShownSetup& setup,
                          const std::vector<Vec3>& marked);

}  // namespace endmill
