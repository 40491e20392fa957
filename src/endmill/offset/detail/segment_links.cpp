// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/segment_links.h"

#include <algorithm>
#include <array>
#include <bit>

namespace endmill {
namespace {

// Multiplicative hash with odd factors whose bits are well spread.
std::uint64_t spread(const CrossedEdge& edge)
{
    return static_cast<std::uint64_t>(edge.below) * 0x9E3779B97F4A7C15 +
           static_cast<std::uint64_t>(edge.above) * 0xC2B2AE3D27D4EB4F;
}

}  // namespace

void SegmentLinks::link(std::span<const CrossedEdge> from,
                        std::span<const CrossedEdge> to)
{
    next_.assign(from.size(), none);
    is_entered_.assign(from.size(), 0);
    open_.clear();
    guess(from, to);
    if (!open_.empty())
        look_up(from, to);
}

// Links segments by a guess. The cells of a grid come row by row with two triangles each,
// so that the next segment is one or three places away in the list. The step that was
// right for the last segment of the same parity is tried first. Segments that no guess
// links remain in open_.
void SegmentLinks::guess(std::span<const CrossedEdge> from,
                         std::span<const CrossedEdge> to)
{
    const auto count = static_cast<std::uint32_t>(from.size());
    std::array<Index, 2> likely{1, 1};
    for (Index k = 0; k < static_cast<Index>(count); ++k) {
        const auto edge = std::bit_cast<std::uint64_t>(to[k]);
        const auto goes_on = [&](Index step) {
            const auto other = static_cast<std::uint32_t>(k + step);
            return other < count && std::bit_cast<std::uint64_t>(from[other]) == edge &&
                   is_entered_[other] == 0;
        };
        Index& step = likely[k & 1];
        if (!goes_on(step)) {
            constexpr std::array<Index, 4> steps{1, -1, 3, -3};
            const auto found = std::ranges::find_if(steps, goes_on);
            if (found == steps.end()) {
                open_.push_back(k);
                continue;
            }
            step = *found;
        }
        join(k, k + step);
    }
}

// Links the segments in open_ with a hash table of the segments that have no predecessor
// yet.
void SegmentLinks::look_up(std::span<const CrossedEdge> from,
                           std::span<const CrossedEdge> to)
{
    const std::size_t size = std::bit_ceil(2 * open_.size() + 16);
    table_.assign(size, none);
    const int shift = 64 - std::countr_zero(size);
    const auto place_of = [&](const CrossedEdge& edge, const auto& is_it) {
        std::size_t place = spread(edge) >> shift;
        while (table_[place] != none && !is_it(table_[place]))
            place = (place + 1) & (size - 1);
        return place;
    };
    for (Index k = 0; k < static_cast<Index>(from.size()); ++k)
        if (is_entered_[k] == 0)
            table_[place_of(from[k], [](Index) { return false; })] = k;
    for (const Index k : open_) {
        const auto found = table_[place_of(to[k], [&](Index other) {
            return from[other] == to[k] && is_entered_[other] == 0;
        })];
        if (found != none)
            join(k, found);
    }
}

void SegmentLinks::join(Index segment, Index next)
{
    next_[segment] = next;
    is_entered_[next] = 1;
}

}  // namespace endmill
