// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/surface/surface.h"

namespace endmill {

/// A rectangle of a patch's unit square as a Bezier patch of its own.
struct BezierPiece {
    std::size_t surface;  ///< number of its surface
    SurfacePoint low;     ///< global parameters of its corners
    SurfacePoint high;
    int points_u;  ///< number of control points each way
    int points_v;
    /// Columns w x, w y, w z and w of the control points, a row a point, u fastest.
    Eigen::MatrixX4d net;
    bool is_rational;  ///< if not, all w are 1

    /// The corner `end_u`, `end_v` (0 or 1): a point of the surface.
    Vec3 corner(int end_u, int end_v) const;

    /// Least w . (p - q) over its control points p, and so over its points: `w` is
    /// `direction`, q is `origin`.
    double least_height(const Vec3& direction, const Vec3& origin) const;

    /// The mean of its corners, mm.
    Vec3 middle() const;

    /// Box around its control points.
    Eigen::AlignedBox3d box() const;

    /// The longer way, by the corners' distances.
    Parameter wider() const;
};

/// Its two halves across `across`.
std::pair<BezierPiece, BezierPiece> halves(const BezierPiece& piece, Parameter across);

/// The surfaces of a part as Bezier pieces: a tree of boxes over their patches, and under
/// each patch its halves, their halves, and so on. An immutable value.
class PieceTree {
public:
    /// A box with two children, or with one patch.
    struct Node {
        Eigen::AlignedBox3d box;  ///< around all below it
        /// If not negative the first child, the second of which follows; else ~piece.
        std::int32_t link = 0;
    };

    /// A piece, and where it lies.
    struct Piece {
        BezierPiece bezier;
        Vec3 middle;  ///< mm, the mean of its corners
        /// The first of its halves, the second of which follows; 0 if it has none.
        std::int32_t halves = 0;
    };

    /// \param piece_size widest diagonal in mm of the box of a piece without halves; wider
    ///                   ones where that would make over 60 000 pieces or so.
    /// \throws DomainError unless there is a surface and 0 < piece_size.
    PieceTree(std::span<const Surface> surfaces, double piece_size);

    const std::vector<Node>& nodes() const { return nodes_; }  ///< the root first
    const std::vector<Piece>& pieces() const { return pieces_; }

private:
    void add_halves(std::size_t piece, double size, int halvings);

    std::vector<Node> nodes_;
    std::vector<Piece> pieces_;
};

}  // namespace endmill
