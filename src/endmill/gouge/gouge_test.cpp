// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/gouge_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/container/small_vector.hpp>

#include "endmill/core/error.h"
#include "endmill/gouge/detail/piece_tree.h"
#include "endmill/gouge/detail/swept_axis.h"

namespace endmill {
namespace {

// Share of the tolerance: depths nearer to it remain undecided.
constexpr double undecided_share = 1e-3;
constexpr double pieces_per_radius = 2;
// Halvings of a piece: 2^-40 of its size is far below any resolution that rounding
// permits.
constexpr int most_halvings = 80;
// The plane parallel to a piece is tried after 4, 16, 28, ... halvings. Larger pieces of a
// curved part are rarely settled by it. At a tolerance of about R / 1000, few pieces of a
// curved part need 16 halvings, so that it is tried about once for each place.
constexpr int halvings_before_parallel = 4;
constexpr int halvings_between_parallel = 12;

// The search for points of the part that are nearer than `reach_` to the swept axis. A
// branch-and-bound search in the tree of Bezier pieces:
// 1. The bound of a box or of a piece is its smallest distance from the swept axis. Nodes
//    whose bound is not below the limit are dropped. Of two children the nearer one is
//    visited first.
// 2. The bound of a piece uses the plane at the point of the swept axis nearest to the
//    piece's middle. The swept axis is convex and stays on one side of the plane; the
//    control points on the other side give the distance. Where ball and part touch, the
//    error of this bound is of second order in the piece's size.
// 3. The corners of a piece are points of the part and give upper bounds of the distance.
//    A piece that both bounds do not settle is halved.
// 4. A test with a tolerance also uses the plane parallel to the piece, which has no error
//    on a flat face. Without it, a ball that touches a flat face along a long move would
//    need pieces about as small as the square root of R times the tolerance.
class NearSearch {
public:
    NearSearch(const PieceTree& tree, const SweptAxis& swept_axis, double radius,
               FinerPieces& finer)
        : tree_{tree},
          swept_axis_{swept_axis},
          radius_{radius},
          finer_{finer}
    {
    }

    GougeAnswer test(double tolerance)
    {
        reach_ = radius_ - tolerance;
        resolution_ = undecided_share * tolerance;
        stops_at_first_ = true;
        run();
        if (found_)
            return {Answer::Yes, found_};
        if (undecided_)
            return {Answer::Undecided, undecided_};
        return {Answer::No, std::nullopt};
    }

    std::optional<GougePlace> deepest(double resolution)
    {
        reach_ = radius_;
        resolution_ = resolution;
        run();
        return found_;
    }

private:
    // What is still to be searched: rarely more than its room on the stack.
    template <class Item>
    using Stack = boost::container::small_vector<Item, 32>;

    // A plane that has the swept axis on one side, where heights are not positive. Heights
    // are lower bounds of distances.
    struct Plane {
        Vec3 origin;
        Vec3 away;                // unit, to the other side; zero if there is no plane
        double squared_distance;  // of the place for which it was made, mm^2
    };

    // The plane at the point of the swept axis nearest to `middle`.
    Plane plane_to(const Vec3& middle) const
    {
        const Vec3 nearest = swept_axis_.nearest(middle);
        const Vec3 away = middle - nearest;
        const double distance = away.norm();
        return {nearest, distance == 0 ? Vec3{Vec3::Zero()} : Vec3{away / distance},
                away.squaredNorm()};
    }

    // A node of the tree that is still to be searched.
    struct OpenNode {
        std::int32_t number;
        double bound;
        double squared_distance;  // of its middle
    };

    OpenNode open_node(std::int32_t number) const
    {
        const auto [bound, squared_distance] = box_bound(tree_.nodes()[number].box);
        return {number, bound, squared_distance};
    }

    // A piece of the tree that is still to be searched.
    struct OpenPiece {
        std::int32_t number;
        double bound;
        double squared_distance;  // of its middle
        Plane plane;
    };

    OpenPiece open_piece(std::int32_t number) const
    {
        const PieceTree::Piece& piece = tree_.pieces()[number];
        const Plane plane = plane_to(piece.middle);
        return {number, piece.bezier.least_height(plane.away, plane.origin),
                plane.squared_distance, plane};
    }

    void run()
    {
        Stack<OpenNode> open{open_node(0)};
        while (!open.empty() && !is_over()) {
            const OpenNode own = open.back();
            open.pop_back();
            if (own.bound >= limit())
                continue;
            const std::int32_t link = tree_.nodes()[own.number].link;
            if (link < 0)
                search_pieces(~link);
            else
                push_nearer_last(open, open_node(link), open_node(link + 1));
        }
    }

    // Searches a patch and its halves that the tree contains.
    void search_pieces(std::int32_t patch)
    {
        Stack<OpenPiece> open{open_piece(patch)};
        while (!open.empty() && !is_over()) {
            const OpenPiece own = open.back();
            open.pop_back();
            if (own.bound >= limit())
                continue;
            const std::int32_t half = tree_.pieces()[own.number].halves;
            if (half == 0)
                search_finer(own);
            else
                push_nearer_last(open, open_piece(half), open_piece(half + 1));
        }
    }

    // Pushes two children such that the nearer one is visited first. Its points may
    // settle the other one.
    template <class Child>
    static void push_nearer_last(Stack<Child>& open, const Child& first,
                                 const Child& second)
    {
        const bool swap = second.squared_distance < first.squared_distance;
        open.push_back(swap ? first : second);
        open.push_back(swap ? second : first);
    }

    bool is_over() const { return stops_at_first_ && found_; }

    // Distances from here on are of no interest.
    double limit() const { return found_ ? reach_ - resolution_ : reach_; }

