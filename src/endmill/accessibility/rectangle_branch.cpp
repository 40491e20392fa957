// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/accessibility/rectangle_branch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <queue>
#include <vector>

#include "endmill/accessibility/setup_order.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

// rad: narrower pieces are not split. 1e4 roundings of an angle; and what a rectangle of any
// length can gain by so little is below `branch_accuracy` of a square degree.
constexpr double narrowest = 1e-12;

// Keeps s / z finite at z = 0, where it stands for alpha = +-90 degrees.
constexpr double least_height = 1e-200;

// Of z: the alpha of lower directions passes so quickly through 0, where R1 has their azimuth,
// that pieces of R1 as narrow as can be leave more than what is certified.
constexpr double steep_height = 1e-3;

// A direction less than 90 degrees from the tool axis, or just that.
struct HighPoint {
    double x;
    double y;
    double inverse_z;

    // Whether R1, off by `across` to the side, lies along it, so that it needs no alpha.
    bool is_along_r1(double across) const
    {
        return inverse_z * equal_angles >= 1 &&
               std::hypot(across, 1 / inverse_z) <= equal_angles;
    }
};

// One beyond; not opposite to the tool axis.
struct LowPoint {
    double x;
    double y;
    double rho;    // distance from the tool axis
    double depth;  // -z > 0

    // As for a HighPoint.
    bool is_along_r1(double across) const
    {
        return depth <= equal_angles && std::hypot(across, depth) <= equal_angles;
    }
};

// Of R1.
struct Azimuth {
    double angle;  // rad
    double cosine;
    double sine;

    explicit Azimuth(double value)
        : angle{value},
          cosine{std::cos(value)},
          sine{std::sin(value)}
    {
    }

    double along(double x, double y) const { return x * cosine + y * sine; }   // sin beta
    double across(double x, double y) const { return x * sine - y * cosine; }  // s
};

// Largest extents on either side, as what they are found from. The larger |alpha| of the low
// points are those of small |s| / depth.
struct Extents {
    double tangent_plus = 0;
    double tangent_minus = 0;
    double ratio_plus = infinity;
    double ratio_minus = infinity;
    double sine_plus = 0;
    double sine_minus = 0;

    RotaryRange alpha(bool has_opposite) const
    {
        double plus =
            ratio_plus < infinity ? pi - std::atan(ratio_plus) : std::atan(tangent_plus);
        double minus = ratio_minus < infinity ? pi - std::atan(ratio_minus)
                                              : std::atan(tangent_minus);
        if (has_opposite)  // at 180 degrees on either side
            (plus >= minus ? plus : minus) = pi;
        return {0 - minus, plus};
    }

    RotaryRange beta() const
    {
        return {0 - std::asin(std::min(sine_minus, 1.0)),
                std::asin(std::min(sine_plus, 1.0))};
    }
};

