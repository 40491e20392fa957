// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/tool_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace endmill {
namespace {

constexpr std::uint32_t leaf_size = 4;
// Margin in mm of bounding volumes, above the rounding of coordinates up to 1e6 mm.
constexpr double rounding_margin = 1e-8;

// Returns the squared distance of two segments. The nearest place on the first is that of
// the lines, clamped; from it follows the one on the second, and from that the first again.
double squared_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    const Vec3 first = b - a;
    const Vec3 second = d - c;
    const Vec3 between = a - c;
    const double aa = first.squaredNorm();
    const double bb = second.squaredNorm();
    const double ab = first.dot(second);
    const double at_a = first.dot(between);
    const double at_b = second.dot(between);
    const double across = aa * bb - ab * ab;
    double s = across > 0 ? std::clamp((ab * at_b - bb * at_a) / across, 0.0, 1.0) : 0;
    const double t = bb > 0 ? std::clamp((ab * s + at_b) / bb, 0.0, 1.0) : 0;
    if (aa > 0)
        s = std::clamp((ab * t - at_a) / aa, 0.0, 1.0);
    return (between + s * first - t * second).squaredNorm();
}

// A node or a piece that waits for its visit, with its lower bound.
struct Waiting {
    double bound;
    std::uint32_t number;
    bool is_piece;

    bool operator<(const Waiting& other) const
    {
        return std::pair{bound, number} > std::pair{other.bound, other.number};
    }
};

}  // namespace

ToolPieces::Capsule::Capsule(const Sphere& at_low, const Sphere& at_high)
    : low{at_low.centre},
      high{at_high.centre},
      low_radius{at_low.radius},
      high_radius{at_high.radius},
      length{(high - low).norm()},
      along{Vec3::Zero()},
      widening{0}
{
    if (length > 0) {
        along = (high - low) / length;
        widening = (high_radius - low_radius) / length;
    } else {
        low_radius = high_radius = std::max(low_radius, high_radius);
    }
}

// Over the axis from `low` to `high` the distance of the place minus the radius, which
// changes evenly, is convex. Its minimum is in closed form.
double ToolPieces::Capsule::distance(const Vec3& place) const
{
    const Vec3 from = place - low;
    const double foot = from.dot(along);
    const double square = std::max(0.0, from.squaredNorm() - foot * foot);
    double at = foot;
    if (std::abs(widening) >= 1)
        at = widening > 0 ? length : 0;
    else if (widening != 0)
        at += widening * std::sqrt(square / ((1 - widening) * (1 + widening)));
    at = std::clamp(at, 0.0, length);
    return std::sqrt(square + (foot - at) * (foot - at)) - low_radius - widening * at;
}

// The distance of two segments, with the larger radius.
bool ToolPieces::Capsule::is_near(const Vec3& from, const Vec3& to, double within) const
{
    const double reach = within + std::max(low_radius, high_radius);
    return squared_distance(low, high, from, to) <= reach * reach;
}

// The capsule of a piece. A point of the axis at a height moves along a curve that is
// nearer than an eighth of the largest second derivative to its chord.
ToolPieces::Capsule ToolPieces::around(std::size_t piece) const
{
    const ToolMotion& motion = pieces_[piece].motion;
    const CuttingBody& body = pieces_[piece].body;
    const double low = body.base() + body.cutter().corner_radius();
    const double far = std::max((motion.from().tip - region_.centre).norm(),
                                (motion.to().tip - region_.centre).norm()) +
                       region_.radius;
    const double high = std::max(low, std::min(body.length(), far));
    const auto on_axis = [&](const ToolFrame& frame, double height) -> Vec3 {
        return frame.tip + height * frame.axes.col(2);
    };
    const auto end = [&](double height) {
        const Vec3 from = on_axis(motion.from(), height);
        const Vec3 to = on_axis(motion.to(), height);
        return Sphere{(from + to) / 2, (to - from).norm() / 2 + body.cutter().radius() +
                                           motion.largest_tool_bend(height) / 8 +
                                           rounding_margin};
    };
    const Sphere at_low = end(low);
    const Sphere at_high = end(high);
    return {at_low, at_high};
}

