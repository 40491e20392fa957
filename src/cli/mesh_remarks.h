// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A cleaned mesh and remarks on its defects.
struct RemarkedMesh {
    TriangleMesh mesh;
    std::vector<std::string> remarks;
};

/// `mesh` without duplicate triangles. The remarks count the duplicates, and the edges
/// that belong to one triangle, to more than two, or to two triangles of opposite
/// orientation. Such edges are kept, since the intended mesh is not known.
RemarkedMesh remarked(TriangleMesh mesh);

/// The remark on edges that belong to more than two triangles.
std::string non_manifold_text(std::size_t edges, const std::string& first_edge);

}  // namespace endmill
