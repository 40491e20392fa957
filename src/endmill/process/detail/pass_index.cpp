// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/pass_index.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/core/parallel.h"

// The tree is searched depth-first for each move:
// 1. A node is skipped if all its moves come later, if the plane across the move misses
//    its box, or if the box is farther away than the nearest crossings found so far. The
//    eight children of a node are tested at once.
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
        if (const double length = std::sqrt(std::norm(way)); length > 0)
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

// What a box is tested by, in the frame of the boxes.
struct PassIndex::Query {
    std::uint32_t end;  // only moves before this index are considered
    Vec3 middle;        // mm
    Vec3 direction;
    Vec3 left;  // unit vector, horizontal
    Bound left_bound;
    Bound right_bound;

    // Falls when a bound falls.
    double both_bounds() const { return left_bound.square + right_bound.square; }
};

struct PassIndex::Search {
    const CutMove* move;
    Vec3 middle;
    Vec3 direction;
    Vec3 left;  // unit vector, horizontal
    double reach;
    Query turned;
    NeighbouringPasses found = {};
};

PassIndex::PassIndex(std::span<const CutMove> moves)
    : moves_{moves},
      turn_{turn_along(moves)}
{
    std::vector<Node> nodes = build_leaves();
    levels_.push_back(groups_of(nodes));
    while (levels_.back().size() > 1) {
        nodes = nodes_around(nodes);
        levels_.push_back(groups_of(nodes));
    }
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
// connected, such as at the end of a pass. Returns their nodes.
std::vector<PassIndex::Node> PassIndex::build_leaves()
{
    for (std::size_t first = 0; first < moves_.size();) {
        std::size_t end = first + 1;
        while (end < std::min(first + leaf_moves, moves_.size()) &&
               moves_[end].from() == moves_[end - 1].to())
            ++end;
        const Leaf leaf{static_cast<std::uint32_t>(first),
                        static_cast<std::uint32_t>(end)};
        leaves_.push_back(leaf);
        first = end;
    }
    std::vector<Node> nodes(leaves_.size());
    parallel_for(nodes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            nodes[i] = {box_of(leaves_[i]), leaves_[i].first};
    });
    double extents = 0;
    for (const Node& node : nodes)
        extents += 2 * node.box.half.x();
    const double width = leaves_a_strip * extents / static_cast<double>(leaves_.size());
    std::vector<std::pair<double, std::uint32_t>> order;  // strips with their leaves
    order.reserve(leaves_.size());
    for (const Node& node : nodes)
        order.emplace_back(width > 0 ? std::floor(node.box.centre.x() / width) : 0,
                           static_cast<std::uint32_t>(order.size()));
    std::ranges::sort(order);
    std::vector<Leaf> leaves;
    std::vector<Node> sorted;
    leaves.reserve(order.size());
    sorted.reserve(order.size());
    for (const auto& [strip, leaf] : order) {
        leaves.push_back(leaves_[leaf]);
        sorted.push_back(nodes[leaf]);
    }
    leaves_ = std::move(leaves);
    return sorted;
}

std::vector<PassIndex::Group> PassIndex::groups_of(std::span<const Node> nodes)
{
    Group unused{};
    unused.first.fill(std::numeric_limits<std::uint32_t>::max());
    std::vector<Group> groups((nodes.size() + lanes - 1) / lanes, unused);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        Group& group = groups[i / lanes];
        const std::size_t lane = i % lanes;
        for (int axis = 0; axis < 3; ++axis) {
            group.centre[axis][lane] = nodes[i].box.centre[axis];
            group.half[axis][lane] = nodes[i].box.half[axis];
        }
        group.first[lane] = nodes[i].first;
    }
    return groups;
}

// The nodes that each enclose a group of nodes.
std::vector<PassIndex::Node> PassIndex::nodes_around(std::span<const Node> nodes)
{
    std::vector<Node> around;
    around.reserve((nodes.size() + lanes - 1) / lanes);
    for (std::size_t begin = 0; begin < nodes.size(); begin += lanes) {
        Vec3 low = nodes[begin].box.centre - nodes[begin].box.half;
        Vec3 high = nodes[begin].box.centre + nodes[begin].box.half;
        std::uint32_t first = nodes[begin].first;
        for (std::size_t i = begin + 1; i < std::min(begin + lanes, nodes.size()); ++i) {
            low = low.cwiseMin(nodes[i].box.centre - nodes[i].box.half);
            high = high.cwiseMax(nodes[i].box.centre + nodes[i].box.half);
            first = std::min(first, nodes[i].first);
        }
        around.push_back({{(low + high) / 2, (high - low) / 2}, first});
    }
    return around;
}