ToolPieces::Capsule ToolPieces::around(std::span<const Capsule> some) const
{
    const auto end = [&](const Vec3 Capsule::*centre, double Capsule::*radius) {
        Vec3 low = some.front().*centre;
        Vec3 high = low;
        for (const Capsule& one : some) {
            low = low.cwiseMin(one.*centre);
            high = high.cwiseMax(one.*centre);
        }
        Sphere sphere{(low + high) / 2, 0};
        for (const Capsule& one : some)
            sphere.radius = std::max(sphere.radius,
                                     (one.*centre - sphere.centre).norm() + one.*radius);
        return sphere;
    };
    return {end(&Capsule::low, &Capsule::low_radius),
            end(&Capsule::high, &Capsule::high_radius)};
}

ToolPieces::ToolPieces(std::vector<ToolPiece> pieces, const Sphere& region)
    : pieces_{std::move(pieces)},
      region_{region}
{
    const auto count = static_cast<std::uint32_t>(pieces_.size());
    if (count == 0)
        return;
    // The tree is made over numbers; the pieces are then put into its order.
    capsules_.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        capsules_.push_back(around(i));
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    const auto divide = [&](auto& self, std::uint32_t first, std::uint32_t last) -> void {
        if (last - first <= leaf_size)
            return;
        Vec3 low = capsules_[order[first]].low;
        Vec3 high = low;
        for (std::uint32_t i = first; i < last; ++i) {
            low = low.cwiseMin(capsules_[order[i]].low);
            high = high.cwiseMax(capsules_[order[i]].low);
        }
        Eigen::Index longest = 0;
        (high - low).maxCoeff(&longest);
        const std::uint32_t middle = first + (last - first) / 2;
        std::nth_element(order.begin() + first, order.begin() + middle,
                         order.begin() + last, [&](std::uint32_t a, std::uint32_t b) {
                             return std::pair{capsules_[a].low[longest], a} <
                                    std::pair{capsules_[b].low[longest], b};
                         });
        self(self, first, middle);
        self(self, middle, last);
    };
    divide(divide, 0, count);
    std::vector<ToolPiece> in_order;
    std::vector<Capsule> capsules;
    in_order.reserve(count);
    capsules.reserve(count);
    for (const std::uint32_t number : order) {
        in_order.push_back(pieces_[number]);
        capsules.push_back(capsules_[number]);
    }
    pieces_ = std::move(in_order);
    capsules_ = std::move(capsules);
    nodes_.reserve(2 * (count / leaf_size + 1));
    add_node(0, count);
}

std::uint32_t ToolPieces::add_node(std::uint32_t first, std::uint32_t last)
{
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(
        {around(std::span{capsules_}.subspan(first, last - first)), first, last, 0});
    if (last - first <= leaf_size)
        return number;
    const std::uint32_t middle = first + (last - first) / 2;
    add_node(first, middle);
    const std::uint32_t second = add_node(middle, last);
    nodes_[number].second_child = second;
    return number;
}

void ToolPieces::visit_nearest(
    const Vec3& place, double most,
    const std::function<double(std::size_t piece, double bound)>& visit) const
{
    if (nodes_.empty())
        return;
    std::priority_queue<Waiting> waiting;
    waiting.push({nodes_.front().around.distance(place), 0, false});
    while (!waiting.empty() && waiting.top().bound <= most) {
        const Waiting next = waiting.top();
        waiting.pop();
        if (next.is_piece) {
            most = visit(next.number, next.bound);
            continue;
        }
        const Node& node = nodes_[next.number];
        const auto wait = [&](double bound, std::uint32_t number, bool is_piece) {
            if (bound <= most)
                waiting.push({bound, number, is_piece});
        };
        if (node.second_child == 0) {
            for (std::uint32_t i = node.first; i < node.last; ++i)
                wait(capsules_[i].distance(place), i, true);
            continue;
        }
        wait(nodes_[next.number + 1].around.distance(place), next.number + 1, false);
        wait(nodes_[node.second_child].around.distance(place), node.second_child, false);
    }
}

std::vector<std::uint32_t> ToolPieces::near_segment(const Vec3& from, const Vec3& to,
                                                    double within) const
{
    std::vector<std::uint32_t> near;
    std::vector<std::uint32_t> open;
    if (!nodes_.empty())
        open.push_back(0);
    while (!open.empty()) {
        const std::uint32_t number = open.back();
        open.pop_back();
        const Node& node = nodes_[number];
        if (!node.around.is_near(from, to, within))
            continue;
        if (node.second_child != 0) {
            open.push_back(node.second_child);
            open.push_back(number + 1);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.last; ++i)
            if (capsules_[i].is_near(from, to, within))
                near.push_back(i);
    }
    return near;
}

}  // namespace endmill
