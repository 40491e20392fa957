// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_branch.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <queue>
#include <vector>

#include "endmill/core/tolerance.h"
#include "endmill/setup/detail/rectangle_bound.h"
#include "endmill/setup/detail/setup_order.h"

// Branch and bound over the azimuth psi of R1.
//
// A direction (x, y, z) has s = x sin psi - y cos psi, tan alpha = s / z and sin beta = x
// cos psi + y sin psi.
// 1. The half turn of psi is cut at the azimuths at which an alpha jumps. These intervals
//    are the first pieces. R1 at both of their ends is evaluated.
// 2. RectangleNeeds bounds the area over a piece from below.
// 3. The piece of least bound is split in the middle, where R1 is evaluated, until the
//    bound is within `branch_accuracy` of the best rectangle.

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

// rad; narrower pieces are not split. This is 1e4 roundings of an angle, and such a
// change of R1 changes an area by less than `branch_accuracy` of a square degree.
constexpr double narrowest = 1e-12;

// An interval of azimuths of R1 in which no direction changes its side.
struct Piece {
    R1Azimuth left;
    R1Azimuth right;
    double bound;        // rad^2, lower bound of the area
    std::size_t number;  // order of creation

    double middle() const { return (left.angle + right.angle) / 2; }

    // Orders a std::priority_queue so that its top has the least bound, then the least
    // number.
    friend bool operator<(const Piece& a, const Piece& b)
    {
        return a.bound != b.bound ? a.bound > b.bound : a.number > b.number;
    }
};

class Branching {
public:
    Branching(const PolePoints& points, const BranchGoal& goal)
        : frame_{points.frame},
          needs_{points},
          goal_{goal}
    {
    }

    // Evaluates R1 at `azimuth`. Low directions have the sign of alpha that they have
    // with R1 at `beside`.
    void evaluate(const R1Azimuth& azimuth, const R1Azimuth& beside)
    {
        const Vec3 r1_axis = azimuth.cosine * frame_.x + azimuth.sine * frame_.y;
        for (const RectangleExtents& extents :
             with_opposite(needs_.at(azimuth, beside))) {
            const RectangleCandidate rectangle = candidate(r1_axis, extents);
            if (fits(rectangle))
                best_.offer(rectangle, {rectangle.area(), rectangle.sum()});
        }
    }

    // Evaluates R1 at every multiple of 5 degrees.
    void evaluate_coarsely()
    {
        constexpr int steps = 36;
        for (int i = 0; i < steps; ++i) {
            const R1Azimuth azimuth{i * pi / steps};
            evaluate(azimuth, azimuth);
        }
    }

    void search()
    {
        std::priority_queue<Piece> pieces;
        push_roots(pieces);
        while (!pieces.empty()) {
            const Piece piece = pieces.top();
            pieces.pop();
            if (is_settled(piece.bound))
                return;
            if (piece.right.angle - piece.left.angle < narrowest)
                continue;
            const R1Azimuth middle{piece.middle()};
            evaluate(middle, middle);
            push(pieces, piece.left, middle);
            push(pieces, middle, piece.right);
        }
    }

    std::optional<RectangleCandidate> best() const { return best_.best(); }

    // Tests whether all areas above this bound are of no interest. The tolerance is
    // applied twice: once because an area equal to the limit is of interest, once for the
    // rounding of bounds.
    bool is_worthless(double bound) const
    {
        return bound > equal_area_limit(equal_area_limit(goal_.worthless));
    }

    bool has_dropped() const { return has_dropped_; }

private:
    static RectangleCandidate candidate(const Vec3& r1_axis,
                                        const RectangleExtents& extents)
    {
        return {r1_axis, extents.alpha, extents.beta, RectangleOrigin::Search};
    }

    // The extents; or, if a direction is opposite to the tool axis, two extents that
    // reach it on either side.
    std::vector<RectangleExtents> with_opposite(const RectangleExtents& extents) const
    {
        if (!needs_.has_opposite())
            return {extents};
        return {{{extents.alpha.from, pi}, extents.beta},
                {{-pi, extents.alpha.to}, extents.beta}};
    }

    bool fits(const RectangleCandidate& rectangle) const
    {
        return !goal_.limits || fits_rigidly(rectangle, *goal_.limits);
    }

    bool is_settled(double bound)
    {
        const double best = best_.area();
        if (best < infinity &&
            bound >= best - branch_accuracy * std::max(best, square_degree))
            return true;
        has_dropped_ = is_worthless(bound);
        return has_dropped_;
    }

    void push_roots(std::priority_queue<Piece>& pieces)
    {
        std::vector<double> splits = needs_.splits();
        splits.push_back(0);
        std::sort(splits.begin(), splits.end());
        splits.push_back(splits.front() + pi);
        for (std::size_t i = 0; i + 1 < splits.size(); ++i) {
            if (splits[i + 1] - splits[i] < narrowest)
                continue;
            const R1Azimuth left{splits[i]};
            const R1Azimuth right{splits[i + 1]};
            const R1Azimuth middle{(splits[i] + splits[i + 1]) / 2};
            evaluate(left, middle);
            evaluate(right, middle);
            push(pieces, left, right);
        }
    }

    void push(std::priority_queue<Piece>& pieces, const R1Azimuth& left,
              const R1Azimuth& right)
    {
        const RectangleBound bound = needs_.over(left, right);
        const std::vector<RectangleExtents> sides = with_opposite(bound.extents);
        double area = infinity;
        for (std::size_t side = 0; side < sides.size(); ++side)
            if (fits(candidate(Vec3::Zero(), sides[side])))
                area = std::min(area, bound.areas.at(side));
        if (area < infinity)
            pieces.push({left, right, area, created_++});
    }

    PoleFrame frame_;
    RectangleNeeds needs_;
    BranchGoal goal_;
    BestCandidate<RectangleCandidate> best_;
    bool has_dropped_ = false;
    std::size_t created_ = 0;
};

}  // namespace

std::optional<RectangleCandidate> coarse_rectangle(const PolePoints& points,
                                                   const BranchGoal& goal)
{
    Branching branching{points, goal};
    branching.evaluate_coarsely();
    return branching.best();
}

std::optional<RectangleCandidate> branch_rectangle(const PolePoints& points,
                                                   const BranchGoal& goal)
{
    Branching branching{points, goal};
    // A rectangle may fit the limits for a single azimuth, which no piece would show.
    if (goal.limits)
        branching.evaluate_coarsely();
    branching.search();
    if (branching.has_dropped())
        return std::nullopt;
    return branching.best();
}

}  // namespace endmill
