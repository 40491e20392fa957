// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/collapsed_edge.h"

#include <algorithm>

namespace endmill {
namespace {

constexpr double same_point_share = 1e-12;  // of the patch's size

}  // namespace

bool is_collapsed(const BezierPatch& patch, Parameter parameter, int edge)
{
    const int line = 3 * edge;
    const auto on_edge = [&](int k) {
        return parameter == Parameter::U ? patch.control_point(line, k)
                                         : patch.control_point(k, line);
    };
    double size = 0;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            size = std::max(size, (patch.control_point(i, j) - on_edge(0)).norm());
    double length = 0;
    for (int k = 1; k < 4; ++k)
        length = std::max(length, (on_edge(k) - on_edge(0)).norm());
    return length <= same_point_share * size;
}

}  // namespace endmill
