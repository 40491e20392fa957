// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A net of triangles over the facets of a mesh that face the tool, with a normal at each
/// point, so that the centres p + R n of a ball form one surface over each smooth part and
/// around its edges.
///
/// Across an edge between facets whose normals differ by at most `crease_angle` the normal
/// is continuous. At a sharper edge each side has points of its own. Strips of triangles
/// without area join both sides; their normals turn from one side to the other.
struct MeshNet {
    std::vector<Vec3> points;         ///< mm; equal points on both sides of a sharp edge
    std::vector<Vec3> normals;        ///< unit
    std::vector<Triangle> triangles;  ///< counter-clockwise seen from the tool
    /// Whether the net is coarser than the mesh. Between its points it is then only near
    /// the mesh.
    bool is_coarser = false;
    bool has_creases = false;  ///< whether there are sharp edges
};

/// Angle in rad between the normals of two facets from which their edge is sharp. Facets of
/// a smooth part that is approximated closely differ by less.
inline constexpr double crease_angle = 0.5;

/// The net of a mesh. Nearly equal points are joined, so that hair cracks close.
///
/// If the mesh has many more triangles than a net of this spacing needs, the net is a
/// coarser mesh; its points are points of the given one.
/// \param mesh    consistently oriented.
/// \param spacing distance of points in mm that is sufficient.
/// \throws GeometryError with a place if no facet faces the tool along +z.
MeshNet mesh_net(const TriangleMesh& mesh, double spacing);

}  // namespace endmill
