// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "endmill/mesh/triangle_mesh.h"
#include "endmill/mesh/triangle_tree.h"

namespace endmill {

/// A place of the smooth part that a mesh approximates.
struct ShapePlace {
    Vec3 point;   ///< mm, on the mesh
    Vec3 normal;  ///< unit, out of the material
    /// Curvature tensor in 1/mm: the normal changes by tensor * step. The normal curvature
    /// along a unit tangent t is t . tensor t, positive where the part is convex.
    Eigen::Matrix3d tensor;
    std::size_t facet;  ///< number of the facet with the point
};

/// Normals and curvatures of the smooth part that a mesh approximates.
///
/// The normal at a corner of a facet is the mean of the normals of the facets around, weighted by
/// their angles at the corner; facets beyond a sharp edge, which turns by more than
/// crease_angle, do not count. The tensor of a facet changes the normal along its three edges
/// by what the corners' normals differ, with the least squared error. The tensor at a corner is
/// the mean of those of the same facets, weighted by area. Both are linear on a facet.
///
/// On a sphere, a grid of spacing s has tensors with a relative error of about (s/radius)^2
/// inside. At a border of the mesh, where facets lie on one side only, a tensor may be half of
/// the truth. An immutable value that refers to the mesh.
/// Source: docs/methods/five-axis-planning.md, section 4.
class MeshShape {
public:
    /// \param mesh consistently oriented, without facets that have no area; it must outlive
    ///        the object.
    explicit MeshShape(const TriangleMesh& mesh);
    // deleted: the mesh would not outlive the object
    explicit MeshShape(TriangleMesh&&) = delete;

    /// The place of the mesh nearest to a place.
    /// \pre the mesh has a facet.
    ShapePlace nearest(const Vec3& place) const;

    /// The place in the middle of a facet.
    ShapePlace middle(std::size_t facet) const;

    const TriangleMesh& mesh() const { return *mesh_; }  ///< as given

private:
    void find_fans();
    void find_normals();
    void find_tensors();
    ShapePlace at(std::size_t facet, const Vec3& point) const;

    const TriangleMesh* mesh_;
    TriangleTree tree_;
    // For each corner of each facet the number of its fan: of the corners at one point whose
    // facets are joined by edges that are not sharp.
    std::vector<std::array<std::int32_t, 3>> fans_;
    std::vector<Vec3> normals_;             // of the fans
    std::vector<Eigen::Matrix3d> tensors_;  // of the fans
};

}  // namespace endmill
