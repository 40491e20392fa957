// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/shadow_lanes.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>

#include "endmill/core/detail/widest_registers.h"

namespace endmill {
namespace {

constexpr std::uint32_t lanes = float_lanes;
static_assert(lanes == PointBlock::size);

// Error bounds of edge functions, normals and depths.
//
// Coordinates are at most 1 in magnitude and have errors of at most h, which is at least
// half a rounding. So differences have errors of at most 2 h and a rounding. |v| is the
// sum of the magnitudes of the components of v. R is the largest difference in x or y
// between a centroid in question and a corner, at least 32 h; Z is the same in z, at
// least R.
//
// 1. An edge function is d x e + c, where c is the value at the first corner. The errors
//    of d and e contribute 2 h |e| + 4 h R, those of c the same, and 5 roundings of |e| R
//    occur in each part. The sum is at most 4 h |e| + 8 h R + 20 h |e| R.
// 2. A component of the normal of the sides e and f, with S = |e| + |f|, has an error of
//    2 h S, 5 roundings of |e| |f| <= S^2 / 4, and 8 h^2. The sum is at most h S (3 + 3
//    S), because S exceeds 12 h if the sign of z is certain.
// 3. The depth is n . d. The error of n contributes 2 h S (2 R + Z); that of d
//    contributes 2 h |n| with |n| <= S^2 / 4 and S <= 2 (2 R + Z); there are 10 roundings
//    of S^2 / 4 Z, and 12 h^2 S. The sum is at most h S (2 R + Z) (3 + 10 Z).
//
// dz is clamped to an interval that exceeds the z of the facet by R on both sides. This
// does not change the sign of the depth of a point inside the outline: there the plane
// lies between the z of the corners.
[[gnu::always_inline]] inline WideFloats size_of(const WideFloats& a)
{
    return larger(a, -a);
}

[[gnu::always_inline]] inline WideFloats edge_error(float h, const WideFloats& length,
                                                    const WideFloats& reach)
{
    return WideFloats{10 * h} * (length + reach + 3 * length * reach);
}

[[gnu::always_inline]] inline WideFloats normal_error(float h, const WideFloats& sides)
{
    return WideFloats{h} * sides * (3 + 3 * sides);
}

[[gnu::always_inline]] inline WideFloats depth_error(float h, const WideFloats& sides,
                                                     const WideFloats& reach,
                                                     const WideFloats& depth_reach)
{
    return WideFloats{h} * sides * (2 * reach + depth_reach) * (4 + 12 * depth_reach);
}

[[gnu::always_inline]] inline WideFloats wide(const LaneFloats& values)
{
    return WideFloats{values.data()};
}

// The facets that may cover a point, and those that certainly do.
struct Coverage {
    WideBits possible;
    WideBits certain;
};

[[gnu::always_inline]] inline Coverage coverage_of(const ShadowLanes& shadows,
                                                   const PointBlock& points,
                                                   std::uint32_t lane)
{
    const WideFloats dx = WideFloats{points.x[lane]} - wide(shadows.corner[0][0]);
    const WideFloats dy = WideFloats{points.y[lane]} - wide(shadows.corner[0][1]);
    const WideFloats dz =
        smaller(larger(WideFloats{points.z[lane]} - wide(shadows.corner[0][2]),
                       wide(shadows.low_dz)),
                wide(shadows.high_dz));
    const WideFloats first =
        wide(shadows.side[0][0]) * dx + wide(shadows.side[0][1]) * dy;
    const WideFloats second = wide(shadows.side[1][0]) * dx +
                              wide(shadows.side[1][1]) * dy + wide(shadows.second_offset);
    const WideFloats third =
        wide(shadows.side[2][0]) * dx + wide(shadows.side[2][1]) * dy;
    const WideFloats below = wide(shadows.depth[0]) * dx + wide(shadows.depth[1]) * dy +
                             wide(shadows.depth[2]) * dz;
    const WideFloats least = smaller(smaller(first, second), third);
    const WideFloats inside = smaller(least, below);
    const WideBits is_other{shadows.facet.data(), points.number[lane]};
    if (!shadows.has_edge_on) [[likely]]
        return {(inside >= -1) & is_other, (inside > 1) & is_other};
    // A facet seen on edge has uncertain signs of its edge functions. It may cover the
    // point unless the edge functions certainly have both signs.
    const WideFloats most = larger(larger(first, second), third);
    const WideFloats facing = wide(shadows.facing);
    const WideBits is_facing = facing > 0;
    const WideBits on_edge =
        (WideFloats{} >= facing) & ((WideFloats{1} >= most) | (least >= -1));
    return {(((inside >= -1) & is_facing) | on_edge) & is_other,
            (inside > 1) & is_facing & is_other};
}

// The points of a block inside the common box of the facets, as a set of lanes.
[[gnu::always_inline]] inline unsigned lanes_within(const ShadowLanes& shadows,
                                                    const PointBlock& points)
{
    const WideFloats x{points.x.data()};
    const WideFloats y{points.y.data()};
    const WideFloats z{points.z.data()};
    return ((x >= shadows.low[0]) & (WideFloats{shadows.high[0]} >= x) &
            (y >= shadows.low[1]) & (WideFloats{shadows.high[1]} >= y) &
            (WideFloats{shadows.highest} >= z))
        .bits();
}

// For each set of lanes the lanes in it, in ascending order. The remaining entries have
// no meaning.
constexpr auto lanes_of_sets = [] {
    std::array<std::array<std::uint32_t, lanes>, 1U << lanes> sets{};
    for (unsigned set = 0; set < sets.size(); ++set)
        for (unsigned lane = 0, count = 0; lane < lanes; ++lane)
            if ((set >> lane & 1U) != 0)
                sets[set][count++] = lane;
    return sets;
}();

// Places of points that wait for a test. The lanes of a block are added without a branch
// for each lane, because such branches could not be predicted.
class PlaceQueue {
public:
    [[gnu::always_inline]] void add(std::uint32_t block, unsigned set)
    {
        Places places;
        std::memcpy(&places, lanes_of_sets[set].data(), sizeof places);
        places += block * lanes;
        std::memcpy(places_.data() + count_, &places, sizeof places);
        count_ += static_cast<std::size_t>(std::popcount(set));
    }

