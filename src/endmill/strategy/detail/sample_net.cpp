// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/sample_net.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// An edge of a triangle: the representatives of its ends, then its ends, lower ones first.
using NetEdge = std::array<std::int32_t, 4>;

// The bits of three numbers from 0 to 1, interleaved; 21 of each.
std::uint64_t morton_code(const Vec3& place)
{
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        auto bits = static_cast<std::uint64_t>(place[axis] * 2097151.0);
        bits = (bits | bits << 32) & 0x1f00000000ffff;
        bits = (bits | bits << 16) & 0x1f0000ff0000ff;
        bits = (bits | bits << 8) & 0x100f00f00f00f00f;
        bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
        bits = (bits | bits << 2) & 0x1249249249249249;
        code |= bits << axis;
    }
    return code;
}

// Adds the parts of a triangle whose edges have the middles.
void divide(Triangle corners, const EdgeMiddles& middles_of, std::vector<Triangle>& parts)
{
    std::array<std::int32_t, 3> middles{};
    int count = 0;
    for (int k = 0; k < 3; ++k) {
        middles[k] = middles_of.of(corners[k], corners[(k + 1) % 3]).value_or(-1);
        count += middles[k] >= 0 ? 1 : 0;
    }
    const auto turn = [&] {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        std::rotate(middles.begin(), middles.begin() + 1, middles.end());
    };
    const auto& [a, b, c] = corners;
    const auto& [ab, bc, ca] = middles;
    if (count == 0) {
        parts.push_back(corners);
    } else if (count == 1) {
        while (ab < 0)
            turn();
        parts.push_back({a, ab, c});
        parts.push_back({ab, b, c});
    } else if (count == 2) {
        while (ca >= 0)
            turn();
        parts.push_back({ab, b, bc});
        parts.push_back({a, ab, bc});
        parts.push_back({a, bc, c});
    } else {
        parts.push_back({a, ab, ca});
        parts.push_back({ab, b, bc});
        parts.push_back({ca, bc, c});
        parts.push_back({ab, bc, ca});
    }
}

// The edges of all triangles without regard to twins, in rising order, with repetitions.
// They are sorted by their lower ends first, in linear time.
std::vector<MeshEdge> own_edges(std::span<const Triangle> triangles)
{
    std::vector<std::size_t> next;  // place for the next edge of each lower end
    const auto for_edges = [&](const auto& visit) {
        for (const Triangle& triangle : triangles)
            for (int k = 0; k < 3; ++k) {
                const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
                visit(static_cast<std::size_t>(low), MeshEdge{low, high});
            }
    };
    for_edges([&](std::size_t low, const MeshEdge&) {
        if (next.size() < low + 2)
            next.resize(std::max(low + 2, 2 * next.size()), 0);
        ++next[low + 1];
    });
    std::partial_sum(next.begin(), next.end(), next.begin());
    std::vector<MeshEdge> edges(3 * triangles.size());
    for_edges([&](std::size_t low, const MeshEdge& edge) { edges[next[low]++] = edge; });
    for (std::size_t low = 0, first = 0; low < next.size(); first = next[low++])
        std::sort(edges.begin() + static_cast<std::ptrdiff_t>(first),
                  edges.begin() + static_cast<std::ptrdiff_t>(next[low]));
    return edges;
}

// The end of the run of equal places that begins at `first`.
template <typename Edges, typename IsSame>
std::size_t end_of_run(const Edges& edges, std::size_t first, const IsSame& is_same)
{
    std::size_t next = first + 1;
    while (next < edges.size() && is_same(edges[first], edges[next]))
        ++next;
    return next;
}

}  // namespace

SampleLists::SampleLists(std::size_t samples, std::span<const MeshEdge> entries)
{
    first_.assign(samples + 1, 0);
    for (const auto& [sample, number] : entries)
        ++first_[sample + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    numbers_.resize(entries.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const auto& [sample, number] : entries)
        numbers_[next[sample]++] = number;
}

SampleLists net_neighbours(std::span<const Triangle> triangles,
                           std::span<const std::int32_t> representatives)
{
    std::vector<MeshEdge> edges = own_edges(triangles);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    // twins are neighbours through their representative
    for (std::size_t i = 0; i < representatives.size(); ++i)
        if (representatives[i] != static_cast<std::int32_t>(i))
            edges.push_back({representatives[i], static_cast<std::int32_t>(i)});
    std::vector<MeshEdge> entries;
    entries.reserve(2 * edges.size());
    for (const auto& [a, b] : edges) {
        entries.push_back({a, b});
        entries.push_back({b, a});
    }
    return {representatives.size(), entries};
}

SampleLists net_triangles_at(std::span<const Triangle> triangles, std::size_t samples)
{
    std::vector<MeshEdge> entries;
    entries.reserve(3 * triangles.size());
    for (std::size_t number = 0; number < triangles.size(); ++number)
        for (const std::int32_t corner : triangles[number])
            entries.push_back({corner, static_cast<std::int32_t>(number)});
    return {samples, entries};
}

std::vector<MeshEdge> net_border(std::span<const Triangle> triangles,
                                 std::span<const std::int32_t> representatives)
{
    const std::vector<MeshEdge> edges = own_edges(triangles);
    std::vector<NetEdge> single;
    for (std::size_t k = 0, next = 0; k < edges.size(); k = next) {
        next = end_of_run(edges, k, std::equal_to<>{});
        const auto [a, b] = edges[k];
        const auto [ra, rb] = std::minmax(representatives[a], representatives[b]);
        if (next == k + 1 && ra != rb)
            single.push_back({ra, rb, a, b});
    }
    std::sort(single.begin(), single.end());
    const auto is_same_place = [](const NetEdge& a, const NetEdge& b) {
        return a[0] == b[0] && a[1] == b[1];
    };
    std::vector<MeshEdge> border;
    for (std::size_t k = 0, next = 0; k < single.size(); k = next) {
        next = end_of_run(single, k, is_same_place);
        if (next == k + 1)
            border.push_back({single[k][2], single[k][3]});
    }
    return border;
}

std::vector<std::int32_t> numbers_by_place(std::span<const Vec3> points)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points)
        box.extend(point);
    const double side = std::max(box.sizes().maxCoeff(), 1e-300);
    std::vector<std::pair<std::uint64_t, std::int32_t>> order(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        order[i] = {morton_code((points[i] - box.min()) / side),
                    static_cast<std::int32_t>(i)};
    std::sort(order.begin(), order.end());
    std::vector<std::int32_t> numbers(points.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        numbers[order[k].second] = static_cast<std::int32_t>(k);
    return numbers;
}

std::vector<Triangle> divided_triangles(std::span<const Triangle> triangles,
                                        const EdgeMiddles& middles,
                                        std::span<const char> may_be_divided)
{
    std::vector<Triangle> divided;
    divided.reserve(triangles.size() * 2);
    for (std::size_t k = 0; k < triangles.size(); ++k)
        if (may_be_divided.empty() || may_be_divided[k] != 0)
            divide(triangles[k], middles, divided);
        else
            divided.push_back(triangles[k]);
    return divided;
}

}  // namespace endmill
