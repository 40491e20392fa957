// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/piece_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "endmill/core/error.h"
#include "endmill/surface/area.h"

namespace endmill {
namespace {

constexpr double most_pieces = 60'000;  // some 30 MB of bicubic ones
constexpr int most_halvings = 40;       // of a patch, whatever its shape

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
    piece.net.resize(4, Eigen::Index{piece.points_u} * piece.points_v);
    for (int row = 0; row < piece.points_v; ++row)
        for (int column = 0; column < piece.points_u; ++column)
            piece.net.col(row * piece.points_u + column) =
                patch.homogeneous_point(column, row);
    return piece;
}

// Cuts `piece` until its sides are no longer than `size`.
void cut(BezierPiece piece, double size, int halvings, std::vector<BezierPiece>& pieces)
{
    const Vec3 extent = piece.box().sizes();
    if (halvings == 0 || extent.norm() <= size) {
        pieces.push_back(std::move(piece));
        return;
    }
    auto [low, high] = halves(piece, piece.wider());
    cut(std::move(low), size, halvings - 1, pieces);
    cut(std::move(high), size, halvings - 1, pieces);
}

// Makes `nodes[node]` the box around `pieces`, and all nodes below it, by halving at the
// median.
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
    const Eigen::Index column =
        Eigen::Index{end_v} * (points_v - 1) * points_u + end_u * (points_u - 1);
    return net.col(column).head<3>() / net(3, column);
}

double BezierPiece::least_height(const Vec3& direction, const Vec3& origin) const
{
    const Eigen::RowVector4d plane{direction[0], direction[1], direction[2],
                                   -direction.dot(origin)};
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < net.cols(); ++k) {
        const double height = plane * net.col(k);
        least = std::min(least, is_rational ? height / net(3, k) : height);
    }
    return least;
}

Eigen::AlignedBox3d BezierPiece::box() const
{
    Eigen::AlignedBox3d box;
    for (const auto& point : net.colwise())
        box.extend(Vec3{point.head<3>() / point[3]});
    return box;
}

Parameter BezierPiece::wider() const
{
    // The middles of a net's sides tell the width also where corners meet.
    const auto point = [&](int i, int j) -> Vec3 {
        const auto column = net.col(Eigen::Index{j} * points_u + i);
        return column.head<3>() / column[3];
    };
    double width_u = 0;
    double width_v = 0;
    for (int j = 0; j < points_v; ++j)
        width_u = std::max(width_u, (point(points_u - 1, j) - point(0, j)).norm());
    for (int i = 0; i < points_u; ++i)
        width_v = std::max(width_v, (point(i, points_v - 1) - point(i, 0)).norm());
    if (width_u == width_v)  // closed or collapsed both ways, or a square
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
    // De Casteljau's pyramid at 1/2, row by row: its edges are the halves.
    for (int row = 0; row < rows; ++row) {
        const auto column = [&](BezierPiece& half, int k) {
            return half.net.col(Eigen::Index{row} * row_step + Eigen::Index{k} * step);
        };
        for (int level = 1; level < count; ++level) {
            for (int k = 0; k < count - level; ++k)
                column(high, k) = (column(high, k) + column(high, k + 1)) / 2;
            column(low, level) = column(high, 0);
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
    // A piece of diagonal d covers about d^2 / 3.
    const double size = std::max(piece_size, std::sqrt(3 * area(surfaces) / most_pieces));
    for (std::size_t number = 0; number < surfaces.size(); ++number)
        for (int j = 0; j < surfaces[number].patches(Parameter::V); ++j)
            for (int i = 0; i < surfaces[number].patches(Parameter::U); ++i)
                cut(whole_patch(surfaces[number], number, i, j), size, most_halvings,
                    pieces_);
    std::vector<std::int32_t> numbers(pieces_.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(pieces_.size());
    for (const BezierPiece& piece : pieces_)
        boxes.push_back(piece.box());
    nodes_.reserve(2 * numbers.size());
    nodes_.emplace_back();
    build_below(0, numbers, boxes, nodes_);
}

}  // namespace endmill
