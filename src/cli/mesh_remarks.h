// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/mesh/mesh_repair.h"

namespace endmill {

/// Remarks on the defects of a mesh. They count the duplicate triangles that were left
/// out, and the edges that belong to one triangle, to more than two, or to two triangles
/// of opposite orientation. Such edges are kept, since the intended mesh is not known.
std::vector<std::string> mesh_remarks(const CleanedMesh& cleaned);

/// The remark on edges that belong to more than two triangles.
std::string non_manifold_text(std::size_t edges, const std::string& first_edge);

}  // namespace endmill
