// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/height_block.h"

#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

namespace endmill {

HeightBlock height_block(double half, double bottom, int steps,
                         const std::function<double(double x, double y)>& height)
{
    const int side = steps + 1;
    std::vector<Vec3> points;
    for (const bool is_top : {true, false})
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const double x = half * (2.0 * i / steps - 1);
                const double y = half * (2.0 * j / steps - 1);
                points.emplace_back(x, y, is_top ? height(x, y) : bottom);
            }
    std::vector<Triangle> triangles;
    const auto add = [&](int a, int b, int c, int d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    };
    const auto top = [side](int i, int j) { return j * side + i; };
    const auto below = [side](int corner) { return side * side + corner; };
    for (int j = 0; j < steps; ++j)
        for (int i = 0; i < steps; ++i)
            add(top(i, j), top(i + 1, j), top(i + 1, j + 1), top(i, j + 1));
    const std::size_t on_top = triangles.size();
    for (int j = 0; j < steps; ++j)
        for (int i = 0; i < steps; ++i)
            add(below(top(i, j)), below(top(i, j + 1)), below(top(i + 1, j + 1)),
                below(top(i + 1, j)));
    const auto wall = [&](int from, int to) { add(below(from), below(to), to, from); };
    for (int k = 0; k < steps; ++k) {
        wall(top(k, 0), top(k + 1, 0));
        wall(top(steps, k), top(steps, k + 1));
        wall(top(k + 1, steps), top(k, steps));
        wall(top(0, k + 1), top(0, k));
    }
    HeightBlock block{TriangleMesh{std::move(points), triangles}, {}};
    block.others.resize(triangles.size() - on_top);
    std::iota(block.others.begin(), block.others.end(), on_top);
    return block;
}

}  // namespace endmill
