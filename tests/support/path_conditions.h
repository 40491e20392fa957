// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/path/tool_path.h"

namespace endmill::test {

/// The cutting conditions of each point of `path`.
inline std::vector<CuttingConditions> conditions_of(const ToolPath& path)
{
    std::vector<CuttingConditions> found;
    found.reserve(path.points.size());
    for (const PathPoint& point : path.points)
        found.push_back(point.conditions);
    return found;
}

/// Returns `path` with the conditions of its first points replaced.
/// \pre there are not more conditions than points.
inline ToolPath with_conditions(ToolPath path,
                                const std::vector<CuttingConditions>& conditions)
{
    for (std::size_t i = 0; i < conditions.size(); ++i)
        path.points[i].conditions = conditions[i];
    return path;
}

}  // namespace endmill::test
