// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/literal_folds.h"

#include "endmill/trimming/detail/section_runs.h"

namespace endmill {
namespace {

// A fold found by the signs of dz: its two branches, and the rules for a cut with and
// without a crossing.
struct Pattern {
    Branches branches;
    std::string_view rule;
    std::string_view cut_rule;
};

// How the runs are read.
struct Reading {
    double dead_band;  // mm
    FoldPatterns patterns;
};

// The first pattern behind `from`. The signs of successive runs alternate, so that the
// pattern begins with the first run: P3 if it rises, P4 if it falls. Without P3 it begins
// with the first falling run. Branch A is the first run of the pattern; branch B is its
// third run (P3) or its fourth (P4).
std::optional<Pattern> first_pattern(const SectionChain& chain, const Reading& reading,
                                     std::int32_t from)
{
    RunReader runs{chain, RunAxis::Z, reading.dead_band, from};
    auto a = runs.next();
    if (a && a->grows && reading.patterns == FoldPatterns::P4)
        a = runs.next();
    if (!a)
        return std::nullopt;
    const int runs_between = a->grows ? 1 : 2;
    for (int k = 0; k < runs_between; ++k)
        runs.next();
    const auto b = runs.next();
    if (!b)
        return std::nullopt;
    const Branches branches{a->first, a->last, b->first, b->last};
    return a->grows ? Pattern{branches, "P3", "P3 cut"}
                    : Pattern{branches, "P4", "P4 cut"};
}

// Length in s of the part from one vertex to another.
double s_between(const SectionChain& chain, std::int32_t from, std::int32_t to)
{
    return chain.at(to).x() - chain.at(from).x();
}

}  // namespace

void trim_literally(SectionChain& chain, double dead_band, const CrossingFinder& find,
                    FoldPatterns patterns)
{
    const Reading reading{dead_band, patterns};
    std::int32_t from = chain.first();
    while (const auto pattern = first_pattern(chain, reading, from)) {
        const Branches& branches = pattern->branches;
        if (const auto crossing = find(chain, branches)) {
            const std::int32_t right = chain.next(crossing->segment_b);
            from = chain.join(crossing->segment_a, right, *crossing, pattern->rule);
        } else if (s_between(chain, chain.first(), branches.cusp_a) >=
                   s_between(chain, branches.cusp_b, chain.last())) {
            chain.cut_behind(branches.cusp_a, pattern->cut_rule);
            return;
        } else {
            from = branches.cusp_b;
            chain.cut_before(from, pattern->cut_rule);
        }
    }
}

}  // namespace endmill
