// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/path/tool_path.h"
#include "random.h"

namespace endmill::test {

/// A path of random tips between `low` and `high` that a program can represent: it begins
/// with a plunge, rapids are level, and feeds and speeds change now and then.
inline ToolPath random_path(unsigned seed, int points, double low = -100,
                            double high = 100)
{
    Random random{seed};
    ToolPath path;
    Vec3 tip = Vec3::Zero();
    double feed = 800;
    double speed = 6000;
    for (int k = 0; k < points; ++k) {
        const bool is_rapid = k > 0 && random.uniform(0, 1) < 0.1;
        for (int c = 0; c < (is_rapid ? 2 : 3); ++c)
            tip[c] = random.uniform(low, high);
        feed = random.uniform(0, 1) < 0.2 ? random.uniform(50, 3000) : feed;
        speed = random.uniform(0, 1) < 0.05 ? random.uniform(500, 20000) : speed;
        const Move move = k == 0 ? Move::Plunge : is_rapid ? Move::Rapid : Move::Cut;
        path.points.push_back(
            {.pass = 0,
             .point = k,
             .move = move,
             .location = {tip, Vec3::UnitZ()},
             .conditions = {is_rapid ? std::nullopt : std::optional{feed}, speed, 3}});
    }
    return path;
}

}  // namespace endmill::test
