// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <vector>

#include "endmill/process/ball_engagement.h"

namespace endmill {

/// Random engagements of a ball-end cutter beside a previous pass: mu in [-1.3, 1.3),
/// lambda in [-1.2, 1.2), pick feed in [0.02, 1), depth in [0.05, 1.55). The generator is
/// MT19937 with seed 7; a number takes two draws, the lower half first.
inline std::vector<BallEngagement> random_engagements(int count)
{
    std::mt19937 engine{7};
    const auto uniform = [&] {
        const double low = engine();
        const double high = engine();
        return (low + 4294967296.0 * high) / 18446744073709551616.0;
    };
    std::vector<BallEngagement> engagements;
    for (int k = 0; k < count; ++k) {
        const double mu = -1.3 + 2.6 * uniform();
        const double lambda = -1.2 + 2.4 * uniform();
        const double pick_feed = 0.02 + 0.98 * uniform();
        engagements.push_back({mu, lambda, pick_feed, 0.05 + 1.5 * uniform()});
    }
    return engagements;
}

}  // namespace endmill
