// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/middle_way.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

namespace endmill {
namespace {

// By how much a step at the rim of an island costs more than one in its middle.
constexpr double rim_penalty = 4;

// Shortest ways over an island from one of its samples.
class IslandWays {
public:
    IslandWays(const PartSamples& samples, std::span<const std::int32_t> island,
               std::span<const double> depths)
        : samples_{samples},
          depths_{depths}
    {
        for (const std::int32_t i : island) {
            is_inside_[i] = true;
            deepest_ = std::max(deepest_, depths[i]);
        }
    }

    // The sample that is farthest from `start`.
    std::int32_t farthest_from(std::int32_t start, double penalty)
    {
        reached_ = {{start, {0.0, start}}};
        queue_.emplace(0.0, start);
        std::int32_t last = start;
        while (!queue_.empty()) {
            const auto [so_far, i] = queue_.top();
            queue_.pop();
            if (so_far > reached_[i].distance)
                continue;
            last = i;
            for (const std::int32_t neighbour : samples_.neighbours(i))
                if (is_inside_.contains(neighbour))
                    reach(neighbour, i, so_far + cost(i, neighbour, penalty));
        }
        return last;
    }

    // The sample before `i` on the way to it; `i` itself at the start.
    std::int32_t before(std::int32_t i) const { return reached_.at(i).before; }

private:
    using Entry = std::pair<double, std::int32_t>;
    struct Reached {
        double distance;
        std::int32_t before;
    };

    double cost(std::int32_t from, std::int32_t to, double penalty) const
    {
        return (samples_.point(to) - samples_.point(from)).norm() *
               (1 + penalty * (1 - depths_[to] / deepest_));
    }

    void reach(std::int32_t i, std::int32_t from, double distance)
    {
        const auto [known, is_new] = reached_.try_emplace(i, Reached{distance, from});
        if (!is_new && !(distance < known->second.distance))
            return;
        known->second = {distance, from};
        queue_.emplace(distance, i);
    }

    const PartSamples& samples_;
    std::span<const double> depths_;
    double deepest_ = 0;
    std::unordered_map<std::int32_t, bool> is_inside_;
    std::unordered_map<std::int32_t, Reached> reached_;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

std::vector<std::int32_t> middle_way(const PartSamples& samples,
                                     std::span<const std::int32_t> island,
                                     std::span<const double> depths)
{
    IslandWays ways{samples, island, depths};
    const std::int32_t end = ways.farthest_from(island.front(), 0);
    std::int32_t at = ways.farthest_from(end, rim_penalty);
    std::vector<std::int32_t> way{at};
    while (ways.before(at) != at) {
        at = ways.before(at);
        way.push_back(at);
    }
    return way;
}

}  // namespace endmill
