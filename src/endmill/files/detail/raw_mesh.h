// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/mesh_file.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A mesh as it stands in a file: points may coincide or be unused, and triangles may have
/// no area.
struct RawMesh {
    TriangleMesh mesh;
    std::size_t split_faces;  ///< faces of more than three corners in the file
    double out_of_plane_mm;   ///< how far a corner of these is off its plane, at most
};

/// Collects a RawMesh while a file with numbered points is read.
class RawMeshBuilder {
public:
    /// Takes memory for so many points and as many triangles as faces.
    /// \param source outlives the builder.
    /// \throws LimitError if the mesh and the file need more memory than the limit, or
    /// if there are too many to be numbered.
    RawMeshBuilder(const MeshSource& source, std::size_t points, std::size_t faces);

    std::size_t points() const { return points_.size(); }  ///< so far

    void add_point(const Vec3& point) { points_.push_back(point); }  ///< mm

    /// Adds a face; one of more than three corners becomes a fan of triangles.
    /// \param corners numbers of points that exist.
    /// \throws FormatError E_DEGENERATE if it has fewer than three corners, or one twice;
    /// E_POLYGON if no fan of triangles covers it.
    /// \throws LimitError if the triangles come to more than the memory limit.
    void add_face(std::span<const std::int32_t> corners, FilePlace place);

    /// What was added; the builder is of no use afterwards.
    RawMesh take();

private:
    void require_corners(std::span<const std::int32_t> corners, FilePlace place);
    void add_fan(std::span<const std::int32_t> corners, FilePlace place);
    void add_triangle(const Triangle& triangle);
    void require_memory_for(double points, double triangles) const;

    const MeshSource& source_;
    std::vector<Vec3> points_;
    std::vector<Triangle> triangles_;
    std::size_t split_faces_ = 0;
    double out_of_plane_mm_ = 0;
    std::vector<Vec3> polygon_;         // corners of the face that is being split
    std::vector<std::int32_t> sorted_;  // their numbers, in order
};

}  // namespace endmill
