// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/files/detail/mesh_source.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A mesh with the points and triangles of its file: points may coincide or be unused,
/// and triangles may be degenerate.
struct RawMesh {
    TriangleMesh mesh;  ///< in mm
    /// Number of faces with more than three corners in the file.
    std::size_t split_faces;
    /// Largest distance of a corner of these from its face's plane.
    double out_of_plane_mm;
    /// Notes about what the reader skipped.
    std::vector<std::string> notes = {};
    /// For each triangle the number of its face of a CAD model, from 1; empty if the file has
    /// none.
    std::vector<std::int32_t> face_numbers = {};
};

/// Collects a RawMesh while a file with indexed points is read.
class RawMeshBuilder {
public:
    /// Reserves memory for the points, and for one triangle for each face.
    /// \param source outlives the builder.
    /// \throws LimitError if the mesh and the file need more memory than the limit, or if
    ///         there are too many points or faces for 32-bit indices.
    RawMeshBuilder(const MeshSource& source, std::size_t points, std::size_t faces);

    std::size_t points() const { return points_.size(); }  ///< number of points so far

    void add_point(const Vec3& point) { points_.push_back(point); }  ///< in mm

    std::size_t triangles() const { return triangles_.size(); }  ///< number so far

    /// Adds a face. A face of more than three corners becomes a fan of triangles.
    /// \param corners indices of existing points.
    /// \throws FormatError E_DEGENERATE if the face has fewer than three corners or a
    ///         corner occurs twice; E_POLYGON if no fan of triangles covers it.
    /// \throws LimitError if the triangles exceed the memory limit.
    void add_face(std::span<const std::int32_t> corners, FilePlace place);

    /// The mesh so far. The builder must not be used afterwards.
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
    std::vector<Vec3> polygon_;  // scratch: corners of the face that is being split
    std::vector<std::int32_t> sorted_;  // scratch: their indices, sorted
};

}  // namespace endmill
