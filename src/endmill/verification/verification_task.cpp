// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/verification_task.h"

namespace endmill {

PartCharts judged_charts(const VerificationTask& task)
{
    const Part& part = *task.judged->part;
    if (task.engine == RemovalEngine::ThreeAxis)
        return part_charts(part);
    std::vector<Vec3> axes;
    axes.reserve(task.path->points.size());
    for (const PathPoint& point : task.path->points)
        axes.push_back(point.location.axis);
    return part_charts(part, axes);
}

}  // namespace endmill
