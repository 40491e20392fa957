// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "endmill/trimming/detail/section_chain.h"

namespace endmill {

/// The coordinate whose growth and fall divide a chain into runs.
enum class RunAxis : std::uint8_t { S, Z };

/// A maximal run of a chain on which a coordinate grows, or falls.
struct SectionRun {
    std::int32_t first;  ///< first vertex
    std::int32_t last;   ///< last vertex
    /// Whether the coordinate grows.
    bool grows;
};

/// The largest change of a coordinate, in mm, that counts as no change: 1e-10 of the
/// larger extent of the curve. Below it, the signs of differences at level places are
/// those of rounding errors.
/// \param points of a section curve.
/// \throws DomainError on fewer than two points or on a point that is not finite.
double dead_band(std::span<const SectionPoint> points);

/// Reads the runs of a chain one after the other. A segment that changes by no more than
/// the dead band belongs to the run before it. Leading segments of this kind belong to no
/// run.
class RunReader {
public:
    /// \param chain the curve.
    /// \param axis the coordinate.
    /// \param dead_band in mm.
    /// \param from the first vertex.
    /// \pre from the second vertex on, all vertices behind `from` are as in the input.
    RunReader(const SectionChain& chain, RunAxis axis, double dead_band,
              std::int32_t from);

    /// The next run; nothing after the last one.
    std::optional<SectionRun> next();

private:
    std::int32_t following(std::int32_t vertex) const;

    const SectionChain& chain_;
    int axis_;
    double dead_band_;
    std::int32_t from_;
    std::int32_t vertex_;  // start of the next run, or of level segments before it
};

/// Number of maximal runs of a trimmed curve that lead back in s. These are folds that
/// remain. Runs are defined as those of a chain.
/// \param points of the trimmed curve.
/// \param dead_band in mm.
int backward_runs(std::span<const TrimmedPoint> points, double dead_band);

}  // namespace endmill
