// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/mesh_repair.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/mesh/collinear.h"
#include "endmill/mesh/edge_uses.h"

namespace endmill {
namespace {

// A volume below this share of diagonal times doubled area may be all rounding.
constexpr double volume_rounding = 1e-12;

std::vector<Vec3> copy_of_points(const TriangleMesh& mesh)
{
    return {mesh.points().begin(), mesh.points().end()};
}

std::vector<Triangle> copy_of_triangles(const TriangleMesh& mesh)
{
    return {mesh.triangles().begin(), mesh.triangles().end()};
}

// Which piece a triangle belongs to, by the piece's least triangle, and whether it is
// turned over against that one.
struct Membership {
    std::int32_t piece;
    bool turned;
};

// Disjoint sets of triangles whose members know how they are turned to each other.
class Pieces {
public:
    explicit Pieces(std::size_t triangles) : link_(triangles), twisted_(triangles, false)
    {
        for (std::size_t k = 0; k < triangles; ++k)
            link_[k] = {static_cast<std::int32_t>(k), false};
    }

    Membership of(std::int32_t triangle)
    {
        bool turned = false;
        while (link_[triangle].piece != triangle) {
            const Membership next = link_[link_[triangle].piece];
            link_[triangle] = {next.piece, link_[triangle].turned != next.turned};
            turned = turned != link_[triangle].turned;
            triangle = link_[triangle].piece;
        }
        return {triangle, turned};
    }

    // Makes one piece of two, of which `a` and `b` are turned alike or not. Where they
    // were one piece and it does not agree, the piece has one side only.
    void join(std::int32_t a, std::int32_t b, bool differ)
    {
        const Membership at_a = of(a);
        const Membership at_b = of(b);
        const bool roots_differ = (at_a.turned != at_b.turned) != differ;
        const auto [low, high] = std::minmax(at_a.piece, at_b.piece);
        if (low != high)
            link_[high] = {low, roots_differ};
        twisted_[low] = twisted_[low] || twisted_[high] || (low == high && roots_differ);
    }

    bool is_twisted(std::int32_t piece) const { return twisted_[piece]; }

private:
    std::vector<Membership> link_;  // to a triangle with a number no higher
    std::vector<bool> twisted_;
};

Pieces pieces_of(const EdgeUses& edges, std::size_t triangles)
{
    Pieces pieces{triangles};
    edges.for_each([&](const Edge&, std::span<const EdgeUse> uses) {
        if (uses.size() == 2)
            pieces.join(uses[0].triangle(), uses[1].triangle(),
                        uses[0].is_forward() == uses[1].is_forward());
    });
    return pieces;
}

// A piece of the mesh, all of it turned like the triangle that it has its name from.
struct Piece {
    std::vector<std::int32_t> triangles;
    std::size_t turned = 0;  // of them, against the first
    bool twisted = false;
    bool closed = true;
    double sixfold_volume = 0;  // mm^3
    double doubled_area = 0;    // mm^2
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;
};

class Orientation {
public:
    explicit Orientation(const TriangleMesh& mesh);
    OrientedMesh result() const;

private:
    std::array<Vec3, 3> corners(std::int32_t triangle) const;
    void gather(Pieces& pieces);
    void open_where_unbalanced(const EdgeUses& edges);
    void measure(Piece& piece) const;
    bool encloses(const Piece& outer, const Piece& inner) const;
    std::vector<std::size_t> outermost_around() const;
    std::vector<bool> turn_over() const;

