// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/many_cones_search.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/setup/detail/axis_fit.h"
#include "endmill/setup/detail/cone_set.h"
#include "endmill/setup/detail/least_cones.h"
#include "endmill/setup/detail/range_limits.h"
#include "endmill/setup/setup_travel.h"

namespace endmill {
namespace {

using Numbers = std::vector<std::size_t>;

// At most `most` of the numbers, evenly spaced.
Numbers spread(const Numbers& numbers, std::size_t most)
{
    Numbers some;
    const std::size_t count = std::min(most, numbers.size());
    for (std::size_t k = 0; k < count; ++k)
        some.push_back(numbers[k * numbers.size() / count]);
    return some;
}

// The rounds of the search. Cones are numbered by their places among the minimal cones.
class ConeRounds {
public:
    ConeRounds(const SphereGrid& grid, const DistinctCones& cones, const Numbers& least,
               const WholeConeSearchOptions& options)
        : grid_{grid},
          cones_{cones},
          least_{least},
          options_{options},
          all_{cones.map(least)},
          starts_{options.starts.begin(), options.starts.end()},
          is_asked_(least.size(), 0)
    {
    }

    WholeConeSearchResult run(std::size_t cones_a_round)
    {
        Numbers places(least_.size());
        for (std::size_t k = 0; k < places.size(); ++k)
            places[k] = k;
        // The result must not be worse than the starting poses.
        for (const SetupPose& start : options_.starts)
            extend(axis_of(start));
        Numbers added = spread(places, cones_a_round);
        while (!added.empty()) {
            for (const std::size_t place : added)
                is_asked_[place] = 1;
            WholeConeSearchResult found = search_asked();
            if (!found.pose) {
                result_.machinable = best_ ? Answer::Yes : found.machinable;
                break;
            }
            const Numbers missed = missed_by(*found.pose);
            if (missed.empty()) {
                found.nodes = result_.nodes;
                found.lower_bound = result_.lower_bound;
                return found;
            }
            extend(axis_of(found.pose->pose));
            if (is_near_enough() || result_.nodes >= options_.max_nodes)
                break;
            added = spread(missed, cones_a_round);
        }
        return best_result();
    }

private:
    Vec3 axis_of(const SetupPose& pose) const
    {
        return options_.family == RotaryFamily::CA ? pose.tool_axis : pose.r1_axis;
    }

    WholeConeSearchResult search_asked()
    {
        Numbers asked;
        for (std::size_t place = 0; place < least_.size(); ++place)
            if (is_asked_[place] != 0)
                asked.push_back(least_[place]);
        WholeConeSearchOptions options = options_;
        options.starts = starts_;
        options.max_nodes =
            options_.max_nodes - std::min(options_.max_nodes, result_.nodes);
        if (options_.progress)
            options.progress = [this](const WholeConeSearchProgress& now) {
                report(now);
            };
        WholeConeSearchResult found =
            whole_cone_search(grid_, cones_.map(asked), options);
        result_.nodes += found.nodes;
        result_.unresolved = found.unresolved;
        result_.lower_bound = std::max(result_.lower_bound, found.lower_bound);
        if (found.pose)
            starts_.push_back(found.pose->pose);
        return found;
    }

    // Reports the best pose that meets all cones, not a pose that meets only some of
    // them.
    void report(const WholeConeSearchProgress& now) const
    {
        WholeConeSearchProgress all{result_.nodes + now.nodes, std::nullopt,
                                    std::max(result_.lower_bound, now.lower_bound)};
        if (best_)
            all.objective = best_->objective;
        options_.progress(all);
    }

    // Places of the cones without a cell within the pose's ranges.
    Numbers missed_by(const FittedPose& fit) const
    {
        const RotaryFrame frame{options_.family, fit.pose.tool_axis, fit.pose.r1_axis,
                                fit.pose.r2_axis};
        const auto reached =
            facet_reach(all_, grid_.centres, frame, {fit.phi, fit.theta});
        Numbers missed;
        for (std::size_t place = 0; place < reached.size(); ++place)
            if (!reached[place] && is_asked_[place] == 0)
                missed.push_back(place);
        return missed;
    }

    // Finds the best range about this axis that meets all cones, and keeps it if it is
    // the best so far.
    void extend(const Vec3& axis)
    {
        if (!everything_) {
            everything_.emplace(all_);
            for (const std::size_t cell : everything_->cells())
                centres_.push_back(grid_.centres[cell]);
        }
        AxisFitter fitter{{&*everything_,
                           centres_,
                           {options_.family, options_.objective, options_.floor_rad},
                           RangeLimits{options_.family, options_.limits}}};
        const double below =
            best_ ? best_->objective : std::numeric_limits<double>::infinity();
        if (auto fit = fitter.best(axis, {below}))
            best_ = std::move(fit);
    }

    bool is_near_enough() const
    {
        return best_ && best_->objective <= (1 + options_.gap) * result_.lower_bound;
    }

    WholeConeSearchResult best_result() const
    {
        WholeConeSearchResult result = result_;
        if (best_) {
            result.machinable = Answer::Yes;
            result.pose = fitted_pose(*best_, options_.family, options_.limits);
            result.ranges = best_->ranges;
            result.objective = best_->objective;
        }
        return result;
    }

    const SphereGrid& grid_;
    const DistinctCones& cones_;
    const Numbers& least_;
    const WholeConeSearchOptions& options_;
    VisibilityMap all_;                  // of the minimal cones
    std::vector<SetupPose> starts_;      // those given, and the poses found so far
    std::vector<char> is_asked_;         // by place: 1 if the cone belongs to the search
    std::optional<ConeSet> everything_;  // all minimal cones, made when first needed
    std::vector<Vec3> centres_;          // of everything_->cells()
    std::optional<AxisFit> best_;        // meets all cones
    WholeConeSearchResult result_;
};

}  // namespace

WholeConeSearchResult many_cones_search(const SphereGrid& grid, const VisibilityMap& map,
                                        const WholeConeSearchOptions& options,
                                        std::size_t few)
{
    require(map.cells() == grid.centres.size(),
            "many_cones_search: map and grid differ in cells");
    require(few >= 4, "many_cones_search: need 4 <= few");
    const DistinctCones cones{map};
    const Numbers least = least_cones(cones);
    if (least.size() <= few)
        return whole_cone_search(grid, map, options);
    return ConeRounds{grid, cones, least, options}.run(few / 4);
}

}  // namespace endmill
