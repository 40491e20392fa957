// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/literal_folds.h"

#include "endmill/trimming/detail/section_runs.h"

namespace endmill {
namespace {

// A pattern in the signs of dz, and its words.
struct Pattern {
    Branches branches;
    std::string_view rule;
    std::string_view cut_rule;
};

// How the paper's runs are read.
struct Reading {
    double dead_band;  // mm
    bool has_p3;
};

// Signs alternate, so that only the first run behind `from`, without P3 the first that
// falls, can begin a pattern which no other begins before.
std::optional<Pattern> first_pattern(const SectionChain& chain, const Reading& reading,
                                     std::int32_t from)
{
    RunReader runs{chain, RunAxis::Z, reading.dead_band, from};
    auto a = runs.next();
    if (a && a->grows && !reading.has_p3)
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

double s_between(const SectionChain& chain, std::int32_t from, std::int32_t to)
{
    return chain.at(to).x() - chain.at(from).x();
}

}  // namespace

void trim_literally(SectionChain& chain, double dead_band, CrossingSearch* search,
                    const TrimmingOptions& options)
{
    const Reading reading{dead_band, options.three_runs_twist};
    std::int32_t from = chain.first();
    while (const auto pattern = first_pattern(chain, reading, from)) {
        const Branches& branches = pattern->branches;
        if (const auto crossing = search(chain, branches, options)) {
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
