// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/vec.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A part of a Bezier patch over a rectangle of its parameters, as a Bezier patch of its
/// own.
struct BezierPiece {
    std::size_t surface;  ///< number of its surface
    SurfacePoint low;     ///< global parameters of its corners
    /// Global parameters of the opposite corner.
    SurfacePoint high;
    int points_u;  ///< number of control points in u and in v
    int points_v;  ///< rows of control points
    /// One row for each control point, u fastest, with the columns w x, w y, w z and w.
    Eigen::MatrixX4d net;
    bool is_rational;  ///< if false, all w are 1

    /// The corner `end_u`, `end_v` (0 or 1), which is a point of the surface.
    Vec3 corner(int end_u, int end_v) const;

    /// The smallest `direction` . (p - `origin`) over the control points p. It is a lower
    /// bound for all points of the piece.
    double least_height(const Vec3& direction, const Vec3& origin) const;

    /// The mean of the four corners, mm.
    Vec3 middle() const;

    /// The box around the control points.
    Eigen::AlignedBox3d box() const;

    /// The parameter in which the piece is wider, by the distances of opposite control
    /// points.
    Parameter wider() const;
};

/// The two halves of a piece, divided at the middle of the parameter `across`.
std::pair<BezierPiece, BezierPiece> halves(const BezierPiece& piece, Parameter across);

/// The surfaces of a part as Bezier pieces: a tree of boxes over the patches and, below
/// each patch, its halves, their halves, and so on. It differs from the library's other
/// box trees because its leaves are halved further while a search runs (FinerPieces). An
/// immutable value.
class PieceTree {
public:
    /// A box with two children, or with one patch.
    struct Node {
        Eigen::AlignedBox3d box;  ///< around everything below the node
        /// If not negative, the number of the first child, which the second follows;
        /// otherwise ~piece.
        std::int32_t link = 0;
    };

    /// A piece with its middle and its halves.
    struct Piece {
        /// The piece.
        BezierPiece bezier;
        Vec3 middle;  ///< mm, mean of the corners
        /// Number of the first half, which the second follows; 0 if there are none.
        std::int32_t halves = 0;
    };

    /// \param surfaces the part.
    /// \param piece_size mm, largest diagonal of the box of a piece without halves. It is
    ///     enlarged where it would make more than about 60 000 pieces besides the patches.
    /// \throws DomainError unless there is a surface and 0 < piece_size.
    PieceTree(std::span<const Surface> surfaces, double piece_size);

    const std::vector<Node>& nodes() const { return nodes_; }  ///< the root first
    /// The patches first, then their halves.
    const std::vector<Piece>& pieces() const { return pieces_; }

private:
    bool add_all_halves(std::size_t patches, double size);
    bool add_halves(std::size_t piece, double size, int halvings, std::size_t most);

    std::vector<Node> nodes_;
    std::vector<Piece> pieces_;
};

/// The halves of pieces that searches in one neighbourhood have made, kept for the next
/// searches there. They change no result. An object belongs to one PieceTree and to one
/// thread.
class FinerPieces {
public:
    /// The number of the first half of leaf `leaf` of `tree`. The second follows.
    std::int32_t halves_of_leaf(const PieceTree& tree, std::int32_t leaf);

    /// The same for a piece of this object.
    std::int32_t halves_of(std::int32_t number);

    /// A piece of this object.
    const PieceTree::Piece& piece(std::int32_t number) const { return pieces_[number]; }

    /// Whether the pieces take more than about 20 MB.
    bool is_full() const;

    /// Removes all pieces if they take more than about 20 MB.
    void limit_memory();

private:
    std::int32_t add_halves(const BezierPiece& whole);

    std::deque<PieceTree::Piece> pieces_{1};  // the first one is unused
    std::unordered_map<std::int32_t, std::int32_t> of_leaves_;
};

}  // namespace endmill