    bool has_room() const
    {
        return count_ + lanes <= places_.size();
    }  // for one more block
    std::span<const std::uint32_t> places() const { return {places_.data(), count_}; }
    void clear() { count_ = 0; }

private:
    using Places = std::uint32_t __attribute__((vector_size(lanes * sizeof(float))));

    std::array<std::uint32_t, 64> places_;  // enough for most groups of facets
    std::size_t count_ = 0;
};

// Tests each waiting point against all eight facets.
[[gnu::always_inline]] inline void test_places(std::span<const std::uint32_t> places,
                                               const ShadowLanes& shadows,
                                               const PointBlock* blocks,
                                               CoveredPoints& covered)
{
    for (const std::uint32_t place : places) {
        const Coverage found = coverage_of(shadows, blocks[place / lanes], place % lanes);
        const bool is_covered = found.certain.any();
        covered.covered_lanes[place / lanes] |=
            static_cast<std::uint8_t>(unsigned{is_covered} << place % lanes);
        if (is_covered || !found.possible.any())
            continue;
        for (unsigned rest = found.possible.bits(); rest != 0; rest &= rest - 1)
            covered.uncertain.push_back({place, shadows.facet[std::countr_zero(rest)]});
    }
}

[[gnu::always_inline]] inline float least_of(const WideFloats& values)
{
    LaneFloats each;
    values.store(each);
    return *std::ranges::min_element(each);
}

}  // namespace

ENDMILL_WIDEST_REGISTERS
void prepare_shadows(ShadowLanes& shadows, float accuracy)
{
    const float h = accuracy;
    std::array<std::array<WideFloats, 3>, 3> at;
    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis)
            at[k][axis] = WideFloats{shadows.corner[k][axis].data()};
    std::array<WideFloats, 3> low;
    std::array<WideFloats, 3> high;
    for (int axis = 0; axis < 3; ++axis) {
        low[axis] = smaller(at[0][axis], smaller(at[1][axis], at[2][axis]));
        high[axis] = larger(at[0][axis], larger(at[1][axis], at[2][axis]));
    }
    // Covered centroids lie in the box of the corners, up to 2 h and a few roundings; 16
    // h is a safe margin.
    for (int axis = 0; axis < 2; ++axis) {
        shadows.low[axis] = least_of(low[axis]) - 16 * h;
        shadows.high[axis] = -least_of(-high[axis]) + 16 * h;
    }
    shadows.highest = -least_of(-high[2]) + 16 * h;
    const WideFloats reach =
        larger(shadows.high[0] - shadows.low[0], shadows.high[1] - shadows.low[1]);
    WideFloats{low[2] - at[0][2] - reach}.store(shadows.low_dz);
    WideFloats{high[2] - at[0][2] + reach}.store(shadows.high_dz);
    const WideFloats depth_reach = high[2] - low[2] + reach;

