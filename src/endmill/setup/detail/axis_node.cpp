// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/axis_node.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>

#include "endmill/setup/detail/range_limits.h"
#include "endmill/visibility/sphere_grid.h"

// How a node of radius rho is bounded.
//
// 1. Moving the axis by at most rho changes the level of a cell by at most rho, and its
//    azimuth by at most asin(sin rho / sin p) at an angle p from the axis. `axis_view`
//    lists the intervals of azimuth that each cell may have.
// 2. A box of levels is split until its sides are about rho. Before each split the
//    coverage table tests whether any window can meet all cones with the cells of the
//    box; most boxes end here.
// 3. For a small box WindowSweep finds the least window that meets an interval of every
//    cone. The objective of this window and of the lower levels is the bound of the box.
// 4. A box whose bound reaches the target is dropped.
//
// A node of arcs uses the same steps with the normal of a great circle as its axis and a
// band about the circle as its box. Its window is the length of the arc.

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

/// rad, added to a node's radius. It covers the rounding of levels, azimuths near the
/// axis, and of the radius itself, which are 1e-15 each.
constexpr double angle_rounding = 1e-12;

/// Relative, subtracted from a bound: it covers a few roundings of 1.1e-16.
constexpr double bound_rounding = 1e-14;

/// Grid of the triangles with which the search begins: 320 cells.
constexpr const char* root_grid = "ico:2";

/// Bound, in rad, by which the distance of two directions of a lune along its middle
/// circle can exceed the difference of their latitudes, divided by 2: the maximum over b
/// of atan2(tan b, cos t) - b for the half width t of the lune.
/// Source: paper/notes/whole-cones.md, section 7, (a).
double lune_slack(double t)
{
    const double tangent = std::tan(t / 2);
    return std::asin(std::min(tangent * tangent, 1.0));
}

/// The side at which boxes are no longer split, in radii of their node. Smaller boxes
/// would not improve the bound, because the radius moves levels as much.
/// `is_fine` asks for sides that give the best bound, in C,A.
double least_box(NodeKind kind, RotaryFamily family, bool is_fine)
{
    if (kind != NodeKind::Axis || family != RotaryFamily::CA)
        return 1;
    return is_fine ? 0.75 : 3;
}

/// rad, for problems whose cones grow: below this radius boxes of C,A are fine. Many
/// cones have flat optima, about which the radius must be small, and fine boxes allow
/// twice the radius. Larger nodes are hardly ever excluded.
constexpr double fine_radius = 0.07;

/// Two cell centres, unit vectors, are opposite if their sum is shorter than this. The
/// sum of opposite centres is a few roundings of 1e-16, that of any other pair is above
/// 1e-2.
constexpr double opposite_sum = 1e-6;

/// One cell of each pair of opposite cells.
std::vector<std::size_t> half_of(const SphereGrid& grid)
{
    std::vector<std::size_t> half;
    for (std::size_t k = 0; k < grid.cells.size(); ++k) {
        const bool has_opposite =
            std::any_of(half.begin(), half.end(), [&](std::size_t other) {
                return (grid.centres[k] + grid.centres[other]).norm() < opposite_sum;
            });
        if (!has_opposite)
            half.push_back(k);
    }
    return half;
}

/// The cells up to these levels whose azimuths may lie in a window.
std::vector<std::uint32_t> met_cells(const AxisView& view, const LevelLimits& upto,
                                     const AzimuthWindow& window)
{
    std::vector<std::uint32_t> cells;
    for (const SeenCell& cell : view.free)
        if (cell.level <= upto.upto[cell.side])
            cells.push_back(cell.cell);
    for (const SeenCell& cell : view.swept) {
        if (cell.level > upto.upto[cell.side])
            continue;
        double from_begin = cell.end - window.begin + angle_rounding;
        from_begin -= 2 * pi * std::floor(from_begin / (2 * pi));
        if (from_begin <= window.width + cell.end - cell.begin + 2 * angle_rounding)
            cells.push_back(cell.cell);
    }
    return cells;
}

AxisNode root_node(const SphereGrid& grid, std::size_t cell, NodeKind kind, LevelBox box)
{
    const Triangle& triangle = grid.cells[cell];
    AxisNode node{{}, kind, {box}, 0};
    for (std::size_t k = 0; k < 3; ++k)
        node.corners[k] = grid.corners[triangle[k]];
    return node;
}

}  // namespace

Vec3 centre(const AxisNode& node)
{
    return (node.corners[0] + node.corners[1] + node.corners[2]).normalized();
}

double radius(const AxisNode& node)
{
    const Vec3 middle = centre(node);
    double farthest = 0;
    for (const Vec3& corner : node.corners)
        farthest = std::max(farthest, 2 * std::asin((corner - middle).norm() / 2));
    return farthest;
}

AxisNode part(const AxisNode& node, int number)
{
    const auto& [a, b, c] = node.corners;
    const Vec3 ab = (a + b).normalized();
    const Vec3 bc = (b + c).normalized();
    const Vec3 ca = (c + a).normalized();
    const std::array<std::array<Vec3, 3>, 4> parts{
        {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}};
    return {parts[std::size_t(number)], node.kind, node.boxes, node.bound};
}

double thin_width(const PoseMeasure& measure, double best)
{
    constexpr double widest = 10 * pi / 180;
    switch (measure.objective) {
        case SetupObjective::FlooredArea:
            return std::min(measure.floor_rad / 3, widest);
        case SetupObjective::TotalRange:
            return std::min(best / 50, widest);
        case SetupObjective::Tilt:
            break;
    }
    return 0;
}

