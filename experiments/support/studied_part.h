// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/figures/setup_figures.h"
#include "endmill/setup/setup.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// A part with the visibility cones of its facets.
struct StudiedPart {
    TriangleMesh mesh;  ///< mm, or the unit of the file
    SphereGrid grid;
    PartVisibility visibility;
};

/// Computes the cones of a mesh on the named grid.
/// \throws DomainError as `sphere_grid` and `part_visibility`.
StudiedPart studied_part(TriangleMesh mesh, const std::string& grid, Angle incidence,
                         VisibilityKind kind = VisibilityKind::Global);

/// The same for the mesh datasets/meshes/FILE.
/// \throws FormatError as `read_mesh`, DomainError as `sphere_grid` and
/// `part_visibility`.
StudiedPart studied_part(const std::string& file, const std::string& grid,
                         Angle incidence);

/// The best setup of the part without limits. \param mode "paper-literal", "paper",
/// "corrected" or "set".
/// \throws DomainError for another name.
PartSetup unlimited_setup(const StudiedPart& part, RotaryFamily family,
                          const std::string& mode);

/// The pose for pictures, on a machine caB or abB.
ShownSetup posed(RotaryFamily family, const FittedPose& fit);

/// The set MD of the paper: for each facet that the tool axis does not reach, the
/// direction nearest to the axis that reaches it. \pre the tool axis is the centre of
/// `fit.cell`.
std::vector<Vec3> nearest_directions(const StudiedPart& part, const FittedPose& fit);

/// "C,A" or "A,B".
std::string family_name(RotaryFamily family);

}  // namespace endmill