    std::array<std::array<WideFloats, 3>, 3> e;
    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis)
            e[k][axis] = at[(k + 1) % 3][axis] - at[k][axis];
    const WideFloats nx = e[0][1] * e[1][2] - e[0][2] * e[1][1];
    const WideFloats ny = e[0][2] * e[1][0] - e[0][0] * e[1][2];
    const WideFloats nz = e[0][0] * e[1][1] - e[0][1] * e[1][0];
    const WideFloats sides = size_of(e[0][0]) + size_of(e[0][1]) + size_of(e[0][2]) +
                             size_of(e[1][0]) + size_of(e[1][1]) + size_of(e[1][2]);
    const WideFloats sign = sign_of(nz);
    const WideFloats facing = size_of(nz) - normal_error(h, sides);
    facing.store(shadows.facing);
    shadows.has_edge_on = (WideFloats{} >= facing).any();
    const WideFloats below = -sign / depth_error(h, sides, reach, depth_reach);
    WideFloats{nx * below}.store(shadows.depth[0]);
    WideFloats{ny * below}.store(shadows.depth[1]);
    WideFloats{nz * below}.store(shadows.depth[2]);
    for (int k = 0; k < 3; ++k) {
        const WideFloats length = size_of(e[k][0]) + size_of(e[k][1]);
        const WideFloats inside = sign / edge_error(h, length, reach);
        WideFloats{-e[k][1] * inside}.store(shadows.side[k][0]);
        WideFloats{e[k][0] * inside}.store(shadows.side[k][1]);
        if (k == 1)
            WideFloats{(e[1][1] * e[0][0] - e[1][0] * e[0][1]) * inside}.store(
                shadows.second_offset);
    }
}

ENDMILL_WIDEST_REGISTERS
void mark_covered(const ShadowLanes& shadows, const PointCells& cells,
                  CoveredPoints& covered)
{
    const PointBlock* blocks = cells.blocks().data();
    const int first = cells.column_at(shadows.low[0]);
    const int last = cells.column_at(shadows.high[0]);
    const int high = cells.row_at(shadows.high[1]);
    PlaceQueue queue;
    for (int row = cells.row_at(shadows.low[1]); row <= high; ++row) {
        const auto [begin, end] = cells.range(row, first, last);
        // The first and the last block may contain points of other cells, which are
        // tested as well.
        for (std::uint32_t block = begin / lanes; block * lanes < end; ++block) {
            queue.add(block, lanes_within(shadows, blocks[block]) &
                                 ~covered.covered_lanes[block]);
            if (!queue.has_room()) [[unlikely]] {
                test_places(queue.places(), shadows, blocks, covered);
                queue.clear();
            }
        }
    }
    test_places(queue.places(), shadows, blocks, covered);
}

}  // namespace endmill
