// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/several_setups.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <numeric>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/setup/detail/distinct_cones.h"
#include "endmill/setup/detail/turn_cover.h"

// How the next setup is chosen.
//
// 1. Facets with equal cones are merged; a cone counts as many times as it has facets.
// 2. Every tool axis has an upper bound: the facets that it reached of an earlier, larger
//    rest. Axes are sorted by it, so that the search stops at the first axis whose bound
//    is below the best candidate.
// 3. Axes are tried in rounds of 32. For each axis `feasible_turns` lists the cells that
//    the machine reaches from each of the 72 turns, and ConeTiles counts the facets of
//    the cones that contain one of these cells, for all turns at once.
// 4. The best candidate becomes a setup, and the cones that it reaches leave the rest.

namespace endmill {
namespace {

// Number of tool axes that are tried before the best candidate is updated. It is fixed,
// so that the result does not depend on the number of threads, and large enough that a
// tile of cones is used for several axes while it is in the cache.
constexpr std::size_t axes_per_round = 32;

// A candidate and the number of facets of the rest that it reaches.
struct Reached {
    std::size_t facets = 0;
    std::size_t cell = 0;
    std::size_t turn = 0;
};

bool is_better(const Reached& one, const Reached& other)
{
    return one.facets != other.facets ? one.facets > other.facets : one.cell < other.cell;
}

// A tool axis and an upper bound of the facets that it reaches.
struct AxisBound {
    std::size_t cell;
    std::size_t facets;
};

class GreedyChoice {
public:
    GreedyChoice(const VisibilityMap& map, std::span<const Vec3> centres,
                 const RotaryReach& reach,
                 const std::function<void(const SetupCoverProgress&)>& progress)
        : cones_{map},
          centres_{centres},
          reach_{reach},
          progress_{progress},
          rest_(cones_.size()),
          bounds_(map.cells())
    {
        std::iota(rest_.begin(), rest_.end(), std::size_t{0});
        // Cones with many facets come first, so that later tiles store sizes of few bits.
        std::ranges::stable_sort(rest_, [this](std::size_t a, std::size_t b) {
            return cones_.facets(a) > cones_.facets(b);
        });
        for (std::size_t cell = 0; cell < bounds_.size(); ++cell)
            bounds_[cell] = {cell, facets_left()};
    }

    bool is_done() const { return rest_.empty(); }

    PartialSetup next()
    {
        const Reached best = best_candidate();
        const RotaryFrame frame = frame_at(reach_, centres_[best.cell], best.turn);
        PartialSetup setup{{frame.tool_axis, frame.r1_axis, frame.r2_axis}, {}};
        setup.facets = facets_of(take_reached(best));
        ++chosen_;
        return setup;
    }

    std::vector<std::size_t> rest() const
    {
        std::vector<char> is_left(cones_.size(), 0);
        for (const std::size_t cone : rest_)
            is_left[cone] = 1;
        return facets_of(is_left);
    }

private:
    using Turns = std::vector<std::vector<FeasibleTurns>>;  // for each of some tool axes

    std::size_t facets_left() const
    {
        std::size_t facets = 0;
        for (const std::size_t cone : rest_)
            facets += cones_.facets(cone);
        return facets;
    }

    std::vector<std::size_t> facets_of(const std::vector<char>& has_cone) const
    {
        std::vector<std::size_t> facets;
        for (std::size_t facet = 0; facet < cones_.cone_of().size(); ++facet) {
            const std::size_t cone = cones_.cone_of()[facet];
            if (cone != DistinctCones::none && has_cone[cone] != 0)
                facets.push_back(facet);
        }
        return facets;
    }

    // Tries axes in the order of their upper bounds, until no other axis can be better.
    Reached best_candidate()
    {
        std::ranges::sort(bounds_, [](const AxisBound& a, const AxisBound& b) {
            return a.facets != b.facets ? a.facets > b.facets : a.cell < b.cell;
        });
        const ConeTiles tiles{cones_, rest_};
        Reached best{0, centres_.size(), 0};
        std::size_t tried = 0;
        while (tried < bounds_.size() &&
               is_better({bounds_[tried].facets, bounds_[tried].cell}, best)) {
            const auto some = std::span{bounds_}.subspan(
                tried, std::min(axes_per_round, bounds_.size() - tried));
            for (const Reached& reached : best_turns(tiles, some))
                if (is_better(reached, best))
                    best = reached;
            tried += some.size();
            if (progress_)
                progress_({chosen_ + 1, tried, bounds_.size()});
        }
        return best;
    }

