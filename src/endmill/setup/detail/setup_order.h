// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "endmill/machine/axis_limits.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// Areas, in rad^2, above which a fit is of no interest. They let a fit stop early.
struct AreaBounds {
    double least = std::numeric_limits<double>::infinity();  ///< of fits without limits
    double feasible = std::numeric_limits<double>::infinity();  ///< of fits within limits
};

/// The quantities by which setups are ordered: first the area, then the sum of both
/// ranges.
struct SetupScore {
    double area = std::numeric_limits<double>::infinity();  ///< rad^2
    double sum = std::numeric_limits<double>::infinity();   ///< rad
};

/// The largest area that counts as equal to `area`, in rad^2: it is larger by 1e-9 of the
/// area, or of a square degree for smaller areas.
double equal_area_limit(double area);

/// The largest sum that counts as equal to `sum`, in rad: it is larger by 1e-9 of the
/// sum, or of a degree for smaller sums.
double equal_sum_limit(double sum);

/// The score of a fitted pose.
SetupScore score_of(const FittedPose& fit);

/// Selects the best of the candidates that are offered to it.
///
/// Candidates whose area counts as equal to the least area are compared by their sum;
/// among equal sums the first candidate wins. Only the least area decides which areas are
/// equal, so a chain of nearly equal areas does not count as equal. Candidates with a
/// clearly larger area have no effect on the result, and need not be offered.
///
/// A bound saves work without a change of the result: if the least area offered does not
/// exceed the bound, the best candidate is the same as without a bound.
template <class Candidate>
class BestCandidate {
public:
    /// \param bound rad^2: there is no best candidate if all areas exceed it.
    explicit BestCandidate(double bound = std::numeric_limits<double>::infinity())
        : bound_{equal_area_limit(bound)}
    {
    }

    /// Returns true if a candidate of this area, rad^2, may be the best.
    bool wants(double area) const
    {
        return area <= equal_area_limit(std::min(bound_, area_));
    }

    /// Considers a candidate.
    void offer(const Candidate& candidate, const SetupScore& score)
    {
        if (!wants(score.area))
            return;
        area_ = std::min(area_, score.area);
        if (kept_.size() >= most_kept_) {
            std::erase_if(kept_,
                          [this](const Kept& kept) { return !wants(kept.score.area); });
            most_kept_ = 2 * kept_.size() + first_most_kept;
        }
        kept_.push_back({candidate, score});
    }

    /// The least area offered, rad^2; infinite if all areas exceed the bound.
    double area() const { return area_; }

    /// The largest area and the largest sum of candidates that count as equal to the best
    /// one. The best candidate is the first one offered that exceeds neither.
    SetupScore limit() const
    {
        double sum = std::numeric_limits<double>::infinity();
        for (const Kept& kept : kept_)
            if (wants(kept.score.area))
                sum = std::min(sum, kept.score.sum);
        return {equal_area_limit(std::min(bound_, area_)), equal_sum_limit(sum)};
    }

    /// The best candidate, or nothing if all areas exceed the bound.
    std::optional<Candidate> best() const
    {
        const SetupScore most = limit();
        for (const Kept& kept : kept_)
            if (kept.score.area <= most.area && kept.score.sum <= most.sum)
                return kept.candidate;
        return std::nullopt;
    }

private:
    struct Kept {
        Candidate candidate;
        SetupScore score;
    };

    // Candidates are removed only when their number has doubled, so that many areas, each
    // a little smaller than the one before, take linear time.
    static constexpr std::size_t first_most_kept = 8;

    double bound_;  // rad^2, the largest area of interest
    double area_ = std::numeric_limits<double>::infinity();
    std::size_t most_kept_ = first_most_kept;
    std::vector<Kept> kept_;  // holds all whose area counts as equal to the least
};

/// The range with its ends negated: it becomes this if the part is turned by 180 degrees
/// about the tool axis.
RotaryRange turned(const RotaryRange& range);

/// Tests whether `range` lies within `limits`, to 1e-9 rad.
bool is_within(const RotaryRange& range, const RotaryRange& limits);

/// Tests whether the larger and the smaller magnitude of the ends of `range` are at most
/// those of `limits`, to 1e-9 rad. Source: [KangSuh, eq. (12), (20)].
bool is_within_unsigned(const RotaryRange& range, const RotaryRange& limits);

/// The number of axes that a pose moves: `ThreeAxis`, `FourAxis` or `Ok`.
SetupStatus status_of(const FittedPose& fit);

}  // namespace endmill
