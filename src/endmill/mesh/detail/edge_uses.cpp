// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/edge_uses.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace endmill {
namespace {

// Calls `visit(from, to, triangle)` for the sides of all triangles with three different
// corners.
template <typename Visit>
void for_each_side(std::span<const Triangle> triangles, const Visit& visit)
{
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        if (repeats_a_corner(triangles[k]))
            continue;
        const auto& [a, b, c] = triangles[k];
        visit(a, b, k);
        visit(b, c, k);
        visit(c, a, k);
    }
}

}  // namespace

// A counting sort by the lower end of the edges, then a sort of the uses at each lower
// end.
EdgeUses::EdgeUses(const TriangleMesh& mesh) : begin_(mesh.points().size() + 1)
{
    for_each_side(mesh.triangles(), [&](std::int32_t from, std::int32_t to, std::size_t) {
        ++begin_[std::min(from, to)];
    });
    std::inclusive_scan(begin_.begin(), begin_.end(), begin_.begin());
    uses_.resize(begin_.back());
    // Fills the uses of each lower end from their end backwards to their beginning.
    for_each_side(mesh.triangles(),
                  [&](std::int32_t from, std::int32_t to, std::size_t triangle) {
                      uses_[--begin_[std::min(from, to)]] = {from, to, triangle};
                  });
    for (std::size_t low = 0; low + 1 < begin_.size(); ++low)
        std::ranges::sort(
            std::span{uses_}.subspan(begin_[low], begin_[low + 1] - begin_[low]),
            [](const EdgeUse& a, const EdgeUse& b) { return a.rank() < b.rank(); });
}

// At the edge between the two lower corners of a triangle, its duplicates have the same
// third corner.
std::vector<std::int32_t> duplicate_triangles(const TriangleMesh& mesh,
                                              const EdgeUses& edges)
{
    std::vector<std::int32_t> found;
    std::vector<std::pair<std::int32_t, std::int32_t>> thirds;  // third corner, triangle
    edges.for_each([&](const MeshEdge& edge, std::span<const EdgeUse> uses) {
        if (uses.size() < 2)
            return;
        thirds.clear();
        for (const EdgeUse& use : uses) {
            const auto& [a, b, c] = mesh.triangles()[use.triangle()];
            const std::int32_t third = a ^ b ^ c ^ edge[0] ^ edge[1];
            // so that each triangle is examined at one of its sides only
            if (third > edge[1])
                thirds.emplace_back(third, use.triangle());
        }
        std::ranges::sort(thirds);
        for (std::size_t k = 1; k < thirds.size(); ++k)
            if (thirds[k].first == thirds[k - 1].first)
                found.push_back(thirds[k].second);
    });
    std::ranges::sort(found);
    return found;
}

}  // namespace endmill
