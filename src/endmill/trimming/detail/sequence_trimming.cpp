// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/sequence_trimming.h"

#include "endmill/trimming/detail/branch_trimming.h"

namespace endmill {
namespace {

// Visits the segments of branch A in the order in which a coordinate grows. A is monotone
// in that coordinate.
class UpwardSegments {
public:
    // Starts with the segment that contains `value`, or with the lowest of A.
    UpwardSegments(const SectionChain& chain, const Branches& branches, int axis,
                   double value)
        : chain_{chain},
          axis_{axis},
          grows_{chain.at(branches.first_a)[axis] < chain.at(branches.cusp_a)[axis]},
          vertex_{branches.cusp_a},
          end_{grows_ ? branches.cusp_a : branches.first_a}
    {
        while (grows_ && vertex_ != branches.first_a && low() > value)
            vertex_ = chain.previous(vertex_);
    }

    bool has_segment() const { return vertex_ != end_; }

    std::int32_t segment() const { return grows_ ? vertex_ : chain_.previous(vertex_); }

    double low() const { return chain_.at(vertex_)[axis_]; }

    double high() const { return chain_.at(following())[axis_]; }

    void advance() { vertex_ = following(); }

private:
    std::int32_t following() const
    {
        return grows_ ? chain_.next(vertex_) : chain_.previous(vertex_);
    }

    const SectionChain& chain_;
    int axis_;
    bool grows_;
    std::int32_t vertex_;  // the lower end of the current segment
    std::int32_t end_;
};

}  // namespace

std::optional<ChainCrossing> scan_segments(const SectionChain& chain,
                                           const Branches& branches,
                                           const TrimmingOptions& options)
{
    const CrossingType type = crossing_type(options.detection);
    for (std::int32_t b = branches.cusp_b; b != branches.last_b; b = chain.next(b)) {
        const auto a = first_crossed_of_a(chain, branches, b);
        if (!a)
            continue;
        if (const auto crossing = crossing_of(chain, *a, b, type))
            return crossing;
    }
    return std::nullopt;
}

std::optional<ChainCrossing> scan_to_end(const SectionChain& chain,
                                         const Branches& branches,
                                         const TrimmingOptions& options)
{
    Branches printed = branches;
    if (options.detection == FoldDetection::Literal)
        printed.last_b = chain.last();
    return scan_segments(chain, printed, options);
}

// Merges A and B like two sorted lists. For each segment of B, segments of A that end
// below it are passed for good. The segments of A beside it are tested, from a copy of
// the pointer, because the next segment of B may lie beside them as well.
std::optional<ChainCrossing> march_segments(const SectionChain& chain,
                                            const Branches& branches,
                                            const TrimmingOptions& options)
{
    const CrossingType type = crossing_type(options.detection);
    const int axis = type == CrossingType::Valley ? 0 : 1;
    UpwardSegments a{chain, branches, axis, chain.at(branches.cusp_b)[axis]};
    for (std::int32_t b = branches.cusp_b; b != branches.last_b; b = chain.next(b)) {
        const double low = chain.at(b)[axis];
        const double high = chain.at(chain.next(b))[axis];
        while (a.has_segment() && a.high() < low)
            a.advance();
        if (!a.has_segment())
            return std::nullopt;
        for (UpwardSegments beside = a; beside.has_segment() && beside.low() <= high;
             beside.advance()) {
            if (const auto crossing = crossing_of(chain, beside.segment(), b, type))
                return crossing;
        }
    }
    return std::nullopt;
}

std::optional<ChainCrossing> search_in_sequence(const SectionChain& chain,
                                                const Branches& branches,
                                                const TrimmingOptions& options)
{
    switch (options.search) {
        case BranchSearch::Scan:
            return scan_segments(chain, branches, options);
        case BranchSearch::ScanToEnd:
            return scan_to_end(chain, branches, options);
        case BranchSearch::March:
            break;
    }
    return march_segments(chain, branches, options);
}

Trimmed trim_in_sequence(std::span<const SectionCurve> curves,
                         const TrimmingOptions& options)
{
    return trim_branches(curves, {search_in_sequence}, options);
}

Trimmed trim_repaired(std::span<const SectionCurve> curves,
                      const TrimmingOptions& options)
{
    TrimmingOptions guarded = options;
    guarded.detection = FoldDetection::Guarded;
    return trim_branches(curves, {march_segments, RunPairs::All}, guarded);
}

}  // namespace endmill
