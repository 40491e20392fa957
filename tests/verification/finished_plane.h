// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/verification/verification.h"
#include "test_surfaces.h"
#include "tip_path.h"

// Fixtures for most tests of verdicts: a plane, and a path of a ball of radius 5 that
// finishes it.
namespace endmill::test {

/// Returns passes over 0 ... 20 by 0 ... 12 at z = 0.
inline ToolPath finishing_path(double pitch)
{
    std::vector<Vec3> tips;
    for (int i = 0; i * pitch <= 12 + 1e-9; ++i) {
        tips.emplace_back(i % 2 ? 20 : 0, i * pitch, 0);
        tips.emplace_back(i % 2 ? 0 : 20, i * pitch, 0);
    }
    return tip_path(tips);
}

/// Returns a task with the ball, cells of 0.25 mm and limits that passes 2 mm apart meet.
inline VerificationTask task_of(const ToolPath& path, const Part* part)
{
    const Cutter ball = Cutter::ball(5);
    VerificationTask task{
        .path = &path, .cutter = ball, .stock = default_block(part, path, ball)};
    task.resolution = 0.25;
    if (part)
        task.judged = JudgedPart{part, {0.01, 0.11}};
    return task;
}

/// The part: a plane of 20 by 12 mm.
inline const Part finished_plane = std::vector<Surface>{test::plane(20, 12)};

}  // namespace endmill::test
