// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/cutter/cutter.h"
#include "endmill/drop_cutter/drop_cutter.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/mesh/triangle_tree.h"

namespace endmill {

/// Where a ball along +z can be on a mesh. An immutable value that refers to the mesh; all
/// threads may use it.
class BallOnMesh {
public:
    /// \param mesh      the whole part; it must outlive this object.
    /// \param cutter    the ball, radius R.
    /// \param tolerance greatest depth in mm by which the ball may enter the mesh; above 0
    ///        and below R.
    BallOnMesh(const TriangleMesh& mesh, const BallCutter& cutter, double tolerance);

    /// The contact of the ball nearest to a wanted one. It is the wanted one if the ball
    /// enters the mesh there by at most half the tolerance and touches it. Otherwise the
    /// ball moves away from the facets that it enters, until it touches them; in a concave
    /// corner it touches both sides. If that fails, it is lowered along the axis from above
    /// over the wanted place.
    /// \param wanted point on or near the mesh, and unit normal.
    CutterContact seated(const CutterContact& wanted) const;

    /// Whether the ball comes within `distance` mm of a point of the mesh along its normal
    /// without entering the mesh; see is_accessible in drop_cutter/clearance.h.
    bool is_accessible(const CutterContact& contact, double distance) const;

    /// Whether a straight move of the centre enters the mesh nowhere by more than the
    /// tolerance. The shank above the ball is part of the tool. The depth is measured along
    /// the axis or from the nearest place of the centre.
    bool is_clear(const Vec3& from, const Vec3& to) const;

    /// The point of the mesh nearest to a place, mm.
    Vec3 nearest(const Vec3& place) const;

    const BallCutter& cutter() const { return cutter_; }  ///< the ball

private:
    bool is_inside(const Vec3& place) const;
    Vec3 pushed_out(Vec3 centre, const Vec3& normal) const;

    BallCutter cutter_;
    double tolerance_;
    TriangleTree tree_;
    DropCutter drop_;
    DropCutter core_;  // a ball about the same centre, smaller by most of the tolerance
};

}  // namespace endmill
