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

// A volume is only rounding error below this share of the piece's diagonal times its
// doubled area.
constexpr double volume_rounding = 1e-12;

std::vector<Vec3> copy_of_points(const TriangleMesh& mesh)
{
    return {mesh.points().begin(), mesh.points().end()};
}

std::vector<Triangle> copy_of_triangles(const TriangleMesh& mesh)
{
    return {mesh.triangles().begin(), mesh.triangles().end()};
}

// The piece of a triangle, named by its least triangle, and the orientation of the
// triangle relative to that one.
struct Membership {
    std::int32_t piece;
    bool turned;
};

// Disjoint sets of triangles (union-find) whose links also store the relative
// orientation.
class Pieces {
public:
    explicit Pieces(std::size_t triangles)
        : link_(triangles),
          one_sided_(triangles, false)
    {
        for (std::size_t k = 0; k < triangles; ++k)
            link_[k] = {static_cast<std::int32_t>(k), false};
    }

    // The piece of a triangle. Shortens the path to it on the way.
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

    // Joins the pieces of `a` and `b`, which have the same orientation or not. If both
    // are in one piece already and disagree, the piece cannot be oriented: it is
    // one-sided.
    void join(std::int32_t a, std::int32_t b, bool differ)
    {
        const Membership at_a = of(a);
        const Membership at_b = of(b);
        const bool roots_differ = (at_a.turned != at_b.turned) != differ;
        const auto [low, high] = std::minmax(at_a.piece, at_b.piece);
        if (low != high)
            link_[high] = {low, roots_differ};
        one_sided_[low] =
            one_sided_[low] || one_sided_[high] || (low == high && roots_differ);
    }

    bool is_one_sided(std::int32_t piece) const { return one_sided_[piece]; }

private:
    std::vector<Membership> link_;  // link to a triangle with the same or a lower number
    std::vector<bool> one_sided_;
};