// The lanes, as bits, whose box the plane intersects, and which come near enough on a side
// that the box reaches.
ENDMILL_WIDEST_REGISTERS
unsigned PassIndex::lanes_near(const Query& query, const Group& group)
{
    const double mx = query.middle.x();
    const double my = query.middle.y();
    const double mz = query.middle.z();
    const double dx = query.direction.x();
    const double dy = query.direction.y();
    const double dz = query.direction.z();
    const double lx = query.left.x();
    const double ly = query.left.y();
    const double left = query.left_bound.box_square;
    const double right = query.right_bound.box_square;
    std::array<unsigned, lanes> near;
    ENDMILL_NOT_UNROLLED
    for (std::size_t k = 0; k < lanes; ++k) {
        const double x = group.centre[0][k] - mx;
        const double y = group.centre[1][k] - my;
        const double z = group.centre[2][k] - mz;
        const double half_x = group.half[0][k];
        const double half_y = group.half[1][k];
        const double half_z = group.half[2][k];
        const double from_plane =
            std::abs(x * dx + y * dy + z * dz) -
            (half_x * std::abs(dx) + half_y * std::abs(dy) + half_z * std::abs(dz));
        const double side = x * lx + y * ly;
        const double half_width =
            half_x * std::abs(lx) + half_y * std::abs(ly) + same_place_mm;
        const double left_bound = side + half_width >= 0 ? left : 0;
        const double right_bound = side - half_width <= 0 ? right : 0;
        const double bound = left_bound > right_bound ? left_bound : right_bound;
        const double gap_x = std::abs(x) - half_x;
        const double gap_y = std::abs(y) - half_y;
        const double gap_z = std::abs(z) - half_z;
        const double outside_x = gap_x > 0 ? gap_x : 0;
        const double outside_y = gap_y > 0 ? gap_y : 0;
        const double outside_z = gap_z > 0 ? gap_z : 0;
        const double square =
            outside_x * outside_x + outside_y * outside_y + outside_z * outside_z;
        const bool is_near = static_cast<unsigned>(from_plane <= same_place_mm) &
                             static_cast<unsigned>(square < bound);
        near[k] = is_near ? 1U : 0U;
    }
    unsigned bits = 0;
    for (std::size_t k = 0; k < lanes; ++k)
        bits |= (group.first[k] < query.end ? near[k] : 0U) << k;
    return bits;
}

// Intersects the moves of a leaf with the plane and keeps the nearest crossings.
void PassIndex::look_into(Search& search, const Leaf& leaf) const
{
    for (std::size_t i = std::min<std::size_t>(leaf.end, search.turned.end);
         i-- > leaf.first;) {
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
        Bound& bound = is_left ? search.turned.left_bound : search.turned.right_bound;
        auto& found = is_left ? search.found.left : search.found.right;
        const double square = distance * distance;
        if (square > bound.square ||
            (square == bound.square && !(found && found->move < i)))
            continue;
        bound = Bound{distance};
        found = {i, share, offset, distance};
    }
}

// Visits the nodes of a group of a level, and their children. The moves cut last are most
// likely the nearest; visiting them first tightens the bounds.
void PassIndex::descend(Search& search, std::size_t level, std::size_t group) const
{
    unsigned near = lanes_near(search.turned, levels_[level][group]);
    while (near != 0) {
        const auto lane = static_cast<unsigned>(std::bit_width(near)) - 1;
        near ^= 1U << lane;
        const std::size_t node = lanes * group + lane;
        const double bounds = search.turned.both_bounds();
        if (level == 0)
            look_into(search, leaves_[node]);
        else
            descend(search, level - 1, node);
        if (near != 0 && search.turned.both_bounds() < bounds)
            near &= lanes_near(search.turned, levels_[level][group]);
    }
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
                  .middle = middle,
                  .direction = direction,
                  .left = left,
                  .reach = reach,
                  .turned = {.end = static_cast<std::uint32_t>(move),
                             .middle = turn_ * middle,
                             .direction = turn_ * direction,
                             .left = turn_ * left,
                             .left_bound = Bound{reach},
                             .right_bound = Bound{reach}}};
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
