// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/bounded_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "endmill/core/error.h"
#include "endmill/planning/detail/portable_uniform.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int candidates_per_value = 4;
constexpr int fewest_candidates = 20;
// Share of the population from which the leader of a trial is drawn.
constexpr double leading_share = 0.15;
constexpr double crossover = 0.9;
// Share of the evaluations that explore; the others refine the best member.
constexpr double exploring_share = 0.75;
// Steps of the refinement, as shares of a range.
constexpr double first_step = 1e-2;
constexpr double least_step = 1e-9;
// A success widens the step by this factor, a failure narrows it by the fourth root.
constexpr double widening = 1.5;

class Minimiser {
public:
    Minimiser(std::span<const Interval> ranges, const BoundedLoss& loss,
              const BoundedSearch& search)
        : ranges_{ranges},
          loss_{loss},
          search_{search},
          uniform_{search.seed}
    {
    }

    FoundValues run()
    {
        start();
        explore();
        refine();
        return best_;
    }

private:
    struct Member {
        std::vector<double> values;
        double loss;
    };

    bool is_done(int evaluations) const
    {
        return best_.evaluations >= evaluations || best_.loss <= search_.enough;
    }

    double evaluate(const std::vector<double>& values, double give_up)
    {
        const double found = loss_(values, give_up);
        ++best_.evaluations;
        if (found < best_.loss) {
            best_.loss = found;
            best_.values = values;
        }
        return found;
    }

    void start()
    {
        const int size =
            search_.population > 0
                ? search_.population
                : std::max(fewest_candidates,
                           candidates_per_value * static_cast<int>(ranges_.size()));
        for (int i = 0; i < size && !is_done(search_.evaluations); ++i) {
            std::vector<double> values;
            if (i < static_cast<int>(search_.start.size()))
                values = search_.start[i];
            else
                values = random_member();
            const double found = evaluate(values, infinity);
            members_.push_back({std::move(values), found});
        }
        if (best_.values.empty())
            best_.values = members_.front().values;
    }

    // Random values in a part of the box about its middle, whose size differs from member to member:
    // where the loss is not defined for most values, it often is near the middle.
    std::vector<double> random_member()
    {
        const double share = uniform_(0, 1);
        std::vector<double> values;
        for (const auto [low, high] : ranges_) {
            const double half = share * (high - low) / 2;
            values.push_back((low + high) / 2 + uniform_(-half, half));
        }
        return values;
    }

    void explore()
    {
        const int last = static_cast<int>(exploring_share * search_.evaluations);
        const int size = static_cast<int>(members_.size());
        const int leaders = std::max(2, static_cast<int>(leading_share * size));
        std::vector<int> order(size);
        for (int i = 0; i < size; ++i)
            order[i] = i;
        while (!is_done(last)) {
            std::ranges::stable_sort(order, {}, [&](int i) { return members_[i].loss; });
            for (int i = 0; i < size && !is_done(last); ++i) {
                Member& member = members_[i];
                std::vector<double> trial = mixed(member, order, leaders);
                const double found = evaluate(trial, member.loss);
                if (found <= member.loss)
                    member = {std::move(trial), found};
            }
        }
    }

    std::vector<double> mixed(const Member& member, std::span<const int> order,
                              int leaders)
    {
        const int size = static_cast<int>(members_.size());
        const Member& leader = members_[order[uniform_.below(leaders)]];
        const Member& a = members_[uniform_.below(size)];
        const Member& b = members_[uniform_.below(size)];
        const double toward = uniform_(0.2, 0.9);
        const double factor = uniform_(0.3, 0.9);
        const int always = uniform_.below(static_cast<int>(ranges_.size()));
        std::vector<double> trial = member.values;
        for (std::size_t k = 0; k < trial.size(); ++k) {
            if (uniform_(0, 1) >= crossover && static_cast<int>(k) != always)
                continue;
            const double moved = trial[k] + toward * (leader.values[k] - trial[k]) +
                                 factor * (a.values[k] - b.values[k]);
            const auto [low, high] = ranges_[k];
            // A value beyond the box goes halfway to the border.
            trial[k] = moved < low    ? (trial[k] + low) / 2
                       : moved > high ? (trial[k] + high) / 2
                                      : moved;
        }
        return trial;
    }

    // Alternates steps of one value, of its own size, and steps of all values along the
    // spread of the population.
    void refine()
    {
        const std::size_t count = ranges_.size();
        std::vector<double> steps(count, first_step);
        double common = 1;
        std::vector<double> spread(count);
        for (std::size_t k = 0; k < count; ++k)
            spread[k] = first_step * ranges_[k].length();
        while (!is_done(search_.evaluations)) {
            const bool is_single = uniform_(0, 1) < 0.5;
            std::vector<double> trial = best_.values;
            const std::size_t one = uniform_.below(static_cast<int>(count));
            if (is_single) {
                trial[one] += steps[one] * ranges_[one].length() * uniform_.normal();
            } else {
                const int size = static_cast<int>(members_.size());
                const Member& a = members_[uniform_.below(size)];
                const Member& b = members_[uniform_.below(size)];
                for (std::size_t k = 0; k < count; ++k)
                    trial[k] += common * (uniform_.normal() * spread[k] +
                                          0.5 * (a.values[k] - b.values[k]));
            }
            for (std::size_t k = 0; k < count; ++k)
                trial[k] = std::clamp(trial[k], ranges_[k].low, ranges_[k].high);
            double& step = is_single ? steps[one] : common;
            const double before = best_.loss;
            const bool is_better = evaluate(trial, before) < before;
            step *= is_better ? widening : std::pow(widening, -0.25);
            step = std::max(step, least_step);
        }
    }

    std::span<const Interval> ranges_;
    const BoundedLoss& loss_;
    const BoundedSearch& search_;
    PortableUniform uniform_;
    std::vector<Member> members_;
    FoundValues best_;
};

}  // namespace

FoundValues minimise(std::span<const Interval> ranges, const BoundedLoss& loss,
                     const BoundedSearch& search)
{
    require(!ranges.empty(), "minimise: need at least one range");
    require(
        std::ranges::all_of(ranges, [](const Interval& r) { return r.low <= r.high; }),
        "minimise: need low <= high");
    return Minimiser{ranges, loss, search}.run();
}

std::vector<Interval> box_about(std::span<const double> values,
                                std::span<const Interval> ranges, double share)
{
    std::vector<Interval> box;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const double half = share / 2 * ranges[i].length();
        box.push_back({std::max(ranges[i].low, values[i] - half),
                       std::min(ranges[i].high, values[i] + half)});
    }
    return box;
}

}  // namespace endmill
