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
    TriangleMesh mesh;  ///< mm, or the file's unit
    SphereGrid grid;
    PartVisibility visibility;
};

/// A mesh and its cones on the grid of that name.
/// \throws DomainError as `sphere_grid` and `part_visibility`.
StudiedPart studied_part(TriangleMesh mesh, const std::string& grid, Angle incidence,
                         VisibilityKind kind = VisibilityKind::Global);

/// The same of the mesh datasets/meshes/FILE.
/// \throws FormatError as `read_mesh`, DomainError as `sphere_grid` and `part_visibility`.
StudiedPart studied_part(const std::string& file, const std::string& grid,
                         Angle incidence);

/// Its best setup without limits: mode "paper-literal", "paper", "corrected" or "set".
/// \throws DomainError for another word.
PartSetup unlimited_setup(const StudiedPart& part, RotaryFamily family,
                          const std::string& mode);

/// The pose as pictures show it, on a machine caB or abB.
ShownSetup posed(RotaryFamily family, const FittedPose& fit);

/// The paper's MD: the directions nearest to the tool axis that reach what it does not.
/// \pre the tool axis is the centre of `fit.cell`.
std::vector<Vec3> nearest_directions(const StudiedPart& part, const FittedPose& fit);

/// "C,A" or "A,B".
std::string family_name(RotaryFamily family);

}  // namespace endmill