Pieces pieces_of(const EdgeUses& edges, std::size_t triangles)
{
    Pieces pieces{triangles};
    edges.for_each([&](const MeshEdge&, std::span<const EdgeUse> uses) {
        if (uses.size() == 2)
            pieces.join(uses[0].triangle(), uses[1].triangle(),
                        uses[0].is_forward() == uses[1].is_forward());
    });
    return pieces;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

// A bounding box.
struct Box {
    Vec3 low = Vec3::Constant(infinity);  // mm; an empty box
    Vec3 high = -low;

    void include(const Box& other)
    {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    // Whether the other box is strictly inside this one.
    bool holds(const Box& other) const
    {
        return (low.array() < other.low.array()).all() &&
               (high.array() > other.high.array()).all();
    }
    // The six coordinates of the box, by number.
    double side(int number) const { return number < 3 ? low[number] : high[number - 3]; }
};

Box box_of(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

// Finds the boxes that contain a given box.
//
// A box is a point with six coordinates, its sides; the boxes that contain another one
// fill an orthant of this space. The tree halves the points by one coordinate after the
// other and skips a coordinate that is equal for all. The boundary of an orthant crosses
// at most of the order of n^(5/6) of n leaves, and few if the boxes are small. It is the
// only tree of the library that answers this question, and not a tuned kernel.
class BoxTree {
public:
    explicit BoxTree(std::vector<Box> boxes) : boxes_{std::move(boxes)}
    {
        order_.resize(boxes_.size());
        std::iota(order_.begin(), order_.end(), std::int32_t{0});
        if (!order_.empty())
            add_node(0, order_.size(), 0);
    }

    // Calls `visit(number)` for all boxes that contain `inner`, in rising order of their
    // numbers, until `visit` returns true.
    template <typename Visit>
    void for_each_around(const Box& inner, const Visit& visit) const
    {
        // The least box number below a node, and the node; the node is -1 for a single
        // box.
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
        std::int32_t least;         // least number of a box below
        std::int32_t second_child;  // the first child is the next node; 0 in a leaf
        std::size_t begin;          // first box of a leaf, in order_
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

// How often the ray from the origin along +x crosses a triangle: 1 if it leaves the mesh
// there, -1 if it enters, 0 if it misses. Whether it hits is decided in the yz plane, in
// the same way for both directions of an edge, so that no ray passes between two
// triangles.
int crossings(const std::array<Vec3, 3>& corners)
{
    // of the triangle made of the origin and the side after corner k
    std::array<double, 3> twice_area;
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

// A piece of the mesh. Its triangles are taken in the orientation of the first one.
struct Piece {
    std::vector<std::int32_t> triangles;
    std::size_t turned = 0;  // number of triangles turned against the first
    bool one_sided = false;
    bool closed = true;
    double sixfold_volume = 0;  // mm^3
    double doubled_area = 0;    // mm^2
    Box box;
};

// Decides which points are inside a closed piece. The first few queries test every
// triangle; after that a tree is built.
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
            build_tree();
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

    // Builds the tree over the boxes of points whose rays can meet a triangle: the
    // triangle's own box, extended to minus infinity along x.
    void build_tree()
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

// The work of `oriented`:
// 1. Join triangles across edges of two triangles, with their relative orientation.
// 2. Find out which pieces are closed, and measure volume, area and bounding box of each.
// 3. For each closed piece, find the largest closed piece around it.
// 4. Decide which pieces to turn over, and make the result.
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
    std::vector<std::size_t> piece_;  // piece of each triangle
    // whether each triangle is turned against its piece's first
    std::vector<bool> turned_;
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

// Lists the triangles of every piece, in rising order.
void Orientation::gather(Pieces& pieces)
{
    for (std::size_t k = 0; k < piece_.size(); ++k) {
        const auto triangle = static_cast<std::int32_t>(k);
        const Membership member = pieces.of(triangle);
        if (member.piece == triangle) {
            piece_[k] = pieces_.size();
            pieces_.emplace_back().one_sided = pieces.is_one_sided(triangle);
        } else {
            piece_[k] = piece_[member.piece];
        }
        turned_[k] = member.turned;
        pieces_[piece_[k]].triangles.push_back(triangle);
        pieces_[piece_[k]].turned += member.turned;
    }
}

// Marks pieces as open. A piece is closed if its triangles run along every edge equally
// often in both directions. This also holds for a body that touches another one along an
// edge.
void Orientation::open_where_unbalanced(const EdgeUses& edges)
{
    // piece, and 1 or -1 for forward or backward
    std::vector<std::pair<std::size_t, int>> directions;
    edges.for_each([&](const MeshEdge&, std::span<const EdgeUse> uses) {
        // both directions occur, unless the piece cannot be oriented
        if (uses.size() == 2)
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

// Volume and area are measured from a corner of the piece, so that it may lie far from
// the origin.
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
        piece.closed && !piece.one_sided && std::abs(piece.sixfold_volume) > rounding;
}

// The closed pieces, in order of falling volume.
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

// For each piece, the number of the largest closed piece that encloses it, or its own
// number.
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
        const Vec3 point = mesh_.corners(inner.triangles.front())[0];
        tree.for_each_around(inner.box, [&](std::size_t outer) {
            const bool is_found = outer < rank && interiors[outer].contains(point);
            if (is_found)
                around[closed[rank]] = closed[outer];
            return is_found || outer > rank;
        });
    }
    return around;
}

// Whether to turn each piece against the orientation of its first triangle.
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
        if (!pieces_[piece_[k]].one_sided && turned_[k] != over[piece_[k]]) {
            std::swap(triangles[k][1], triangles[k][2]);
            ++turned;
        }
    const auto unorientable = std::ranges::count_if(pieces_, &Piece::one_sided);
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
    const std::vector<std::int32_t> duplicates = duplicate_triangles(EdgeUses{with_area});
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
