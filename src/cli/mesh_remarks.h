// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A mesh as it is worked on, and what a reader should know of it.
struct RemarkedMesh {
    TriangleMesh mesh;
    std::vector<std::string> remarks;
};

/// `mesh` without the triangles that repeat another, and remarks: how many these were, and
/// how many edges belong to one triangle, to more than two, or to two that disagree about
/// the outer side. Those are left as they are, since what was meant cannot be told.
RemarkedMesh remarked(TriangleMesh mesh);

/// What is said of edges of more than two triangles.
std::string non_manifold_text(std::size_t edges, const std::string& first_edge);

}  // namespace endmill