    // Finds the best turn about each of these axes, and stores its count as the axis's
    // new upper bound.
    std::vector<Reached> best_turns(const ConeTiles& tiles,
                                    std::span<AxisBound> axes) const
    {
        const Turns turns = feasible(axes);
        std::vector<std::atomic<std::size_t>> counts(axes.size() * turns_about_tool_axis);
        parallel_for(tiles.size() * axes.size(), [&](std::size_t begin, std::size_t end) {
            TurnCoverScratch scratch;
            for (std::size_t i = begin; i < end; ++i) {
                std::array<std::size_t, turns_about_tool_axis> found{};
                const std::size_t axis = i % axes.size();
                tiles.add_reached(i / axes.size(), turns[axis], found, scratch);
                for (std::size_t turn = 0; turn < found.size(); ++turn)
                    counts[axis * found.size() + turn] += found[turn];
            }
        });
        std::vector<Reached> best(axes.size());
        for (std::size_t axis = 0; axis < axes.size(); ++axis) {
            best[axis].cell = axes[axis].cell;
            for (std::size_t turn = 0; turn < turns_about_tool_axis; ++turn) {
                const std::size_t facets = counts[axis * turns_about_tool_axis + turn];
                if (facets > best[axis].facets)
                    best[axis] = {facets, axes[axis].cell, turn};
            }
            axes[axis].facets = best[axis].facets;
        }
        return best;
    }

    Turns feasible(std::span<const AxisBound> axes) const
    {
        Turns turns(axes.size());
        parallel_for(axes.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                turns[i] = feasible_turns(reach_, centres_, axes[i].cell);
        });
        return turns;
    }

    // Removes the cones that the candidate reaches from the rest.
    // \return for each cone 1 if the candidate reaches it, else 0.
    std::vector<char> take_reached(const Reached& candidate)
    {
        std::vector<std::uint64_t> cells(cones_.row_words(), 0);
        for (const FeasibleTurns& run : feasible_turns(reach_, centres_, candidate.cell))
            if (run.hold(candidate.turn))
                cells[run.cell / 64] |= std::uint64_t{1} << (run.cell % 64);
        std::vector<char> is_reached(cones_.size(), 0);
        for (const std::size_t cone : rest_) {
            std::uint64_t shared = 0;
            for (std::size_t k = 0; k < cells.size(); ++k)
                shared |= cells[k] & cones_.row(cone)[k];
            is_reached[cone] = shared != 0 ? 1 : 0;
        }
        std::erase_if(rest_, [&](std::size_t cone) { return is_reached[cone] != 0; });
        return is_reached;
    }

    DistinctCones cones_;
    std::span<const Vec3> centres_;
    const RotaryReach& reach_;
    const std::function<void(const SetupCoverProgress&)>& progress_;
    std::vector<std::size_t> rest_;  // cones that no setup reaches so far
    std::vector<AxisBound> bounds_;  // of all cells
    std::size_t chosen_ = 0;
};

}  // namespace

SetupCover greedy_setups(const VisibilityMap& map, std::span<const Vec3> centres,
                         const RotaryReach& reach, std::size_t most,
                         const std::function<void(const SetupCoverProgress&)>& progress)
{
    require(centres.size() == map.cells(), "greedy_setups: need a centre for each cell");
    require(reach.configuration.is_valid(), "greedy_setups: need a valid configuration");
    require(most >= 1, "greedy_setups: need at least one setup");
    SetupCover cover;
    GreedyChoice choice{map, centres, reach, progress};
    while (!choice.is_done() && cover.setups.size() < most)
        cover.setups.push_back(choice.next());
    cover.uncovered = choice.rest();
    return cover;
}

}  // namespace endmill
