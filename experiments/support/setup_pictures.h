// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/experiment.h"
#include "support/studied_part.h"

namespace endmill {

/// What surrounds the pictures of a setup.
struct SetupPictureNames {
    std::string file;                     ///< FILE-setup.svg and FILE-sphere.svg
    std::string title;                    ///< above both
    std::vector<std::string> captions{};  ///< lines below the title
};

/// What the pose needs, as "R1 from -76.4° to 74.6°, R2 from ...".
std::string range_caption(RotaryFamily family, const FittedPose& fit);

/// Keeps FILE-setup.svg, the part in its pose, and FILE-sphere.svg, the directions that it asks
/// for. Facets count as reached at zero if the cell nearest to the tool axis reaches them.
/// \param marked directions of the part that the sphere shows as discs.
void write_setup_pictures(Experiment& run, const SetupPictureNames& names,
                          const StudiedPart& part, const ShownSetup& setup,
                          const std::vector<Vec3>& marked);

}  // namespace endmill
