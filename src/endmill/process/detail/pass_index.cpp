// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/pass_index.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>

// The tree is searched depth-first for each move:
// 1. A node is skipped if all its moves come later, if the plane across the move misses
//    its box, or if the box is farther away than the nearest crossings found so far.
// 2. In a leaf every move is intersected with the plane, and the nearest crossing on each
//    side is kept.
// 3. The later child is visited first, because the pass cut last is most likely the
//    nearest. Its crossings reduce the reach of the rest of the search.
// The result does not depend on the order of the visits: of equally near crossings the one
// cut last is kept, and boxes are enlarged by more than the rounding of a distance.

namespace endmill {
namespace {

constexpr std::size_t leaf_moves = 8;

// Number of moves on either side of a crossing among which the crossing of the next move is
// likely: passes have moves of about equal lengths.
constexpr std::size_t around_moves = 2;

// Width of a strip in mean extents of a leaf. Where passes are curved, the boxes of narrow
// strips overlap less. Where a plane runs at an angle to the strips, it meets fewer wide
// ones.
constexpr double leaves_a_strip = 4;

// Relative rounding error of a rotated box, by which boxes are enlarged.
constexpr double box_rounding = 1e-14;

// Least horizontal share of the pick feed. Below it the pass lies straight above or below
// up to rounding, and the slope of the pick feed is undefined.
constexpr double least_side_share = 1e-6;

// Crossings closer than this coincide with the move: coordinates in files have no more
// digits.
constexpr double same_place_mm = 1e-9;

// The rotation about z that turns the mean direction of the moves into the x axis.
// Opposite directions count as equal: the mean is taken of the doubled angles.
Eigen::Matrix3d turn_along(std::span<const CutMove> moves)
{
    std::complex<double> doubled{0, 0};
    for (const CutMove& move : moves) {
        const std::complex<double> way{move.to().x() - move.from().x(),
                                       move.to().y() - move.from().y()};
        if (const double length = std::abs(way); length > 0)
            doubled += way * way / length;
    }
    return Eigen::AngleAxisd{-std::arg(doubled) / 2, Vec3::UnitZ()}.toRotationMatrix();
}

}  // namespace

// A bound of the distance on one side of a move.
struct PassIndex::Bound {
    double square;      // mm2, squared distance below which a crossing is accepted
    double box_square;  // mm2, squared distance up to which a box may hold one

