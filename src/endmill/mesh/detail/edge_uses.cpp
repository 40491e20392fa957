// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/edge_uses.h"

#include <algorithm>
#include <array>
#include <compare>
#include <numeric>

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

// Whether two triangles that use edges of one lower end may share two of these edges. The
// uses are those of the lower end, sorted by edge. If there are many, or an edge has more
// than two triangles, the answer is true without a closer look. It is false at nearly all
// points of a mesh without duplicates, and then takes a fraction of the time of the sorts
// below.
bool may_repeat(std::span<const EdgeUse> uses)
{
    constexpr std::size_t most_pairs = 16;
    std::array<std::uint64_t, most_pairs> pairs;  // that share an edge, as one number
    std::size_t count = 0;
    for (std::size_t k = 1; k < uses.size(); ++k) {
        if (uses[k].high() != uses[k - 1].high())
            continue;
        const bool is_third = k >= 2 && uses[k].high() == uses[k - 2].high();
        if (is_third || count == most_pairs)
            return true;
        const auto [a, b] = std::minmax({uses[k - 1].triangle(), uses[k].triangle()});
        pairs[count] = std::uint64_t(a) << 32U | std::uint64_t(b);
        if (std::find(pairs.begin(), pairs.begin() + count, pairs[count]) !=
            pairs.begin() + count)
            return true;
        ++count;
    }
    return false;
}

}  // namespace

// A counting sort by the lower end of the edges, then a sort of the uses at each lower
// end.
EdgeUses::EdgeUses(std::size_t points, std::span<const Triangle> triangles)
    : begin_(points + 1)
{
    for_each_side(triangles, [&](std::int32_t from, std::int32_t to, std::size_t) {
        ++begin_[std::min(from, to)];
    });
    std::inclusive_scan(begin_.begin(), begin_.end(), begin_.begin());
    uses_.resize(begin_.back());
    // Fills the uses of each lower end from their end backwards to their beginning.
    for_each_side(triangles,
                  [&](std::int32_t from, std::int32_t to, std::size_t triangle) {
                      uses_[--begin_[std::min(from, to)]] = {from, to, triangle};
                  });
    for (std::size_t low = 0; low + 1 < begin_.size(); ++low)
        std::ranges::sort(
            std::span{uses_}.subspan(begin_[low], begin_[low + 1] - begin_[low]),
            [](const EdgeUse& a, const EdgeUse& b) { return a.rank() < b.rank(); });
}

// The point with the lowest number of a triangle is the lower end of two of its sides, so
// that their uses name the other two corners. The corners are not read from the mesh,
// where they lie scattered if its triangles are in no order.
std::vector<std::int32_t> duplicate_triangles(const EdgeUses& edges)
{
    struct Side {
        std::int32_t triangle;
        std::int32_t high;
        // NOLINTNEXTLINE(modernize-use-nullptr): no pointer is there
        auto operator<=>(const Side&) const = default;
    };
    struct Corners {
        std::int32_t middle;
        std::int32_t high;
        std::int32_t triangle;
        // NOLINTNEXTLINE(modernize-use-nullptr)
        auto operator<=>(const Corners&) const = default;
    };
    std::vector<std::int32_t> found;
    std::vector<Side> sides;
    std::vector<Corners> lowest_here;
    edges.for_each_lower_end([&](std::span<const EdgeUse> uses) {
        if (!may_repeat(uses))
            return;
        sides.clear();
        lowest_here.clear();
        for (const EdgeUse& use : uses)
            sides.push_back({use.triangle(), use.high()});
        std::ranges::sort(sides);
        for (std::size_t k = 1; k < sides.size(); ++k)
            if (sides[k].triangle == sides[k - 1].triangle)
                lowest_here.push_back(
                    {sides[k - 1].high, sides[k].high, sides[k].triangle});
        std::ranges::sort(lowest_here);
        for (std::size_t k = 1; k < lowest_here.size(); ++k)
            if (lowest_here[k].middle == lowest_here[k - 1].middle &&
                lowest_here[k].high == lowest_here[k - 1].high)
                found.push_back(lowest_here[k].triangle);
    });
    std::ranges::sort(found);
    return found;
}

}  // namespace endmill
