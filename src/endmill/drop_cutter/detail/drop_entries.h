// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// What holds several triangles: a box in plan, and a plane that none is above. mm.
struct DropEntry {
    Eigen::AlignedBox2d box;
    Eigen::Vector2d slope;  ///< of the plane, at most 16
    double height;          ///< of the plane over the origin
    double top;             ///< greatest z
};

/// The triangles of a mesh in the order of Hilbert's curve in plan, their coordinates about
/// an origin. Long thin ones, which their boxes would leave nearly empty, are cut into
/// pieces that stand for them.
class DropEntries {
public:
    using Corners = std::array<Vec3, 3>;

    /// \param origin middle of the mesh, mm. \param piece_size down to which long thin
    ///        triangles are cut, mm. Both mesh and origin must outlive this.
    DropEntries(const TriangleMesh& mesh, const Vec3& origin, double piece_size);

    /// Of triangles and pieces.
    std::size_t count() const { return numbers_.size(); }

    /// The triangle that entry `entry` is, or is a piece of.
    std::size_t triangle(std::size_t entry) const;

    /// Corners of the entry, mm.
    Corners corners(std::size_t entry) const;

    /// Box and plane of entries first … last - 1, larger and higher by `margin` mm and what
    /// that makes of the plane.
    DropEntry whole(std::size_t first, std::size_t last, double margin) const;

    /// The triangle of each entry, in order; of the entries nothing is left.
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
    std::vector<std::uint32_t> numbers_;  // of triangles, then of pieces
};

}  // namespace endmill
