// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace endmill {

/// How long a path takes, and what a varied feed saves against one for all moves. What
/// cannot be told is none.
struct FeedTimes {
    double cut_min;
    std::optional<double> noncut_min = {};         ///< approaches, returns, dwells
    std::optional<double> total_min = {};          ///< both
    std::optional<double> constant_feed_min = {};  ///< the total at the constant feed
    std::optional<double> saving_percent = {};     ///< of that; negative: it takes longer
};

/// What the times are made of.
struct TimeParts {
    double cut_length_mm;                                 ///< above 0
    double cut_min;                                       ///< above 0
    std::optional<double> noncut_min = {};                ///< from 0
    std::optional<double> constant_feed_mm_per_min = {};  ///< above 0
};

/// The times of a path. Source: [ParkMaeng, section 5]; spec of ball-end milling, section 8.
/// \throws DomainError unless the parts are finite and as said.
FeedTimes feed_times(const TimeParts& parts);

/// The share of `constant_min` that `varied_min` saves, in %: 100 (1 - varied / constant).
/// \throws DomainError unless both are above 0.
double saving_percent(double varied_min, double constant_min);

/// The total time of one path at one feed for all of its cuts.
struct ConstantFeedRun {
    double feed_mm_per_min;  ///< above 0
    double total_min;        ///< above 0
};

/// What a total time is made of: total = length / feed + noncut.
struct RunParts {
    double length_mm;
    double noncut_min;
};

/// The length and the time besides that two runs of the same path tell. An error e of the
/// totals makes one of 2 e / |1/feed - 1/feed'| in the length.
/// Source: spec of ball-end milling, section 8.
/// \throws DomainError unless the runs are as said and of different feeds.
RunParts parts_of_runs(const ConstantFeedRun& one, const ConstantFeedRun& other);

}  // namespace endmill