    const TriangleMesh& mesh_;
    std::vector<Piece> pieces_;
    std::vector<std::size_t> piece_;  // of each triangle
    std::vector<bool> turned_;        // each triangle, against its piece's first
};

Orientation::Orientation(const TriangleMesh& mesh)
    : mesh_{mesh},
      piece_(mesh.triangles().size()),
      turned_(mesh.triangles().size())
{
    const EdgeUses edges{mesh};
    Pieces pieces = pieces_of(edges, mesh.triangles().size());
    gather(pieces);
    open_where_unbalanced(edges);
    for (Piece& piece : pieces_)
        measure(piece);
}

void Orientation::gather(Pieces& pieces)
{
    for (std::size_t k = 0; k < piece_.size(); ++k) {
        const auto triangle = static_cast<std::int32_t>(k);
        const Membership member = pieces.of(triangle);
        if (member.piece == triangle) {
            piece_[k] = pieces_.size();
            pieces_.emplace_back().twisted = pieces.is_twisted(triangle);
        } else {
            piece_[k] = piece_[member.piece];
        }
        turned_[k] = member.turned;
        pieces_[piece_[k]].triangles.push_back(triangle);
        pieces_[piece_[k]].turned += member.turned;
    }
}

// A piece is closed if at every edge as many of its triangles run each way; so are bodies
// that touch along an edge.
void Orientation::open_where_unbalanced(const EdgeUses& edges)
{
    std::vector<std::pair<std::size_t, int>> directions;  // piece, forward or backward
    edges.for_each([&](const Edge&, std::span<const EdgeUse> uses) {
        if (uses.size() == 2)  // balanced, unless the piece is twisted
            return;
        directions.clear();
        for (const EdgeUse& use : uses) {
            const bool forward = use.is_forward() != turned_[use.triangle()];
            directions.emplace_back(piece_[use.triangle()], forward ? 1 : -1);
        }
        std::ranges::sort(directions);
        for (std::size_t k = 0, end = 0; k < directions.size(); k = end) {
            int surplus = 0;
            for (end = k;
                 end < directions.size() && directions[end].first == directions[k].first;
                 ++end)
                surplus += directions[end].second;
            if (surplus != 0)
                pieces_[directions[k].first].closed = false;
        }
    });
}

std::array<Vec3, 3> Orientation::corners(std::int32_t triangle) const
{
    std::array<Vec3, 3> corners = mesh_.corners(triangle);
    if (turned_[triangle])
        std::swap(corners[1], corners[2]);
    return corners;
}

void Orientation::measure(Piece& piece) const
{
    const Vec3 origin = corners(piece.triangles.front())[0];
    for (const std::int32_t triangle : piece.triangles) {
        const auto [a, b, c] = corners(triangle);
        const Vec3 doubled = (b - a).cross(c - a);
        piece.sixfold_volume += (a - origin).dot(doubled);
        piece.doubled_area += doubled.norm();
        piece.low = piece.low.cwiseMin(a).cwiseMin(b).cwiseMin(c);
        piece.high = piece.high.cwiseMax(a).cwiseMax(b).cwiseMax(c);
    }
    const double rounding =
        volume_rounding * piece.doubled_area * (piece.high - piece.low).norm();
    piece.closed =
        piece.closed && !piece.twisted && std::abs(piece.sixfold_volume) > rounding;
}

// Whether a corner of `inner` sees `outer` all around: the sum of the triangles' solid
// angles (formula of van Oosterom and Strackee) is 4 pi inside, else 0.
bool Orientation::encloses(const Piece& outer, const Piece& inner) const
{
    const Vec3 eye = mesh_.corners(inner.triangles.front())[0];
    double half_angle = 0;
    for (const std::int32_t triangle : outer.triangles) {
        const auto [p, q, r] = corners(triangle);
        const Vec3 a = p - eye;
        const Vec3 b = q - eye;
        const Vec3 c = r - eye;
        const double la = a.norm();
        const double lb = b.norm();
        const double lc = c.norm();
        half_angle += std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc +
                                                        b.dot(c) * la + c.dot(a) * lb);
    }
    return std::abs(half_angle) > std::numbers::pi;
}

// For each piece the number of the largest closed one that encloses it, or its own. A
// sweep along x: a box that is strictly inside another begins after it and ends before.
std::vector<std::size_t> Orientation::outermost_around() const
{
    std::vector<std::size_t> around(pieces_.size());
    std::iota(around.begin(), around.end(), std::size_t{0});
    std::vector<std::size_t> order = around;
    std::erase_if(order, [&](std::size_t k) { return !pieces_[k].closed; });
    std::ranges::stable_sort(order, {},
                             [&](std::size_t k) { return pieces_[k].low.x(); });
    std::vector<std::size_t> open;  // those that the sweep is in
    for (const std::size_t k : order) {
        const Piece& inner = pieces_[k];
        std::erase_if(open,
                      [&](std::size_t n) { return pieces_[n].high.x() < inner.low.x(); });
        double largest = std::abs(inner.sixfold_volume);
        for (const std::size_t n : open) {
            const Piece& outer = pieces_[n];
            if ((outer.low.array() < inner.low.array()).all() &&
                (outer.high.array() > inner.high.array()).all() &&
                std::abs(outer.sixfold_volume) > largest && encloses(outer, inner)) {
                largest = std::abs(outer.sixfold_volume);
                around[k] = n;
            }
        }
        open.push_back(k);
    }
    return around;
}

// Which pieces are to be turned like the opposite of their first triangle.
std::vector<bool> Orientation::turn_over() const
{
    const auto most_are_turned = [&](const Piece& piece) {
        return 2 * piece.turned > piece.triangles.size();
    };
    const auto points_inwards = [](const Piece& piece) {
        return piece.closed && piece.sixfold_volume < 0;
    };
    const std::vector<std::size_t> around = outermost_around();
    std::vector<bool> over;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
        const Piece& outer = pieces_[around[k]];
        const bool outer_is_inside_out =
            outer.closed && most_are_turned(outer) != points_inwards(outer);
        over.push_back(most_are_turned(pieces_[k]) != outer_is_inside_out);
    }
    return over;
}

OrientedMesh Orientation::result() const
{
    const std::vector<bool> over = turn_over();
    std::vector<Triangle> triangles = copy_of_triangles(mesh_);
    std::size_t turned = 0;
    for (std::size_t k = 0; k < triangles.size(); ++k)
        if (!pieces_[piece_[k]].twisted && turned_[k] != over[piece_[k]]) {
            std::swap(triangles[k][1], triangles[k][2]);
            ++turned;
        }
    const auto unorientable = std::ranges::count_if(pieces_, &Piece::twisted);
    return {{copy_of_points(mesh_), std::move(triangles)},
            turned,
            static_cast<std::size_t>(unorientable)};
}

}  // namespace

CleanedMesh without_degenerate_or_duplicate(const TriangleMesh& mesh)
{
    std::vector<Triangle> kept;
    kept.reserve(mesh.triangles().size());
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const auto [a, b, c] = mesh.corners(k);
        if (!are_collinear(a, b, c))
            kept.push_back(mesh.triangles()[k]);
    }
    const std::size_t degenerate = mesh.triangles().size() - kept.size();
    const TriangleMesh with_area{copy_of_points(mesh), std::move(kept)};
    const std::vector<std::int32_t> duplicates =
        duplicate_triangles(with_area, EdgeUses{with_area});
    std::vector<Triangle> single;
    single.reserve(with_area.triangles().size() - duplicates.size());
    auto next = duplicates.begin();
    for (std::size_t k = 0; k < with_area.triangles().size(); ++k)
        if (next != duplicates.end() && static_cast<std::size_t>(*next) == k)
            ++next;
        else
            single.push_back(with_area.triangles()[k]);
    return {{copy_of_points(mesh), std::move(single)}, degenerate, duplicates.size()};
}

OrientedMesh oriented(const TriangleMesh& mesh)
{
    return Orientation{mesh}.result();
}

}  // namespace endmill
