// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/cutting_coefficients.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/core/error.h"

// The table is a four-dimensional grid of coefficients. `coefficients` finds the cell of
// an engagement, interpolates linearly between its 16 corners and adds the closed share
// of the shank, which depends on the depth beyond the ball's radius.

namespace endmill {
namespace {

constexpr double largest_angle = 80 * std::numbers::pi / 180;
// Accuracy of the nodes, and of engagements that the table does not cover: far below the
// interpolation error of the table.
constexpr double node_accuracy = 1e-6;

using Coefficients = std::array<double, 8>;

Coefficients listed(const CuttingCoefficients& c)
{
    return {c.I1, c.I2, c.I3, c.I4, c.I5, c.I6, c.I7, c.I8};
}

bool is_from_to(int count, int least, int most)
{
    return count >= least && count <= most;
}

CoefficientTableOptions sound(const CoefficientTableOptions& options)
{
    require(is_from_to(options.angles, 2, 181) && is_from_to(options.pick_feeds, 2, 64) &&
                is_from_to(options.depths, 2, 64),
            "CoefficientTable: need 2 to 181 angles, 2 to 64 pick feeds and depths");
    return options;
}

// Angle in rad of a node.
double angle_of_node(int node, int count)
{
    return largest_angle * (2.0 * node / (count - 1) - 1);
}

// Pick feed or depth of a node, in radii of the ball.
double ratio_of_node(int node, int count)
{
    const double root = static_cast<double>(node) / (count - 1);
    return root * root;
}

// Position on one axis of the grid: the node below, and the fraction of the way to the
// node above.
struct GridPlace {
    int below;
    double share;
};

// `position` counts nodes. Positions at the upper end belong to the last cell.
GridPlace place(double position, int count)
{
    const int below = std::clamp(static_cast<int>(position), 0, count - 2);
    return {below, position - below};
}

GridPlace place_of_angle(double angle, int count)
{
    return place((angle / largest_angle + 1) / 2 * (count - 1), count);
}

// The interpolation is linear in the ratio itself, between nodes that are squares.
GridPlace place_of_ratio(double ratio, int count)
{
    const int below =
        std::clamp(static_cast<int>(std::sqrt(ratio) * (count - 1)), 0, count - 2);
    const double low = ratio_of_node(below, count);
    return {below, (ratio - low) / (ratio_of_node(below + 1, count) - low)};
}

// Number of array entries from a node to the next along an axis, and the fraction of the
// way.
struct GridStep {
    std::size_t nodes;
    double share;
};

// Multilinear interpolation between the 16 nodes around an engagement. `first` is the
// lowest of them. The nodes of the depth, the last axis, follow each other in memory.
ENDMILL_WIDEST_REGISTERS
Coefficients blended(const Coefficients* first, const std::array<GridStep, 3>& steps,
                     double depth_share)
{
    Coefficients sum{};
    for (int corner = 0; corner < 8; ++corner) {
        std::size_t at = 0;
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const bool is_next = ((corner >> axis) & 1) != 0;
            at += is_next ? steps[axis].nodes : 0;
            weight *= is_next ? steps[axis].share : 1 - steps[axis].share;
        }
        const Coefficients& low = first[at];
        const Coefficients& high = first[at + 1];
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] +=
                weight * (1 - depth_share) * low[k] + weight * depth_share * high[k];
    }
    return sum;
}

}  // namespace

CoefficientTable::CoefficientTable(ChipModel chip, const CoefficientTableOptions& options)
    : chip_{chip},
      options_{sound(options)}
{
    std::vector<BallEngagement> engagements;
    for (int i = 0; i < options_.angles; ++i)
        for (int j = 0; j < options_.angles; ++j)
            for (int k = 0; k < options_.pick_feeds; ++k)
                for (int l = 0; l < options_.depths; ++l)
                    engagements.push_back({angle_of_node(i, options_.angles),
                                           angle_of_node(j, options_.angles),
                                           ratio_of_node(k, options_.pick_feeds),
                                           ratio_of_node(l, options_.depths)});
    for (const CuttingCoefficients& node :
         cutting_coefficients(engagements, chip, node_accuracy))
        nodes_.push_back(listed(node));
}

bool CoefficientTable::covers(const BallEngagement& engagement) const
{
    return engagement.previous == PreviousPass::Beside &&
           std::abs(engagement.mu) <= largest_angle &&
           std::abs(engagement.lambda) <= largest_angle &&
           engagement.pick_feed_ratio <= 1;
}

CuttingCoefficients CoefficientTable::coefficients(const BallEngagement& engagement) const
{
    require_sound(engagement);
    if (is_air(engagement))
        return {};
    if (!covers(engagement))
        return cutting_coefficients(engagement, chip_, node_accuracy);
    const GridPlace mu = place_of_angle(engagement.mu, options_.angles);
    const GridPlace lambda = place_of_angle(engagement.lambda, options_.angles);
    const GridPlace feed =
        place_of_ratio(engagement.pick_feed_ratio, options_.pick_feeds);
    const GridPlace depth =
        place_of_ratio(std::min(1.0, engagement.depth_ratio), options_.depths);
    const std::size_t feed_step = options_.depths;
    const std::size_t lambda_step = feed_step * options_.pick_feeds;
    const std::size_t mu_step = lambda_step * options_.angles;
    std::size_t first = mu.below * mu_step + lambda.below * lambda_step;
    first += feed.below * feed_step + depth.below;
    const Coefficients sum = blended(
        &nodes_[first],
        {{{mu_step, mu.share}, {lambda_step, lambda.share}, {feed_step, feed.share}}},
        depth.share);
    const CuttingCoefficients ball{sum[0], sum[1], sum[2], sum[3],
                                   sum[4], sum[5], sum[6], sum[7]};
    return engagement.depth_ratio <= 1
               ? ball
               : endmill::sum(ball, shank_coefficients(engagement, chip_));
}

}  // namespace endmill
