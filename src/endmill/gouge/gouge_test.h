// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/cutter/cutter.h"
#include "endmill/gouge/detail/centre_strip.h"
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

/// A point of the part that a ball's move takes away, or nearly.
struct GougePlace {
    std::size_t surface;  ///< number of its surface
    SurfacePoint at;
    Vec3 point;       ///< mm
    double depth_mm;  ///< R less its distance from the strip of centres
};

/// What is known of a move.
enum class GougeVerdict {
    Clear,      ///< no point of the part is deeper than the tolerance
    Gouges,     ///< one is
    Undecided,  ///< neither could be shown above the resolution
};

/// A verdict and, unless that is Clear, the place that decided it.
struct GougeAnswer {
    GougeVerdict verdict;
    std::optional<GougePlace> place;
};

/// Pieces of a part that questions about a neighbourhood have cut finer, kept for the next
/// ones there. It changes no answer. For one GougeTest and one thread at a time.
class FinerPieces {
public:
    /// Number of the first half of the piece `leaf` of `tree`; the second follows.
    std::int32_t halves_of_leaf(const PieceTree& tree, std::int32_t leaf);

    /// The same of a piece of its own.
    std::int32_t halves_of(std::int32_t number);

    const PieceTree::Piece& piece(std::int32_t number) const { return pieces_[number]; }

    /// Forgets all if it has grown to over 20 MB or so.
    void limit_memory();

private:
    std::int32_t add_halves(const BezierPiece& whole);

    std::deque<PieceTree::Piece> pieces_{1};  // the first stands for none
    std::unordered_map<std::int32_t, std::int32_t> of_leaves_;
};

/// How deep straight moves of a ball, and of the shank of the same radius above it, enter
/// a part: R less the distance of the part's nearest point from the strip of centres.
/// Where the ball lies against the part that is the depth along the part's normal.
/// From the hulls of control points: certain but for rounding, some 1e-12 of the
/// coordinates. An immutable value, which all threads may ask.
class GougeTest {
public:
    /// \param axis from the tip to the spindle, unit.
    /// \throws DomainError unless there is a surface.
    GougeTest(std::span<const Surface> surfaces, const BallCutter& cutter,
              const Vec3& axis);

    /// Whether `move` goes deeper than `tolerance` anywhere.
    /// Undecided is what would have to be known to 1e-3 of the tolerance. Some 5 us where
    /// the move is not much longer than R and the tolerance not far below R / 10.
    /// \param tolerance in mm, 0 < tolerance < R.
    GougeAnswer test(const BallMove& move, double tolerance) const;

    /// The same, faster where many moves in one neighbourhood are asked about.
    GougeAnswer test(const BallMove& move, double tolerance, FinerPieces& finer) const;

    /// The deepest place of `move`, its depth right to `resolution` mm.
    /// \return nothing if no point of the part is inside.
    std::optional<GougePlace> deepest(const BallMove& move, double resolution) const;

    const BallCutter& cutter() const { return cutter_; }
    const Vec3& axis() const { return axis_; }  ///< unit

private:
    BallCutter cutter_;
    Vec3 axis_;
    PieceTree tree_;
};

}  // namespace endmill