std::vector<AxisNode> root_nodes(const ConeFitting& fitting)
{
    const SphereGrid grid = sphere_grid(root_grid);
    const std::vector<std::size_t> half = half_of(grid);
    const double thin = fitting.thin_width;
    std::vector<AxisNode> nodes;
    const double far = fitting.limits.farthest();
    const LevelBox all{{0, 0}, {far, far}, 0};
    const bool is_ca = fitting.measure.family == RotaryFamily::CA;
    for (std::size_t k = 0; k < (is_ca ? grid.cells.size() : half.size()); ++k)
        nodes.push_back(root_node(grid, is_ca ? k : half[k], NodeKind::Axis, all));
    const LevelBox band{{0, 0}, {thin / 2, thin / 2}, 0};
    if (thin > 0)
        for (const std::size_t k : half)
            nodes.push_back(root_node(grid, k, NodeKind::Arc, band));
    return nodes;
}

NodeBounder::NodeBounder(const ConeFitting& fitting)
    : fitting_{fitting},
      sweep_{*fitting.cones},
      table_{*fitting.cones}
{
}

NodeBounder::Useful NodeBounder::useful(NodeKind kind, const LevelBox& box,
                                        double target) const
{
    const PoseMeasure& measure = fitting_.measure;
    const RangeLimits& limits = fitting_.limits;
    if (kind == NodeKind::Arc) {
        if (2 * box.low[0] > limits.widest())
            return {0, -1};
        const double height =
            std::min(measure.useful_height(target, 2 * box.low[0]), limits.highest());
        return {0, height > 0 ? height + 2 * lune_slack(box.high[0]) : -1};
    }
    const bool is_ca = measure.family == RotaryFamily::CA;
    if (!limits.hold(box.low[0], box.low[1]) ||
        rises_freely(measure, limits, box.high[0], box.low[1]) ||
        rises_freely(measure, limits, box.high[1], box.low[0]) ||
        (is_ca && box.low[1] > 0 &&
         box.low[1] >= box.high[0]))  // here m0 < m1: exchange them
        return {0, -1};
    const double m0 = is_ca ? std::max(box.low[0], box.low[1]) : box.low[0];
    const double width =
        std::min(measure.useful_width(target, m0, box.low[1]), limits.widest());
    const double thin = fitting_.thin_width;
    return {thin, thin < width ? width : -1};
}

double NodeBounder::objective(NodeKind kind, const LevelBox& box, double window) const
{
    PoseRanges least{window, box.low[0], box.low[1]};
    if (kind == NodeKind::Arc)
        least = {2 * box.low[0], std::max(window - 2 * lune_slack(box.high[0]), 0.0), 0};
    else if (fitting_.measure.family == RotaryFamily::CA)
        least.m0 = std::max(least.m0, least.m1);
    return fitting_.measure(least) * (1 - bound_rounding);
}

void NodeBounder::split(NodeKind kind, const LevelBox& box)
{
    const std::array<double, 2> middle{(box.low[0] + box.high[0]) / 2,
                                       (box.low[1] + box.high[1]) / 2};
    for (int quarter = 0; quarter < 4; ++quarter) {
        const std::array<int, 2> upper{quarter % 2, quarter / 2};
        if (kind == NodeKind::Arc && upper[0] != upper[1])
            continue;  // both sides are the same half width
        LevelBox piece = box;
        for (std::size_t side = 0; side < 2; ++side)
            (upper[side] != 0 ? piece.low : piece.high)[side] = middle[side];
        open_.push_back(piece);
    }
}

/// The least window up to these levels. If the cells that it meets miss cones, adds some
/// and searches once more: the children of the node and later boxes profit from them.
/// The places of the window remain valid, because further cones only exclude windows.
std::optional<AzimuthWindow> NodeBounder::least_window(const LevelLimits& upto,
                                                       double cap, const GrowCones& grow)
{
    const auto places = table_.places(upto, cap);
    auto least = sweep_.least(view_, places, upto, cap);
    if (!least || !grow || !grow(met_cells(view_, upto, *least)))
        return least;
    least = sweep_.least(view_, places, upto, cap);
    table_.fill(view_, reach_);
    return least;
}

void NodeBounder::bound(AxisNode& node, double target, const GrowCones& grow)
{
    const double rho = radius(node) + angle_rounding;
    std::array<double, 2> reach{0, 0};
    for (const LevelBox& box : node.boxes)
        for (std::size_t side = 0; side < 2; ++side)
            reach[side] = std::max(reach[side], box.high[side]);
    const bool is_arc = node.kind == NodeKind::Arc;
    const RotaryFamily family = is_arc ? RotaryFamily::AB : fitting_.measure.family;
    view_ = axis_view({family, centre(node), rho, reach}, fitting_.centres);
    reach_ = {reach[0] + rho, reach[1] + rho};
    table_.fill(view_, reach_);

    const double smallest =
        least_box(node.kind, fitting_.measure.family, grow && rho < fine_radius) * rho;
    open_.swap(node.boxes);
    node.boxes.clear();
    node.bound = std::numeric_limits<double>::infinity();
    while (!open_.empty()) {
        LevelBox box = open_.back();
        open_.pop_back();
        const Useful window = useful(node.kind, box, target);
        const LevelLimits upto{{box.high[0] + rho, box.high[1] + rho}};
        if (window.to < 0 || box.bound >= target)
            continue;
        if (std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]) > smallest) {
            if (table_.may_fit(upto, window.to))
                split(node.kind, box);
            continue;
        }
        const double cap = window.to + angle_rounding;
        const auto least = least_window(upto, cap, grow);
        if (!least)
            continue;
        const double width = std::max(least->width - angle_rounding, window.from);
        box.bound = std::max(box.bound, objective(node.kind, box, width));
        if (box.bound >= target)
            continue;
        node.boxes.push_back(box);
        node.bound = std::min(node.bound, box.bound);
    }
    open_.clear();
}

}  // namespace endmill
