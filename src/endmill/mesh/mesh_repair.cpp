// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/mesh_repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/orientation.h"
#include "endmill/mesh/detail/edge_uses.h"

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

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Box {
    Vec3 low = Vec3::Constant(infinity);  // mm
    Vec3 high = -low;

    void include(const Box& other)
    {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    // Whether the other box is strictly inside.
    bool holds(const Box& other) const
    {
        return (low.array() < other.low.array()).all() &&
               (high.array() > other.high.array()).all();
    }
    double side(int number) const { return number < 3 ? low[number] : high[number - 3]; }
};

Box box_of(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

// Finds the boxes that hold another. A box is a point of six coordinates, its sides;
// those of the boxes asked for are in an orthant. A tree halves the points at one
// coordinate after the other, those skipped that are equal for all: an orthant's border
// crosses, of n leaves, at most of the order of n^(5/6), and few where boxes are small.
class BoxTree {
public:
    explicit BoxTree(std::vector<Box> boxes) : boxes_{std::move(boxes)}
    {
        order_.resize(boxes_.size());
        std::iota(order_.begin(), order_.end(), std::int32_t{0});
        if (!order_.empty())
            add_node(0, order_.size(), 0);
    }

    // Calls `visit(number)` for the boxes that hold `inner`, in rising order, until it
    // returns true.
    template <typename Visit>
    void for_each_around(const Box& inner, const Visit& visit) const
    {
        // The least number below a node, and the node; -1 for a box itself.
        using Entry = std::pair<std::int32_t, std::int32_t>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
        const auto wait_for = [&](std::int32_t node) {
            if (nodes_[node].hull.holds(inner))
                waiting.emplace(nodes_[node].least, node);
        };
        if (!nodes_.empty())
            wait_for(0);
        while (!waiting.empty()) {
            const auto [number, node] = waiting.top();
            waiting.pop();
            if (node < 0) {
                if (visit(static_cast<std::size_t>(number)))
                    return;
            } else if (nodes_[node].second_child > 0) {
                wait_for(node + 1);
                wait_for(nodes_[node].second_child);
            } else {
                for (const std::int32_t box : leaf(nodes_[node]))
                    if (boxes_[box].holds(inner))
                        waiting.emplace(box, -1);
            }
        }
    }

private:
    struct Node {
        Box hull;
        std::int32_t least;         // number of a box below
        std::int32_t second_child;  // the first is the next node; 0: this is a leaf
        std::size_t begin;          // of the boxes of a leaf
        std::size_t count;
    };

    static constexpr std::size_t leaf_boxes = 8;

    std::span<const std::int32_t> leaf(const Node& node) const
    {
        return std::span{order_}.subspan(node.begin, node.count);
    }

    void add_node(std::size_t begin, std::size_t count, int side)
    {
        const std::span numbers = std::span{order_}.subspan(begin, count);
        const std::size_t node = nodes_.size();
        nodes_.push_back({{}, *std::ranges::min_element(numbers), 0, begin, count});
        for (const std::int32_t number : numbers)
            nodes_[node].hull.include(boxes_[number]);
        if (count <= leaf_boxes)
            return;
        for (int skipped = 0; skipped < 6 && is_alike(numbers, side); ++skipped)
            side = (side + 1) % 6;
        const std::size_t half = count / 2;
        std::ranges::nth_element(
            numbers, numbers.begin() + static_cast<std::ptrdiff_t>(half), {},
            [&](std::int32_t number) { return boxes_[number].side(side); });
        add_node(begin, half, (side + 1) % 6);
        nodes_[node].second_child = static_cast<std::int32_t>(nodes_.size());
        add_node(begin + half, count - half, (side + 1) % 6);
    }

    bool is_alike(std::span<const std::int32_t> numbers, int side) const
    {
        return std::ranges::all_of(numbers, [&](std::int32_t number) {
            return boxes_[number].side(side) == boxes_[numbers.front()].side(side);
        });
    }

    std::vector<Box> boxes_;
    std::vector<std::int32_t> order_;
    std::vector<Node> nodes_;
};

// The times that a ray from the origin along x leaves a mesh through this triangle, less
// those that it enters: 1, 0 or -1. What is hit is decided in the plane of y and z, for
// an edge and its opposite alike, so that no ray slips between two triangles.
int crossings(const std::array<Vec3, 3>& corners)
{
    std::array<double, 3> twice_area;  // of the origin with the side after corner k
    int turns = 0;
    for (int k = 0; k < 3; ++k) {
        const Vec3& from = corners[k];
        const Vec3& to = corners[(k + 1) % 3];
        twice_area[k] = from.y() * to.z() - to.y() * from.z();
        const bool rises = to.z() > 0;
        if ((from.z() > 0) != rises && (rises ? twice_area[k] > 0 : twice_area[k] < 0))
            turns += rises ? 1 : -1;
    }
    if (turns == 0)
        return 0;
    const double whole = twice_area[0] + twice_area[1] + twice_area[2];
    double hit = 0;
    for (int k = 0; k < 3; ++k) {
        const double share = whole == 0 ? 1.0 / 3 : twice_area[(k + 1) % 3] / whole;
        hit += share * corners[k].x();
    }
    return hit > 0 ? turns : 0;
}

// A piece of the mesh, all of it turned like the triangle that it has its name from.
struct Piece {
    std::vector<std::int32_t> triangles;
    std::size_t turned = 0;  // of them, against the first
    bool twisted = false;
    bool closed = true;
    double sixfold_volume = 0;  // mm^3
    double doubled_area = 0;    // mm^2
    Box box;
};

// Tells which points a closed piece has inside. A few questions look at every triangle,
// more are worth a tree.
class Interior {
public:
    Interior(const TriangleMesh& mesh, const Piece& piece,
             const std::vector<bool>& turned)
        : mesh_{&mesh},
          piece_{&piece},
          turned_{&turned}
    {
    }

    // Whether the piece winds around the point.
    bool contains(const Vec3& point)
    {
        constexpr int few_questions = 16;
        if (++questions_ == few_questions)
            plant_tree();
        int winding = 0;
        if (tree_)
            tree_->for_each_around({point, point}, [&](std::size_t k) {
                winding += crossings_of(piece_->triangles[k], point);
                return false;
            });
        else
            for (const std::int32_t triangle : piece_->triangles)
                winding += crossings_of(triangle, point);
        return winding != 0;
    }

private:
    int crossings_of(std::int32_t triangle, const Vec3& point) const
    {
        auto [a, b, c] = mesh_->corners(triangle);
        if ((*turned_)[triangle])
            std::swap(b, c);
        return crossings({a - point, b - point, c - point});
    }

    // Over the boxes in which a point must be for its ray to meet the triangle.
    void plant_tree()
    {
        std::vector<Box> boxes;
        boxes.reserve(piece_->triangles.size());
        for (const std::int32_t triangle : piece_->triangles) {
            const auto [a, b, c] = mesh_->corners(triangle);
            Box& box = boxes.emplace_back(box_of(a, b, c));
            for (int axis = 0; axis < 3; ++axis) {
                box.low[axis] = std::nextafter(box.low[axis], -infinity);
                box.high[axis] = std::nextafter(box.high[axis], infinity);
            }
            box.low.x() = -infinity;
        }
        tree_.emplace(std::move(boxes));
    }

    const TriangleMesh* mesh_;
    const Piece* piece_;
    const std::vector<bool>* turned_;
    int questions_ = 0;
    std::optional<BoxTree> tree_;
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
    std::vector<std::size_t> closed_pieces() const;
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
        piece.box.include(box_of(a, b, c));
    }
    const double rounding =
        volume_rounding * piece.doubled_area * (piece.box.high - piece.box.low).norm();
    piece.closed =
        piece.closed && !piece.twisted && std::abs(piece.sixfold_volume) > rounding;
}

// The closed pieces, the largest first.
std::vector<std::size_t> Orientation::closed_pieces() const
{
    std::vector<std::size_t> closed;
    for (std::size_t k = 0; k < pieces_.size(); ++k)
        if (pieces_[k].closed)
            closed.push_back(k);
    std::ranges::stable_sort(closed, std::ranges::greater{}, [&](std::size_t k) {
        return std::abs(pieces_[k].sixfold_volume);
    });
    return closed;
}

// For each piece the number of the largest closed one that encloses it, or its own.
std::vector<std::size_t> Orientation::outermost_around() const
{
    std::vector<std::size_t> around(pieces_.size());
    std::iota(around.begin(), around.end(), std::size_t{0});
    const std::vector<std::size_t> closed = closed_pieces();
    std::vector<Box> boxes;
    std::vector<Interior> interiors;
    for (const std::size_t k : closed) {
        boxes.push_back(pieces_[k].box);
        interiors.emplace_back(mesh_, pieces_[k], turned_);
    }
    const BoxTree tree{std::move(boxes)};
    for (std::size_t rank = 0; rank < closed.size(); ++rank) {
        const Piece& inner = pieces_[closed[rank]];
        const Vec3 eye = mesh_.corners(inner.triangles.front())[0];
        tree.for_each_around(inner.box, [&](std::size_t outer) {
            const bool is_found = outer < rank && interiors[outer].contains(eye);
            if (is_found)
                around[closed[rank]] = closed[outer];
            return is_found || outer > rank;
        });
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
