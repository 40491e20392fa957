// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The mesh datasets/meshes/FILE, in the unit of the file. \throws FormatError as `read_mesh`.
TriangleMesh dataset_mesh(const std::string& file);

/// `mesh` transformed by an invertible matrix. A mirrored mesh gets reversed triangles,
/// so that its normals point outwards.
TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Matrix3d& motion);

}  // namespace endmill
