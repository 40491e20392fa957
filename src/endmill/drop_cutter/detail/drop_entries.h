// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The bounds of several triangles: a box in plan, and a plane above all of them, in mm.
struct DropEntry {
    /// Box in plan.
    Eigen::AlignedBox2d box;
    Eigen::Vector2d slope;  ///< of the plane, at most 16
    double height;          ///< of the plane over the origin
    double top;             ///< largest z
};

/// The triangles of a mesh in the order of the Hilbert curve in plan, with coordinates
/// relative to an origin. Long thin triangles, which would fill their boxes badly, are
/// replaced by pieces.
class DropEntries {
public:
    /// The corners of a triangle or a piece, mm.
    using Corners = std::array<Vec3, 3>;

    /// \param mesh the triangles; it must outlive this object.
    /// \param origin middle of the mesh, mm; it must outlive this object.
    /// \param piece_size mm, size down to which long thin triangles are divided.
    DropEntries(const TriangleMesh& mesh, const Vec3& origin, double piece_size);

    /// Number of entries: undivided triangles and pieces.
    std::size_t count() const { return numbers_.size(); }

    /// The triangle of an entry, or the triangle that it is a piece of.
    std::size_t triangle(std::size_t entry) const;

    /// Corners of the entry, mm, relative to the origin.
    Corners corners(std::size_t entry) const;

    /// Box and plane of the entries first … last - 1. The box is enlarged by `margin` mm,
    /// and the plane is raised by what the margin amounts to on it.
    DropEntry whole(std::size_t first, std::size_t last, double margin) const;

    /// The triangle of each entry, in order. The entries themselves are given up.
    std::vector<std::uint32_t> into_triangles() &&;

private:
    struct Piece {
        std::size_t triangle;
        Corners corners;
    };

    Corners local_corners(std::size_t number) const;
    void cut(const Corners& corners, std::size_t triangle, double least_size, int cuts);
    Eigen::Vector2d slope(std::size_t first, std::size_t last) const;

    const TriangleMesh& mesh_;
    const Vec3& origin_;
    std::size_t most_pieces_;
    std::vector<Piece> pieces_;
    // numbers of triangles, followed by those of pieces
    std::vector<std::uint32_t> numbers_;
};

}  // namespace endmill
