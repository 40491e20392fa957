// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "endmill/offset/offset_mesh.h"
#include "test_surfaces.h"

// Parts to offset, and properties of every offset.
namespace endmill::test {

/// The valley of datasets/surfaces/valley.json.
inline Surface narrowing_valley()
{
    std::vector<Vec3> net;
    constexpr std::array<std::array<int, 2>, 4> heights{
        {{40, 20}, {45, 0}, {55, -20}, {60, -40}}};
    for (int row = 0; row < 4; ++row) {
        const auto& [outer, inner] = heights[row];
        const double y = 100 * row / 3.0;
        net.emplace_back(0, y, outer);
        net.emplace_back(60, y, inner);
        net.emplace_back(40, y, inner);
        net.emplace_back(100, y, outer);
    }
    return composite_bezier(1, 1, net);
}

/// z = height(x, y) over [x0, x1] by [y0, y1], bilinear between the corners.
template <class Height>
Surface facet(const Rectangle& over, const Height& height)
{
    std::vector<Vec3> net;
    for (const double y : {over.y.low, over.y.high})
        for (const double x : {over.x.low, over.x.high})
            net.emplace_back(x, y, height(x, y));
    return Surface{{0, 1}, {0, 1}, {BezierPatch{1, 1, net}}};
}

/// Four facets of z = -slope (|x| + |y|) over [-size, size]^2 that meet at the origin;
/// with a negative slope they form a pit.
inline std::vector<Surface> pyramid(double size, double slope)
{
    std::vector<Surface> facets;
    for (const Interval y : {Interval{-size, 0}, Interval{0, size}})
        for (const Interval x : {Interval{-size, 0}, Interval{0, size}})
            facets.push_back(facet({x, y}, [&](double at_x, double at_y) {
                return -slope * (std::abs(at_x) + std::abs(at_y));
            }));
    return facets;
}

/// The uses of an edge of a mesh: forward minus backward uses, and the number of its
/// triangles.
struct EdgeUse {
    int balance = 0;
    int count = 0;
};

inline std::map<std::pair<int, int>, EdgeUse> edge_uses_of(const TriangleMesh& mesh)
{
    std::map<std::pair<int, int>, EdgeUse> uses;
    for (const Triangle& triangle : mesh.triangles())
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
            EdgeUse& use = uses[{low, high}];
            use.balance += triangle[k] == low ? 1 : -1;
            ++use.count;
        }
    return uses;
}

/// The number of loops of open edges. It is -1 if an edge has more than two triangles or
/// two of opposite orientation, or if an open edge lies where its normals are not level.
inline int rims(const OffsetMesh& offset)
{
    std::map<int, int> next;
    for (const auto& [edge, use] : edge_uses_of(offset.mesh)) {
        if (use.count == 2 && use.balance == 0)
            continue;
        const auto [a, b] = edge;
        if (use.count != 1 || offset.contacts[a].normal.z() != 0 ||
            offset.contacts[b].normal.z() != 0)
            return -1;
        next[use.balance > 0 ? a : b] = use.balance > 0 ? b : a;
    }
    int loops = 0;
    while (!next.empty()) {
        ++loops;
        for (auto at = next.begin(); at != next.end();) {
            const int to = at->second;
            next.erase(at);
            at = next.find(to);
        }
    }
    return loops;
}

}  // namespace endmill::test
