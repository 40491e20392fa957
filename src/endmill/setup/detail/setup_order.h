// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "endmill/machine/rotary_limits.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// What setups are compared by: the area, then the sum of the ranges.
struct SetupScore {
    double area = std::numeric_limits<double>::infinity();  ///< rad^2
    double sum = std::numeric_limits<double>::infinity();   ///< rad
};

/// The largest area that counts as equal to `area`: 1e-9 more, relative, or absolute below a
/// square degree. rad^2.
double equal_area_limit(double area);

/// The largest sum that counts as equal to `sum`: 1e-9 more, relative, or absolute below a
/// degree. rad.
double equal_sum_limit(double sum);

/// The area and the sum of the ranges.
SetupScore score_of(const FittedPose& fit);

/// The best of the candidates offered: of those whose area equals the least of all those of
/// least sum, and of these the first. Only the least area decides which are equal, so that
/// equalities do not chain. It is the same if candidates of areas certainly larger are not
/// offered.
///
/// A bound spares work and changes nothing that matters: wherever the least area offered equals
/// the bound or is below, the best is the one without a bound.
template <class Candidate>
class BestCandidate {
public:
    /// \param bound rad^2: unless the least area equals it or is below, none is of interest.
    explicit BestCandidate(double bound = std::numeric_limits<double>::infinity())
        : bound_{equal_area_limit(bound)}
    {
    }

    /// Whether a candidate of this area may be the best.
    bool wants(double area) const
    {
        return area <= equal_area_limit(std::min(bound_, area_));
    }

    /// Takes note of it.
    void offer(const Candidate& candidate, const SetupScore& score)
    {
        if (!wants(score.area))
            return;
        if (score.area < area_) {
            area_ = score.area;
            std::erase_if(kept_,
                          [this](const Kept& kept) { return !wants(kept.score.area); });
        }
        kept_.push_back({candidate, score});
    }

    /// The least area offered, rad^2; infinite if none is of interest.
    double area() const { return area_; }

    /// The best one, if any is of interest.
    std::optional<Candidate> best() const
    {
        double sum = std::numeric_limits<double>::infinity();
        for (const Kept& kept : kept_)
            sum = std::min(sum, kept.score.sum);
        for (const Kept& kept : kept_) {
            if (kept.score.sum <= equal_sum_limit(sum))
                return kept.candidate;
        }
        return std::nullopt;
    }

private:
    struct Kept {
        Candidate candidate;
        SetupScore score;
    };

    double bound_;  // the largest least area of interest
    double area_ = std::numeric_limits<double>::infinity();
    std::vector<Kept> kept_;  // of areas that count as equal to the least
};

/// -range: what it becomes if the part is turned by 180 degrees about the tool axis.
RotaryRange turned(const RotaryRange& range);

/// Whether `range` lies within `limits`, to 1e-9 rad.
bool is_within(const RotaryRange& range, const RotaryRange& limits);

/// Whether the larger and smaller magnitude of the ends of `range` are at most those of
/// `limits`, to 1e-9 rad. Source: [KangSuh, eq. (12), (20)].
bool is_within_unsigned(const RotaryRange& range, const RotaryRange& limits);

/// How well a pose is reached: `ThreeAxis`, `FourAxis` or `Ok`.
SetupStatus status_of(const FittedPose& fit);

}  // namespace endmill