    // A lower bound of the distance of a box, and the squared distance of its middle.
    std::pair<double, double> box_bound(const Eigen::AlignedBox3d& box) const
    {
        const Vec3 middle = box.center();
        const Vec3 nearest = swept_axis_.nearest(middle);
        const Vec3 away = middle - nearest;
        const double distance = away.norm();
        if (distance == 0)
            return {0, 0};
        return {distance - away.cwiseAbs().dot(box.sizes()) / (2 * distance),
                away.squaredNorm()};
    }

    // A lower bound of the distance of a piece, by the plane that is parallel to it. Where
    // it exceeds the reach by the resolution, no half of the piece would be found or
    // undecided: it saves halvings and changes no answer.
    double parallel_bound(const BezierPiece& piece, const Vec3& middle) const
    {
        const Vec3 across = piece.corner(1, 1) - piece.corner(0, 0);
        const Vec3 other = piece.corner(0, 1) - piece.corner(1, 0);
        const Vec3 normal = across.cross(other).stableNormalized();
        const Vec3 nearest = swept_axis_.nearest(middle);
        const Vec3 away = normal.dot(middle - nearest) < 0 ? Vec3{-normal} : normal;
        return piece.least_height(away, nearest) -
               (swept_axis_.farthest_along(away) - away.dot(nearest));
    }

    void search_finer(const OpenPiece& leaf)
    {
        if (is_settled(tree_.pieces()[leaf.number], leaf.plane, leaf.bound, 0))
            return;
        struct Halved {
            std::int32_t number;
            int halvings;
        };
        Stack<Halved> open;
        const auto open_halves = [&](std::int32_t first, int halvings) {
            for (const std::int32_t half : {first + 1, first})
                if (!is_over() && !is_settled(finer_.piece(half), halvings))
                    open.push_back({half, halvings});
        };
        open_halves(finer_.halves_of_leaf(tree_, leaf.number), 1);
        while (!open.empty() && !is_over()) {
            const auto [number, halvings] = open.back();
            open.pop_back();
            open_halves(finer_.halves_of(number), halvings + 1);
        }
    }

    // Whether a half of a leaf needs no halving.
    bool is_settled(const PieceTree::Piece& whole, int halvings)
    {
        const Plane plane = plane_to(whole.middle);
        const double bound = whole.bezier.least_height(plane.away, plane.origin);
        return bound >= limit() || is_settled(whole, plane, bound, halvings);
    }

    // Whether a piece with a bound below the limit needs no halving. Its corners are
    // tested, and may become the point found.
    bool is_settled(const PieceTree::Piece& whole, const Plane& plane, double bound,
                    int halvings)
    {
        const BezierPiece& piece = whole.bezier;
        // Higher corners are neither found nor near enough to the bound to end the halvings.
        const double highest = halvings == most_halvings
                                   ? std::numeric_limits<double>::infinity()
                                   : reach_ + resolution_;
        const std::array corners{piece.corner(0, 0), piece.corner(1, 0),
                                 piece.corner(0, 1), piece.corner(1, 1)};
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t nearest_corner = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            if (plane.away.dot(corners[k] - plane.origin) >= highest)
                continue;
            const double distance = (corners[k] - swept_axis_.nearest(corners[k])).norm();
            if (distance < nearest) {
                nearest = distance;
                nearest_corner = k;
            }
        }
        const GougePlace place{piece.surface,
                               {nearest_corner % 2 == 0 ? piece.low.u : piece.high.u,
                                nearest_corner < 2 ? piece.low.v : piece.high.v},
                               corners[nearest_corner],
                               radius_ - nearest};
        if (nearest < reach_) {
            found_ = place;
            if (stops_at_first_)
                return true;
            reach_ = nearest;
        }
        if (bound >= limit())
            return true;
        if (stops_at_first_ &&
            halvings % halvings_between_parallel == halvings_before_parallel &&
            parallel_bound(piece, whole.middle) >= reach_ + resolution_)
            return true;
        if (nearest - bound < resolution_ || halvings == most_halvings) {
            if (stops_at_first_ && !undecided_)
                undecided_ = place;
            return true;
        }
        return false;
    }

    const PieceTree& tree_;
    const SweptAxis& swept_axis_;
    double radius_;
    FinerPieces& finer_;
    double reach_ = 0;
    double resolution_ = 0;
    bool stops_at_first_ = false;
    std::optional<GougePlace> found_;
    std::optional<GougePlace> undecided_;
};

}  // namespace

GougeTest::GougeTest(std::span<const Surface> surfaces, const BallCutter& cutter,
                     const Vec3& axis)
    : cutter_{cutter},
      axis_{axis},
      tree_{std::make_shared<const PieceTree>(surfaces,
                                              cutter.radius() / pieces_per_radius)}
{
}

GougeAnswer GougeTest::test(const BallMove& move, double tolerance) const
{
    FinerPieces finer;
    return test(move, tolerance, finer);
}

GougeAnswer GougeTest::test(const BallMove& move, double tolerance,
                            FinerPieces& finer) const
{
    require(0 < tolerance && tolerance < cutter_.radius(),
            "GougeTest: need 0 < tolerance < cutter radius");
    const SweptAxis swept_axis{move.from, move.to, axis_};
    finer.limit_memory();
    return NearSearch{*tree_, swept_axis, cutter_.radius(), finer}.test(tolerance);
}

std::optional<GougePlace> GougeTest::deepest(const BallMove& move,
                                             double resolution) const
{
    require(resolution > 0, "GougeTest: need 0 < resolution");
    const SweptAxis swept_axis{move.from, move.to, axis_};
    FinerPieces finer;
    return NearSearch{*tree_, swept_axis, cutter_.radius(), finer}.deepest(resolution);
}

}  // namespace endmill
