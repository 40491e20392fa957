// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/extent.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/surface/detail/bernstein_net.h"

namespace endmill {
namespace {

// Difference, as a share of the diagonal, between an upper bound and an attained value at
// which the search stops.
constexpr double bound_gap = 1e-9;
constexpr double coordinate_rounding =
    1e-14;  // of a coordinate, for bounds far from the origin

// A piece of a patch, given by the polynomials w r . direction and w on it.
struct BoundedPiece {
    double bound;  // upper bound of r . direction on the piece
    BernsteinPiece height;
    BernsteinPiece weight;

    bool operator<(const BoundedPiece& other) const { return bound < other.bound; }
};

// The greatest entry at the four corners of a net.
double greatest_corner(const Eigen::ArrayXXd& net)
{
    const auto last_row = net.rows() - 1;
    const auto last_column = net.cols() - 1;
    return std::max(
        {net(0, 0), net(last_row, 0), net(0, last_column), net(last_row, last_column)});
}

template <class Use>
void for_each_patch(const Surface& surface, const Use& use)
{
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i)
            use(surface.patch(i, j));
}

Eigen::ArrayXXd heights_of(const BernsteinNet& height, const BernsteinNet& weight)
{
    return height.array() / weight.array();
}

// Greatest value of r . direction, which a point of the surface attains.
//
// Branch and bound. The quotients of the Bernstein coefficients bound r . direction on a
// piece, and those at its corners are attained. Pieces wait in a queue in the order of
// their bounds. The piece with the greatest bound is halved, until no bound exceeds the
// best attained value by more than the tolerance.
double greatest_height(const Surface& surface, const Vec3& direction)
{
    double attained = -std::numeric_limits<double>::infinity();
    for_each_patch(surface, [&](const BezierPatch& patch) {
        attained = std::max(
            attained,
            greatest_corner(heights_of(height_net(patch, direction), weight_net(patch))));
    });
    const auto may_reach_higher = [&](double bound) {
        return bound > attained + bound_gap * surface.diagonal() +
                           coordinate_rounding * std::abs(attained);
    };
    std::priority_queue<BoundedPiece> pieces;
    const auto add = [&](BernsteinPiece height, BernsteinPiece weight) {
        const Eigen::ArrayXXd heights = heights_of(height.net, weight.net);
        attained = std::max(attained, greatest_corner(heights));
        const double bound = heights.maxCoeff();
        if (may_reach_higher(bound))
            pieces.push({bound, std::move(height), std::move(weight)});
    };
    for_each_patch(surface, [&](const BezierPatch& patch) {
        add({height_net(patch, direction), {0, 0}, 1, 1},
            {weight_net(patch), {0, 0}, 1, 1});
    });
    while (!pieces.empty() && may_reach_higher(pieces.top().bound)) {
        auto [low, high] = halves(pieces.top().height);
        auto [low_weight, high_weight] = halves(pieces.top().weight);
        pieces.pop();
        add(std::move(low), std::move(low_weight));
        add(std::move(high), std::move(high_weight));
    }
    return attained;
}

}  // namespace

Interval extent(const Surface& surface, const Vec3& direction)
{
    return {-greatest_height(surface, -direction), greatest_height(surface, direction)};
}

Interval extent(std::span<const Surface> surfaces, const Vec3& direction)
{
    require(!surfaces.empty(), "extent: need a surface");
    Interval whole = extent(surfaces.front(), direction);
    for (const Surface& surface : surfaces.subspan(1)) {
        const auto [low, high] = extent(surface, direction);
        whole = {std::min(whole.low, low), std::max(whole.high, high)};
    }
    return whole;
}

}  // namespace endmill
