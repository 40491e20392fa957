// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/collapsed_edge.h"

#include <algorithm>

#include "endmill/core/tolerance.h"

namespace endmill {

bool is_collapsed(const BezierPatch& patch, Parameter parameter, int edge)
{
    const int last_u = patch.degree(Parameter::U);
    const int last_v = patch.degree(Parameter::V);
    const auto on_edge = [&](int k) {
        return parameter == Parameter::U ? patch.control_point(last_u * edge, k)
                                         : patch.control_point(k, last_v * edge);
    };
    double size = 0;
    for (int j = 0; j <= last_v; ++j)
        for (int i = 0; i <= last_u; ++i)
            size = std::max(size, (patch.control_point(i, j) - on_edge(0)).norm());
    double length = 0;
    for (int k = 1; k <= (parameter == Parameter::U ? last_v : last_u); ++k)
        length = std::max(length, (on_edge(k) - on_edge(0)).norm());
    return length <= same_point_share * size;
}

}  // namespace endmill
