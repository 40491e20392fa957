// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A net of triangles over the facets of a mesh that face the tool, with a normal at each
/// point, so that the centres p + R n of a ball form one surface over each smooth part and
/// around its edges.
///
/// Across an edge with a small turn of the normal the normal is continuous. At other edges
/// each side has points of its own. Strips of triangles without area join both sides; their
/// normals turn from one side to the other.
struct MeshNet {
    std::vector<Vec3> points;         ///< mm; equal points on both sides of a sharp edge
    std::vector<Vec3> normals;        ///< unit
    std::vector<Triangle> triangles;  ///< counter-clockwise seen from the tool
    /// Whether the net is coarser than the mesh. Between its points it is then only near
    /// the mesh.
    bool is_coarser = false;
    bool has_creases = false;  ///< whether an edge turns by more than crease_angle
    /// Greatest turn in rad of an edge of the mesh across which the normal is continuous; 0 if
    /// the net is coarser.
    double smoothed_turn = 0;
};

/// Angle in rad between the normals of two facets from which their edge is sharp. Facets of
/// a smooth part that is approximated closely differ by less.
inline constexpr double crease_angle = 0.5;

/// How closely a net follows a mesh.
struct MeshNetLimits {
    double spacing;  ///< distance of points in mm that is sufficient
    /// Angle in rad between the normals of two facets up to which the normal is continuous
    /// across their edge. A place near the edge is then raised along another direction than
    /// that of its facet. A coarser net has the limit crease_angle instead, because its
    /// facets turn more than those of the mesh.
    double smooth_turn;
    /// The same for a mesh no edge of which turns by more than this.
    double smooth_mesh_turn;
};

/// The net of a mesh. Nearly equal points are joined, so that hair cracks close.
///
/// If the mesh has many more triangles than a net of this spacing needs, the net is a
/// coarser mesh; its points are points of the given one.
/// \param mesh   consistently oriented.
/// \param limits see there.
/// \throws GeometryError with a place if no facet faces the tool along +z.
MeshNet mesh_net(const TriangleMesh& mesh, const MeshNetLimits& limits);

}  // namespace endmill
