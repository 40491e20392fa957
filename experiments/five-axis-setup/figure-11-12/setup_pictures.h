// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "support/experiment.h"
#include "support/studied_part.h"

namespace endmill {

/// File name, title and captions of the two pictures of a setup.
struct SetupPictureNames {
    std::string file;                     ///< FILE-setup.svg and FILE-sphere.svg
    std::string title;                    ///< title of both
    std::vector<std::string> captions{};  ///< lines below the title
};

/// Text of the ranges of a pose, such as "R1 from -76.4° to 74.6°, R2 from ...".
std::string range_caption(RotaryFamily family, const FittedPose& fit);

/// Writes FILE-setup.svg, the part in its pose, and FILE-sphere.svg, the required
/// directions. `reached_at_zero` decides which facets are coloured as reached without a
/// turn.
/// \param marked directions in the part's coordinates, drawn as discs on the sphere.
void write_setup_pictures(Experiment& run, const SetupPictureNames& names,
                          const StudiedPart& part, const ShownSetup& setup,
                          const std::vector<Vec3>& marked);

}  // namespace endmill
