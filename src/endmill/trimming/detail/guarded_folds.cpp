// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/guarded_folds.h"

#include <algorithm>

#include "endmill/trimming/detail/section_runs.h"

namespace endmill {
namespace {

constexpr std::string_view valley_rule = "valley";

// A maximal run of the chain with growing s.
struct ForwardRun {
    std::int32_t first;  // vertices
    std::int32_t last;
    std::size_t tested = 0;  // the first `tested` runs behind this one do not cross it
};

struct ForwardRuns {
    std::vector<ForwardRun> runs;
    bool begins_backward = false;
    bool ends_backward = false;
};

ForwardRuns forward_runs(const SectionChain& chain, double dead_band)
{
    ForwardRuns result;
    RunReader reader{chain, RunAxis::S, dead_band, chain.first()};
    bool is_first = true;
    while (const auto run = reader.next()) {
        if (run->grows)
            result.runs.push_back({run->first, run->last});
        else if (is_first)
            result.begins_backward = true;
        result.ends_backward = !run->grows;
        is_first = false;
    }
    return result;
}

std::optional<ChainCrossing> crossing_of_runs(const SectionChain& chain,
                                              const ForwardRun& a, const ForwardRun& b,
                                              const CrossingFinder& find)
{
    return find(chain, {a.first, a.last, b.first, b.last});
}

// Cuts the loop between two runs out and joins them at their crossing. A crossing of
// method 1 lies only near the curve, and may lie behind the last vertices of A or in
// front of the first vertices of B. These vertices are removed too, so that s does not
// step back.
ForwardRun join_runs(SectionChain& chain, const ForwardRun& a, const ForwardRun& b,
                     const ChainCrossing& crossing)
{
    std::int32_t left = crossing.segment_a;
    std::int32_t right = chain.next(crossing.segment_b);
    ForwardRun joined{a.first, b.last};
    if (!crossing.lies_on_both) {
        const double s = crossing.at.x();
        while (left != a.first && chain.at(left).x() >= s)
            left = chain.previous(left);
        while (right != b.last && chain.at(right).x() <= s)
            right = chain.next(right);
    }
    chain.join(left, right, crossing, valley_rule);
    return joined;
}

// Searches each run and its next one. Whether two runs cross depends on these two alone.
// After a splice only the joined run has to be tested again, against the run in front of
// it, so that the runs in front form a stack.
void splice_neighbours(SectionChain& chain, std::vector<ForwardRun>& runs,
                       const CrossingFinder& find)
{
    std::size_t kept = 0;
    for (const ForwardRun& run : std::vector<ForwardRun>{runs}) {
        runs[kept++] = run;
        while (kept >= 2) {
            const ForwardRun& a = runs[kept - 2];
            const ForwardRun& b = runs[kept - 1];
            const auto crossing = crossing_of_runs(chain, a, b, find);
            if (!crossing)
                break;
            runs[kept - 2] = join_runs(chain, a, b, *crossing);
            --kept;
        }
    }
    runs.resize(kept);
}

// Replaces the runs `first` to `last` by `joined`, which has not been tested against any
// run.
void replace(std::vector<ForwardRun>& runs, std::size_t first, std::size_t last,
             const ForwardRun& joined)
{
    runs[first] = joined;
    runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(first) + 1,
               runs.begin() + static_cast<std::ptrdiff_t>(last) + 1);
    for (std::size_t k = 0; k < first; ++k)
        runs[k].tested = std::min(runs[k].tested, first - k - 1);
}

// Searches the pairs of runs that are `distance` apart and have not been tested. Returns
// true after the first splice.
bool splice_at_distance(SectionChain& chain, std::vector<ForwardRun>& runs,
                        std::size_t distance, const CrossingFinder& find)
{
    for (std::size_t k = 0; k + distance < runs.size(); ++k) {
        ForwardRun& a = runs[k];
        if (a.tested >= distance)
            continue;
        const ForwardRun& b = runs[k + distance];
        const auto crossing = crossing_of_runs(chain, a, b, find);
        if (crossing) {
            replace(runs, k, k + distance, join_runs(chain, a, b, *crossing));
            return true;
        }
        a.tested = distance;
    }
    return false;
}

// Searches all pairs of runs, nearest pairs first. After a splice the search restarts
// with neighbours, because the joined run is new.
void splice_all(SectionChain& chain, std::vector<ForwardRun>& runs,
                const CrossingFinder& find)
{
    for (std::size_t distance = 1; distance < runs.size();) {
        const bool has_spliced = splice_at_distance(chain, runs, distance, find);
        distance = has_spliced ? 1 : distance + 1;
    }
}

// Applies rule E3 once. The first fold lies between the first two runs, the last fold
// between the last two. A branch that ends before it reaches the s of the other branch's
// cusp is cut off together with the fold. Returns whether the rule applied.
bool cut_short_branch(SectionChain& chain, std::vector<ForwardRun>& runs)
{
    if (runs.size() < 2)
        return false;
    const auto s_of = [&](std::int32_t vertex) { return chain.at(vertex).x(); };
    const ForwardRun& before_last = runs[runs.size() - 2];
    bool first_is_short = s_of(chain.first()) >= s_of(runs[1].first);
    const bool last_is_short = s_of(chain.last()) <= s_of(before_last.last);
    if (first_is_short && last_is_short && runs.size() == 2) {
        const double first_length = s_of(runs[0].last) - s_of(chain.first());
        const double last_length = s_of(chain.last()) - s_of(runs[1].first);
        first_is_short = first_length < last_length;
    }
    if (first_is_short) {
        chain.cut_before(runs[1].first, "E3");
        runs.erase(runs.begin());
        return true;
    }
    if (last_is_short) {
        chain.cut_behind(before_last.last, "E3");
        runs.pop_back();
        return true;
    }
    return false;
}

}  // namespace

int trim_guarded(SectionChain& chain, double dead_band, const CrossingFinder& find,
                 RunPairs pairs)
{
    auto [runs, begins_backward, ends_backward] = forward_runs(chain, dead_band);
    if (runs.empty())
        return begins_backward ? 1 : 0;
    if (pairs == RunPairs::Neighbours)
        splice_neighbours(chain, runs, find);
    else
        splice_all(chain, runs, find);

    if (ends_backward)
        chain.cut_behind(runs.back().last, "E1");
    if (begins_backward)
        chain.cut_before(runs.front().first, "E2");
    while (cut_short_branch(chain, runs)) {
    }
    return static_cast<int>(runs.size()) - 1;
}

}  // namespace endmill
