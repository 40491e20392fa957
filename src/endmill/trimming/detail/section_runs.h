// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "endmill/trimming/detail/section_chain.h"

namespace endmill {

/// Along which coordinate the runs of a chain are told apart.
enum class RunAxis : std::uint8_t { S, Z };

/// A maximal run of a chain on which the coordinate grows, or falls.
struct SectionRun {
    std::int32_t first;  ///< vertex
    std::int32_t last;
    bool grows;
};

/// How much a coordinate changes without being said to, in mm: 1e-10 of the larger extent.
/// Below it the signs of differences at level places are those of rounding.
/// \throws DomainError on fewer than two points or one that is not finite.
double dead_band(std::span<const SectionPoint> points);

/// The runs of a chain, one after the other. A segment that changes by no more than the
/// dead band joins the run before it; leading ones join none.
class RunReader {
public:
    /// \param dead_band in mm. \param from the vertex to begin at.
    /// \pre behind the vertex behind `from` all are still as in the input.
    RunReader(const SectionChain& chain, RunAxis axis, double dead_band,
              std::int32_t from);

    /// Nothing behind the last run.
    std::optional<SectionRun> next();

private:
    std::int32_t following(std::int32_t vertex) const;

    const SectionChain& chain_;
    int axis_;
    double dead_band_;
    std::int32_t from_;
    std::int32_t vertex_;  // where the next run begins, but for leading segments
};

/// How many maximal runs of a trimmed curve lead back in s: reversals that are left. Runs as
/// those of a chain.
/// \param dead_band in mm.
int backward_runs(std::span<const TrimmedPoint> points, double dead_band);

}  // namespace endmill
