// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_branch.h"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <queue>
#include <vector>

#include "endmill/setup/detail/rectangle_bound.h"
#include "endmill/setup/detail/setup_order.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

// rad: narrower pieces are not split. 1e4 roundings of an angle; and what a rectangle of any
// length can gain by so little is below `branch_accuracy` of a square degree.
constexpr double narrowest = 1e-12;

// Positions of R1 between which no direction changes its side.
struct Piece {
    R1Azimuth left;
    R1Azimuth right;
    double bound;        // rad^2
    std::size_t number;  // in the order of creation

    double middle() const { return (left.angle + right.angle) / 2; }

    // The one to be split first is the largest of a std::priority_queue.
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

    // R1 at `azimuth`, directions on the sides on which they are with R1 at `beside`.
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

    // R1 at every fifth degree.
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

    // Whether nothing above this bound is asked for: nor a hair below, since bounds have
    // roundings, and what equals the worth is asked for.
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

    // The same, or if a direction is opposite to the tool axis with it on either side.
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
    if (goal.limits)  // what fits for so little of R1 that no piece would show it
        branching.evaluate_coarsely();
    branching.search();
    if (branching.has_dropped())
        return std::nullopt;
    return branching.best();
}

}  // namespace endmill