// Positions of R1 between which no low point changes its side.
struct Piece {
    Azimuth left;
    Azimuth right;
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
          goal_{goal}
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            add(points, i);
    }

    // R1 at `azimuth`, the low points on the sides on which they are with R1 at `beside`.
    void evaluate(const Azimuth& azimuth, const Azimuth& beside)
    {
        Extents extents;
        for (const HighPoint& p : high_) {
            const double s = azimuth.across(p.x, p.y);
            if (!p.is_along_r1(s))
                add_sides(extents.tangent_plus, extents.tangent_minus, s * p.inverse_z);
        }
        for (const LowPoint& p : low_) {
            const double s = azimuth.across(p.x, p.y);
            if (p.is_along_r1(s))
                continue;
            if (beside.across(p.x, p.y) > 0)
                extents.ratio_plus =
                    std::min(extents.ratio_plus, std::max(s, 0.0) / p.depth);
            else
                extents.ratio_minus =
                    std::min(extents.ratio_minus, std::max(-s, 0.0) / p.depth);
        }
        for (const HighPoint& p : high_)
            add_sides(extents.sine_plus, extents.sine_minus, azimuth.along(p.x, p.y));
        for (const LowPoint& p : low_)
            add_sides(extents.sine_plus, extents.sine_minus, azimuth.along(p.x, p.y));
        offer(azimuth, extents);
    }

    // R1 at every fifth degree.
    void evaluate_coarsely()
    {
        constexpr int steps = 36;
        for (int i = 0; i < steps; ++i) {
            const Azimuth azimuth{i * pi / steps};
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
            const Azimuth middle{piece.middle()};
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
    void add(const PolePoints& points, std::size_t i)
    {
        const double x = points.x[i];
        const double y = points.y[i];
        const double z = points.z[i];
        const double azimuth = points.azimuth(i);
        const double half_turn = azimuth < 0 ? azimuth + pi : azimuth;
        if (z >= 0) {
            high_.push_back({x, y, 1 / std::max(z, least_height)});
            if (z < steep_height)
                splits_.push_back(half_turn);
            return;
        }
        const double rho = std::hypot(x, y);
        if (rho < equal_angles) {
            has_opposite_ = true;
            return;
        }
        low_.push_back({x, y, rho, -z});
        splits_.push_back(half_turn);
    }

    static void add_sides(double& plus, double& minus, double value)
    {
        plus = std::max(plus, value);
        minus = std::max(minus, -value);
    }

    void offer(const Azimuth& azimuth, const Extents& extents)
    {
        const RectangleCandidate rectangle{
            azimuth.cosine * frame_.x + azimuth.sine * frame_.y,
            extents.alpha(has_opposite_), extents.beta(), RectangleOrigin::Search};
        if (!goal_.limits || fits_rigidly(rectangle, *goal_.limits))
            best_.offer(rectangle, {rectangle.area(), rectangle.sum()});
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
        std::vector<double> splits = splits_;
        splits.push_back(0);
        std::sort(splits.begin(), splits.end());
        splits.push_back(splits.front() + pi);
        for (std::size_t i = 0; i + 1 < splits.size(); ++i) {
            if (splits[i + 1] - splits[i] < narrowest)
                continue;
            const Azimuth left{splits[i]};
            const Azimuth right{splits[i + 1]};
            const Azimuth middle{(splits[i] + splits[i + 1]) / 2};
            evaluate(left, middle);
            evaluate(right, middle);
            push(pieces, left, right);
        }
    }

    void push(std::priority_queue<Piece>& pieces, const Azimuth& left,
              const Azimuth& right)
    {
        Piece piece{left, right, 0, created_++};
        const Extents least = least_extents(piece);
        const RectangleCandidate bound{Vec3::Zero(), least.alpha(has_opposite_),
                                       least.beta(), RectangleOrigin::Search};
        piece.bound = bound.area();
        if (!goal_.limits || fits_rigidly(bound, *goal_.limits))
            pieces.push(piece);
    }

    Extents least_extents(const Piece& piece) const
    {
        const Azimuth& l = piece.left;
        const Azimuth& r = piece.right;
        Extents least;
        for (const HighPoint& p : high_) {
            add_least(least.tangent_plus, least.tangent_minus,
                      l.across(p.x, p.y) * p.inverse_z, r.across(p.x, p.y) * p.inverse_z);
            add_least(least.sine_plus, least.sine_minus, l.along(p.x, p.y),
                      r.along(p.x, p.y));
        }
        const Azimuth middle{piece.middle()};
        for (const LowPoint& p : low_) {
            const double left = l.along(p.x, p.y);
            const double right = r.along(p.x, p.y);
            add_least(least.sine_plus, least.sine_minus, left, right);
            // |s| = rho where sin beta = 0.
            const bool has_peak = (left > 0) != (right > 0);
            const double ratio = (has_peak ? p.rho
                                           : std::max(std::abs(l.across(p.x, p.y)),
                                                      std::abs(r.across(p.x, p.y)))) /
                                 p.depth;
            double& side =
                middle.across(p.x, p.y) > 0 ? least.ratio_plus : least.ratio_minus;
            side = std::min(side, ratio);
        }
        return least;
    }

    static void add_least(double& plus, double& minus, double left, double right)
    {
        plus = std::max(plus, std::min(left, right));
        minus = std::max(minus, std::min(-left, -right));
    }

    PoleFrame frame_;
    BranchGoal goal_;
    BestCandidate<RectangleCandidate> best_;
    std::vector<HighPoint> high_;
    std::vector<LowPoint> low_;
    std::vector<double> splits_;  // rad, from 0 to pi: alpha jumps or passes 0 there
    bool has_opposite_ = false;
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
