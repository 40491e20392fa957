// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/detail/piece_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "endmill/core/error.h"
#include "endmill/surface/extent.h"

namespace endmill {
namespace {

// pieces without halves; there are as many with halves, about 30 MB in total
constexpr double most_pieces = 20'000;
// The same for the pieces that were in fact made. Pieces of a long and narrow surface are
// many for its area.
constexpr std::size_t most_added_pieces = 100'000;
constexpr std::size_t most_finer_pieces = 30'000;
constexpr int most_halvings = 40;  // of a patch of any shape

BezierPiece whole_patch(const Surface& surface, std::size_t number, int i, int j)
{
    const BezierPatch& patch = surface.patch(i, j);
    const auto u = surface.breaks(Parameter::U).subspan(i, 2);
    const auto v = surface.breaks(Parameter::V).subspan(j, 2);
    BezierPiece piece{number,
                      {u[0], v[0]},
                      {u[1], v[1]},
                      patch.degree(Parameter::U) + 1,
                      patch.degree(Parameter::V) + 1,
                      {},
                      patch.is_rational()};
    piece.net.resize(Eigen::Index{piece.points_u} * piece.points_v, 4);
    for (int row = 0; row < piece.points_v; ++row)
        for (int column = 0; column < piece.points_u; ++column)
            piece.net.row(row * piece.points_u + column) =
                patch.homogeneous_point(column, row);
    return piece;
}

// Makes `nodes[node]` the box around `pieces` and builds all nodes below it, by halving
// at the median.
void build_below(std::size_t node, std::span<std::int32_t> pieces,
                 std::span<const Eigen::AlignedBox3d> boxes,
                 std::vector<PieceTree::Node>& nodes)
{
    Eigen::AlignedBox3d middles;
    for (const std::int32_t piece : pieces) {
        nodes[node].box.extend(boxes[piece]);
        middles.extend(boxes[piece].center());
    }
    if (pieces.size() == 1) {
        nodes[node].link = ~pieces.front();
        return;
    }
    Eigen::Index axis = 0;
    middles.sizes().maxCoeff(&axis);
    const auto half = pieces.size() / 2;
    const auto middle = [&](std::int32_t piece) {
        return std::pair{boxes[piece].center()[axis], piece};
    };
    std::ranges::nth_element(pieces, pieces.begin() + static_cast<std::ptrdiff_t>(half),
                             {}, middle);
    const std::size_t first = nodes.size();
    nodes[node].link = static_cast<std::int32_t>(first);
    nodes.resize(first + 2);
    build_below(first, pieces.first(half), boxes, nodes);
    build_below(first + 1, pieces.subspan(half), boxes, nodes);
}

}  // namespace

Vec3 BezierPiece::corner(int end_u, int end_v) const
{
    const Eigen::Index row =
        Eigen::Index{end_v} * (points_v - 1) * points_u + end_u * (points_u - 1);
    const Vec3 point = net.row(row).head<3>();
    return is_rational ? Vec3{point / net(row, 3)} : point;
}

Vec3 BezierPiece::middle() const
{
    return (corner(0, 0) + corner(1, 0) + corner(0, 1) + corner(1, 1)) / 4;
}

double BezierPiece::least_height(const Vec3& direction, const Vec3& origin) const
{
    const auto points = net.array();
    const auto along = direction[0] * points.col(0) + direction[1] * points.col(1) +
                       direction[2] * points.col(2);
    const double height = direction.dot(origin);
    return (is_rational ? (along / points.col(3)).minCoeff() : along.minCoeff()) - height;
}

Eigen::AlignedBox3d BezierPiece::box() const
{
    Eigen::AlignedBox3d box;
    for (const auto& point : net.rowwise())
        box.extend(Vec3{point.head<3>().transpose() / point[3]});
    return box;
}

Parameter BezierPiece::wider() const
{
    // All pairs of opposite control points count, because the corners alone may coincide.
    const auto point = [&](int i, int j) -> Vec3 {
        const auto row = net.row(Eigen::Index{j} * points_u + i);
        const Vec3 place = row.head<3>();
        return is_rational ? Vec3{place / row[3]} : place;
    };
    double width_u = 0;
    double width_v = 0;
    for (int j = 0; j < points_v; ++j)
        width_u = std::max(width_u, (point(points_u - 1, j) - point(0, j)).norm());
    for (int i = 0; i < points_u; ++i)
        width_v = std::max(width_v, (point(i, points_v - 1) - point(i, 0)).norm());
    if (width_u == width_v)  // closed or collapsed in both directions, or a square
        return high.u - low.u >= high.v - low.v ? Parameter::U : Parameter::V;
    return width_u > width_v ? Parameter::U : Parameter::V;
}

std::pair<BezierPiece, BezierPiece> halves(const BezierPiece& piece, Parameter across)
{
    std::pair<BezierPiece, BezierPiece> result{piece, piece};
    auto& [low, high] = result;
    const bool is_u = across == Parameter::U;
    const int count = is_u ? piece.points_u : piece.points_v;
    const int rows = is_u ? piece.points_v : piece.points_u;
    const int step = is_u ? 1 : piece.points_u;
    const int row_step = is_u ? piece.points_u : 1;
    // De Casteljau's algorithm at 1/2, row by row. The two sides of its triangle are the
    // halves.
    for (int row = 0; row < rows; ++row) {
        const auto point = [&](BezierPiece& half, int k) {
            return half.net.row(Eigen::Index{row} * row_step + Eigen::Index{k} * step);
        };
        for (int level = 1; level < count; ++level) {
            for (int k = 0; k < count - level; ++k)
                point(high, k) = (point(high, k) + point(high, k + 1)) / 2;
            point(low, level) = point(high, 0);
        }
    }
    const SurfacePoint middle{(piece.low.u + piece.high.u) / 2,
                              (piece.low.v + piece.high.v) / 2};
    (is_u ? low.high.u : low.high.v) = is_u ? middle.u : middle.v;
    (is_u ? high.low.u : high.low.v) = is_u ? middle.u : middle.v;
    return result;
}

PieceTree::PieceTree(std::span<const Surface> surfaces, double piece_size)
{
    require(!surfaces.empty(), "PieceTree: need a surface");
    require(std::isfinite(piece_size) && piece_size > 0, "PieceTree: need 0 < size");
    // A piece of diagonal d covers an area of about d^2 / 3.
    double size = std::max(piece_size, std::sqrt(3 * area(surfaces) / most_pieces));
    for (std::size_t number = 0; number < surfaces.size(); ++number)
        for (int j = 0; j < surfaces[number].patches(Parameter::V); ++j)
            for (int i = 0; i < surfaces[number].patches(Parameter::U); ++i) {
                BezierPiece patch = whole_patch(surfaces[number], number, i, j);
                const Vec3 middle = patch.middle();
                pieces_.push_back({std::move(patch), middle});
            }
    std::vector<std::int32_t> numbers(pieces_.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(pieces_.size());
    for (const Piece& piece : pieces_)
        boxes.push_back(piece.bezier.box());
    nodes_.reserve(2 * numbers.size());
    nodes_.emplace_back();
    build_below(0, numbers, boxes, nodes_);
    const std::size_t patches = pieces_.size();
    while (!add_all_halves(patches, size))
        size *= 2;
}

// Adds the halves of all patches; removes them again if they are too many.
bool PieceTree::add_all_halves(std::size_t patches, double size)
{
    for (std::size_t k = 0; k < patches; ++k)
        if (!add_halves(k, size, most_halvings, patches + most_added_pieces)) {
            pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(patches),
                          pieces_.end());
            for (Piece& patch : pieces_)
                patch.halves = 0;
            return false;
        }
    return true;
}

// Returns false once there are more than `most` pieces.
bool PieceTree::add_halves(std::size_t piece, double size, int halvings, std::size_t most)
{
    if (halvings == 0 || pieces_[piece].bezier.box().diagonal().norm() <= size)
        return true;
    if (pieces_.size() > most)
        return false;
    const BezierPiece& whole = pieces_[piece].bezier;
    auto [low, high] = halves(whole, whole.wider());
    const std::size_t first = pieces_.size();
    pieces_[piece].halves = static_cast<std::int32_t>(first);
    for (BezierPiece* half : {&low, &high}) {
        const Vec3 middle = half->middle();
        pieces_.push_back({std::move(*half), middle});
    }
    return add_halves(first, size, halvings - 1, most) &&
           add_halves(first + 1, size, halvings - 1, most);
}

std::int32_t FinerPieces::halves_of_leaf(const PieceTree& tree, std::int32_t leaf)
{
    const auto [place, is_new] = of_leaves_.try_emplace(leaf, 0);
    if (is_new)
        place->second = add_halves(tree.pieces()[leaf].bezier);
    return place->second;
}

std::int32_t FinerPieces::halves_of(std::int32_t number)
{
    PieceTree::Piece& piece = pieces_[number];
    if (piece.halves == 0)
        piece.halves = add_halves(piece.bezier);
    return piece.halves;
}

std::int32_t FinerPieces::add_halves(const BezierPiece& whole)
{
    const auto first = static_cast<std::int32_t>(pieces_.size());
    auto [low, high] = halves(whole, whole.wider());
    for (BezierPiece* half : {&low, &high}) {
        const Vec3 middle = half->middle();
        pieces_.push_back({std::move(*half), middle});
    }
    return first;
}

bool FinerPieces::is_full() const
{
    return pieces_.size() >= most_finer_pieces;
}

void FinerPieces::limit_memory()
{
    if (!is_full())
        return;
    of_leaves_.clear();
    pieces_.resize(1);
}

}  // namespace endmill
