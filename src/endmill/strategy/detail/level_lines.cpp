// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/level_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace endmill {
namespace {

// A crossed edge, by the representatives of its ends, the lower one first.
using EdgeKey = std::uint64_t;

EdgeKey edge_key(std::int32_t low, std::int32_t high)
{
    return static_cast<EdgeKey>(low) << 32 | static_cast<std::uint32_t>(high);
}

// One end of the segment of a line in one triangle.
struct SegmentEnd {
    EdgeKey key;
    SampleEdge place;
};

// Adds the ends of the segment in a triangle, if there is one.
void add_segment(const Triangle& triangle, const PartSamples& samples,
                 std::span<const double> values, double level,
                 std::vector<SegmentEnd>& ends)
{
    const std::array<double, 3> own{values[triangle[0]] - level,
                                    values[triangle[1]] - level,
                                    values[triangle[2]] - level};
    const std::array<bool, 3> below{own[0] < 0, own[1] < 0, own[2] < 0};
    if (below[0] == below[1] && below[1] == below[2])
        return;
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3;
        if (below[k] == below[l])
            continue;
        // both triangles at an edge must compute the same place
        const std::int32_t a = samples.representative(triangle[k]);
        const std::int32_t b = samples.representative(triangle[l]);
        const int first = a < b ? k : l;
        const int second = a < b ? l : k;
        ends.push_back({edge_key(std::min(a, b), std::max(a, b)),
                        {triangle[first], triangle[second],
                         own[first] / (own[first] - own[second])}});
    }
}

// Collects the ends of all segments, two by two.
std::vector<SegmentEnd> segment_ends(const PartSamples& samples,
                                     std::span<const double> values,
                                     std::span<const std::int32_t> near, double level)
{
    std::vector<SegmentEnd> ends;
    const std::span<const Triangle> triangles = samples.triangles();
    if (near.empty()) {
        for (const Triangle& triangle : triangles)
            add_segment(triangle, samples, values, level, ends);
        return ends;
    }
    // A crossed triangle is found at its first corner below the level, which is near.
    std::vector<std::int32_t> crossed;
    for (const std::int32_t i : near) {
        if (!(values[i] < level))
            continue;
        for (const std::int32_t number : samples.triangles_at(i)) {
            const auto& [a, b, c] = triangles[number];
            const std::int32_t least = values[a] < level ? a : values[b] < level ? b : c;
            if (least == i &&
                !(values[a] < level && values[b] < level && values[c] < level))
                crossed.push_back(number);
        }
    }
    std::sort(crossed.begin(), crossed.end());
    for (const std::int32_t number : crossed)
        add_segment(triangles[number], samples, values, level, ends);
    return ends;
}

}  // namespace

std::vector<LevelLine> level_lines(const PartSamples& samples,
                                   std::span<const double> values,
                                   std::span<const std::int32_t> near, double level)
{
    const std::vector<SegmentEnd> ends = segment_ends(samples, values, near, level);
    // partner[e]: the end of another segment at the same crossing, or -1
    std::vector<std::int32_t> partner(ends.size(), -1);
    std::vector<std::int32_t> order(ends.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        order[k] = static_cast<std::int32_t>(k);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return ends[a].key != ends[b].key ? ends[a].key < ends[b].key : a < b;
    });
    for (std::size_t k = 0; k + 1 < order.size(); ++k)
        if (ends[order[k]].key == ends[order[k + 1]].key && partner[order[k]] < 0) {
            partner[order[k]] = order[k + 1];
            partner[order[k + 1]] = order[k];
        }
    std::vector<bool> is_used(ends.size() / 2, false);
    std::vector<LevelLine> lines;
    // follows a line from end `entry` of a segment to its last place
    const auto follow = [&](std::int32_t entry) {
        LevelLine line{{ends[entry].place}, false};
        for (std::int32_t end = entry; end >= 0;) {
            is_used[end / 2] = true;
            const std::int32_t exit = end ^ 1;
            end = partner[exit];
            if (end >= 0 && is_used[end / 2]) {
                line.is_closed = end == entry;
                end = -1;
                if (line.is_closed)
                    break;
            }
            line.places.push_back(ends[exit].place);
        }
        lines.push_back(std::move(line));
    };
    for (std::size_t end = 0; end < ends.size(); ++end)
        if (!is_used[end / 2] && partner[end] < 0)
            follow(static_cast<std::int32_t>(end));
    for (std::size_t end = 0; end < ends.size(); ++end)
        if (!is_used[end / 2])
            follow(static_cast<std::int32_t>(end));
    return lines;
}

namespace {

// The places of a closed line, starting where its value changes from not positive to
// positive, so that no positive part is cut in two. Nothing if all values are positive.
bool starts_where_not_positive(std::vector<SampleEdge>& places,
                               std::span<const double> values, double level)
{
    for (std::size_t k = 0; k < places.size(); ++k)
        if (!(value_at(places[k], values) > level)) {
            std::rotate(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(k),
                        places.end());
            places.push_back(places.front());
            return true;
        }
    return false;
}

}  // namespace

std::vector<LevelLine> where_positive(std::span<const LevelLine> lines,
                                      std::span<const double> values, double level)
{
    std::vector<LevelLine> parts;
    for (const LevelLine& line : lines) {
        std::vector<SampleEdge> places = line.places;
        if (line.is_closed && !starts_where_not_positive(places, values, level)) {
            parts.push_back(line);
            continue;
        }
        LevelLine part{{}, false};
        for (std::size_t k = 0; k < places.size(); ++k) {
            const bool is_inside = value_at(places[k], values) > level;
            if (is_inside && part.places.empty() && k > 0)
                part.places.push_back(places[k - 1]);
            if (is_inside || !part.places.empty())
                part.places.push_back(places[k]);
            if (!part.places.empty() && (!is_inside || k + 1 == places.size())) {
                if (part.places.size() > 1)
                    parts.push_back(part);
                part.places.clear();
            }
        }
    }
    return parts;
}

}  // namespace endmill
