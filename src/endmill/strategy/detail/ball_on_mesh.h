// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/cutter/cutter.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/mesh/triangle_tree.h"

namespace endmill {

/// Which edges a mesh has.
enum class MeshEdges {
    Smooth,  ///< it approximates a smooth surface
    Sharp,   ///< there are sharp edges
};

/// Where a ball along +z can be on a mesh. An immutable value that refers to the mesh; all
/// threads may use it.
///
/// The depth of a gouge is measured along the normals of the part. On a smooth part it is
/// the depth from the nearest place of the centre. At a sharp edge above a wall the ball
/// and its shank cut a thin strip from the facet above as deep as the wall is high.
/// Therefore the ball keeps a small distance from a mesh with sharp edges, and a move
/// enters it only as far as the tolerance along the axis, or not at all.
class BallOnMesh {
public:
    /// \param mesh      the whole part; it must outlive this object.
    /// \param cutter    the ball, radius R.
    /// \param tolerance greatest depth in mm by which the ball may enter the mesh; above 0
    ///        and below R.
    /// \param edges     of the facets that face the tool.
    BallOnMesh(const TriangleMesh& mesh, const BallCutter& cutter, double tolerance,
               MeshEdges edges);

    /// The contact of the ball nearest to a wanted one. It is the wanted one if the ball
    /// enters the mesh there by at most half the tolerance. Otherwise the ball moves away
    /// from the facets that it enters, until it touches them; in a concave corner it
    /// touches both sides. If that fails, it is lowered from above over the wanted place.
    /// On a mesh with sharp edges the point lies at the distance of the ball off the mesh.
    /// \param wanted point on the mesh, and unit normal.
    CutterContact seated(const CutterContact& wanted) const;

    /// Whether the ball comes within `distance` mm of a point of the mesh along its normal
    /// without entering the mesh; see is_accessible in drop_cutter/clearance.h.
    bool is_accessible(const CutterContact& contact, double distance) const;

    /// Whether a straight move of the centre keeps the tolerance. The shank above the ball
    /// is part of the tool.
    bool is_clear(const Vec3& from, const Vec3& to) const;

    /// The point of the mesh nearest to a place, mm.
    Vec3 nearest(const Vec3& place) const;

    const BallCutter& cutter() const { return cutter_; }  ///< the ball

private:
    bool is_inside(const Vec3& place) const;
    Vec3 pushed_out(Vec3 centre, const Vec3& normal) const;

    BallCutter cutter_;
    double tolerance_;
    double distance_;  // that the ball keeps from the mesh, mm
    double entered_;   // a centre nearer to the mesh than this enters it, mm
    TriangleTree tree_;
    DropCutter drop_;
    DropCutter core_;  // a ball about the same centre that must not enter the mesh
};

}  // namespace endmill
