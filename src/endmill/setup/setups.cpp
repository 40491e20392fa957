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

namespace endmill {
namespace {

// Tool axes that are tried between two looks at the best: fixed, so that which are tried does
// not depend on the number of threads; so many that a tile of cones serves some of them.
constexpr std::size_t axes_per_round = 32;

// A candidate and how many facets of the rest it reaches.
struct Reached {
    std::size_t facets = 0;
    std::size_t cell = 0;
    std::size_t turn = 0;
};

bool is_better(const Reached& one, const Reached& other)
{
    return one.facets != other.facets ? one.facets > other.facets : one.cell < other.cell;
}

// A tool axis and what it could reach at most.
struct Hope {
    std::size_t cell;
    std::size_t facets;
};

class GreedyChoice {
public:
    GreedyChoice(const VisibilityMap& map, std::span<const Vec3> centres,
                 const SetupReach& reach,
                 const std::function<void(const SetupsProgress&)>& progress)
        : cones_{map},
          centres_{centres},
          reach_{reach},
          progress_{progress},
          rest_(cones_.size()),
          hopes_(map.cells())
    {
        std::iota(rest_.begin(), rest_.end(), std::size_t{0});
        // Those of most facets first: the others have sizes of few bits.
        std::ranges::stable_sort(rest_, [this](std::size_t a, std::size_t b) {
            return cones_.facets(a) > cones_.facets(b);
        });
        for (std::size_t cell = 0; cell < hopes_.size(); ++cell)
            hopes_[cell] = {cell, facets_left()};
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
    using Turns = std::vector<std::vector<FeasibleTurns>>;  // of some tool axes

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

    // The axes of most hope first. What one reached of an earlier rest it cannot exceed: axes
    // are tried while they may still be better than the best.
    Reached best_candidate()
    {
        std::ranges::sort(hopes_, [](const Hope& a, const Hope& b) {
            return a.facets != b.facets ? a.facets > b.facets : a.cell < b.cell;
        });
        const ConeTiles tiles{cones_, rest_};
        Reached best{0, centres_.size(), 0};
        std::size_t tried = 0;
        while (tried < hopes_.size() &&
               is_better({hopes_[tried].facets, hopes_[tried].cell}, best)) {
            const auto some = std::span{hopes_}.subspan(
                tried, std::min(axes_per_round, hopes_.size() - tried));
            for (const Reached& reached : best_turns(tiles, some))
                if (is_better(reached, best))
                    best = reached;
            tried += some.size();
            if (progress_)
                progress_({chosen_ + 1, tried, hopes_.size()});
        }
        return best;
    }

    // The best turn about each of these axes, which is what to hope for from then on.
    std::vector<Reached> best_turns(const ConeTiles& tiles, std::span<Hope> axes) const
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

    Turns feasible(std::span<const Hope> axes) const
    {
        Turns turns(axes.size());
        parallel_for(axes.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                turns[i] = feasible_turns(reach_, centres_, axes[i].cell);
        });
        return turns;
    }

    // Takes from the rest what the candidate reaches. \return for each cone whether it does.
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
    const SetupReach& reach_;
    const std::function<void(const SetupsProgress&)>& progress_;
    std::vector<std::size_t> rest_;  // cones not reached so far
    std::vector<Hope> hopes_;        // of all cells
    std::size_t chosen_ = 0;
};

}  // namespace

SetupCover greedy_setups(const VisibilityMap& map, std::span<const Vec3> centres,
                         const SetupReach& reach, std::size_t most,
                         const std::function<void(const SetupsProgress&)>& progress)
{
    require(centres.size() == map.cells(), "greedy_setups: need a centre for each cell");
    require(3 <= reach.axes && reach.axes <= 5, "greedy_setups: need 3, 4 or 5 axes");
    require(most >= 1, "greedy_setups: need 1 <= most");
    SetupCover cover;
    GreedyChoice choice{map, centres, reach, progress};
    while (!choice.is_done() && cover.setups.size() < most)
        cover.setups.push_back(choice.next());
    cover.uncovered = choice.rest();
    return cover;
}

}  // namespace endmill