    explicit Bound(double distance)
        : square{distance * distance},
          box_square{(distance + same_place_mm) * (distance + same_place_mm)}
    {
    }
};

struct PassIndex::Search {
    const CutMove* move;
    std::size_t end;  // only moves before this index are considered
    Vec3 middle;
    Vec3 direction;
    Vec3 left;  // unit vector, horizontal
    double reach;
    Vec3 turned_middle;
    Vec3 turned_direction;
    Vec3 turned_left;
    Bound left_bound;
    Bound right_bound;
    NeighbouringPasses found = {};
};

PassIndex::PassIndex(std::span<const CutMove> moves)
    : moves_{moves},
      turn_{turn_along(moves)}
{
    build_leaves();
    while (levels_.back().size() > 1)
        build_level();
}

PassIndex::Box PassIndex::box_of(const Leaf& leaf) const
{
    Vec3 low = turn_ * moves_[leaf.first].from();
    Vec3 high = low;
    for (std::size_t i = leaf.first; i < leaf.end; ++i)
        for (const Vec3* tip : {&moves_[i].from(), &moves_[i].to()}) {
            const Vec3 place = turn_ * *tip;
            low = low.cwiseMin(place);
            high = high.cwiseMax(place);
        }
    const Vec3 margin = box_rounding * (low.cwiseAbs() + high.cwiseAbs());
    return {(low + high) / 2, (high - low) / 2 + margin};
}

// Divides the moves into leaves and sorts them. A leaf ends where its moves are not
// connected, such as at the end of a pass.
void PassIndex::build_leaves()
{
    std::vector<Node> nodes;
    double extents = 0;
    for (std::size_t first = 0; first < moves_.size();) {
        std::size_t end = first + 1;
        while (end < std::min(first + leaf_moves, moves_.size()) &&
               moves_[end].from() == moves_[end - 1].to())
            ++end;
        const Leaf leaf{static_cast<std::uint32_t>(first),
                        static_cast<std::uint32_t>(end)};
        leaves_.push_back(leaf);
        nodes.push_back({box_of(leaf), leaf.first});
        extents += 2 * nodes.back().box.half.x();
        first = end;
    }
    const double width = leaves_a_strip * extents / static_cast<double>(leaves_.size());
    const auto strip = [&](std::size_t leaf) {
        return width > 0 ? std::floor(nodes[leaf].box.centre.x() / width) : 0;
    };
    std::vector<std::uint32_t> order(leaves_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, {}, [&](std::uint32_t leaf) {
        return std::pair{strip(leaf), leaf};
    });
    std::vector<Leaf> leaves;
    std::vector<Node> level;
    leaves.reserve(order.size());
    level.reserve(order.size());
    for (const std::uint32_t leaf : order) {
        leaves.push_back(leaves_[leaf]);
        level.push_back(nodes[leaf]);
    }
    leaves_ = std::move(leaves);
    levels_.push_back(std::move(level));
}

// Adds the level whose boxes each enclose two boxes of the level below.
void PassIndex::build_level()
{
    const std::vector<Node>& below = levels_.back();
    std::vector<Node> level;
    level.reserve((below.size() + 1) / 2);
    for (std::size_t i = 0; i < below.size(); i += 2) {
        const Node& first = below[i];
        const Node& second = below[std::min(i + 1, below.size() - 1)];
        const Box& one = first.box;
        const Box& other = second.box;
        const Vec3 low = (one.centre - one.half).cwiseMin(other.centre - other.half);
        const Vec3 high = (one.centre + one.half).cwiseMax(other.centre + other.half);
        level.push_back(
            {{(low + high) / 2, (high - low) / 2}, std::min(first.first, second.first)});
    }
    levels_.push_back(std::move(level));
}

// Whether the plane intersects the box, and the box comes near enough on a side that it
// reaches.
bool PassIndex::may_hold(const Search& search, const Box& box) const
{
    const Vec3 offset = box.centre - search.turned_middle;
    if (std::abs(offset.dot(search.turned_direction)) >
        box.half.dot(search.turned_direction.cwiseAbs()) + same_place_mm)
        return false;
    const double side = offset.dot(search.turned_left);
    const double half_width = box.half.dot(search.turned_left.cwiseAbs()) + same_place_mm;
    double bound = 0;
    if (side + half_width >= 0)
        bound = search.left_bound.box_square;
    if (side - half_width <= 0)
        bound = std::max(bound, search.right_bound.box_square);
    return (offset.cwiseAbs() - box.half).cwiseMax(0).squaredNorm() < bound;
}

// Intersects the moves of a leaf with the plane and keeps the nearest crossings.
void PassIndex::look_into(Search& search, const Leaf& leaf) const
{
    for (std::size_t i = std::min<std::size_t>(leaf.end, search.end); i-- > leaf.first;) {
        const CutMove& other = moves_[i];
        const double before = (other.from() - search.middle).dot(search.direction);
        const double after = (other.to() - search.middle).dot(search.direction);
        if ((before > 0 && after > 0) || (before < 0 && after < 0) ||
            std::abs(after - before) < other.length_mm / std::numbers::sqrt2)
            continue;
        const double share = std::clamp(before / (before - after), 0.0, 1.0);
        const double between =
            search.move->middle_mm() - (other.begin_mm + share * other.length_mm);
        if (other.pass() == search.move->pass() && between < search.reach)
            continue;
        const Vec3 offset =
            search.middle - other.from() - share * (other.to() - other.from());
        const double distance = offset.norm();
        // The offset points from the pass to the stock, so the pass lies on the opposite
        // side.
        const double side = -offset.dot(search.left);
        if (distance > same_place_mm && std::abs(side) < least_side_share * distance)
            continue;
        const bool is_left = side >= 0 || distance <= same_place_mm;
        Bound& bound = is_left ? search.left_bound : search.right_bound;
        auto& found = is_left ? search.found.left : search.found.right;
        const double square = distance * distance;
        if (square > bound.square ||
            (square == bound.square && !(found && found->move < i)))
            continue;
        bound = Bound{distance};
        found = {i, share, offset, distance};
    }
}

// Visits a node of a level, and its children.
void PassIndex::descend(Search& search, std::size_t level, std::size_t node) const
{
    if (node >= levels_[level].size() || levels_[level][node].first >= search.end ||
        !may_hold(search, levels_[level][node].box))
        return;
    if (level == 0) {
        look_into(search, leaves_[node]);
        return;
    }
    // The moves cut last are most likely the nearest; visiting them first tightens the
    // bounds.
    descend(search, level - 1, 2 * node + 1);
    descend(search, level - 1, 2 * node);
}

// Looks around the crossings of a move nearby first, which lowers the bounds at once.
NeighbouringPasses PassIndex::beside(std::size_t move, double reach,
                                     const NeighbouringPasses& nearby) const
{
    const CutMove& own = moves_[move];
    const Vec3 direction = own.direction();
    const Vec3 left = Vec3{-direction.y(), direction.x(), 0}.normalized();
    const Vec3 middle = own.middle();
    Search search{.move = &own,
                  .end = move,
                  .middle = middle,
                  .direction = direction,
                  .left = left,
                  .reach = reach,
                  .turned_middle = turn_ * middle,
                  .turned_direction = turn_ * direction,
                  .turned_left = turn_ * left,
                  .left_bound = Bound{reach},
                  .right_bound = Bound{reach}};
    for (const auto& crossing : {nearby.left, nearby.right})
        if (crossing) {
            const std::size_t first =
                std::max(crossing->move, around_moves) - around_moves;
            look_into(search, {static_cast<std::uint32_t>(first),
                               static_cast<std::uint32_t>(std::min(
                                   crossing->move + around_moves + 1, moves_.size()))});
        }
    descend(search, levels_.size() - 1, 0);
    return search.found;
}

}  // namespace endmill
