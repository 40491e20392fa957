// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/accessibility/eight_shadows.h"

#include <bit>

#include "endmill/core/widest_registers.h"

namespace endmill {
namespace {

constexpr std::uint32_t lanes = wide_lanes;
static_assert(lanes == PointBlock::size);

// What follows bounds the errors where coordinates, at most 1 in size, are off by h, at least
// half a rounding. Differences are off by 2 h and a rounding. |.| sums the sizes of components;
// R is the largest difference of x or y of a centroid in question from a corner, Z that of z.
//
// An edge function, d x e + c with the offset c of the corner: 2 h |e| + 4 h R from the
// factors, as much from c, and 5 roundings of |e| R in each.
// The normal's components: 2 h S, where S = |e| + |f| of the sides e and f that it is made of,
// and 5 roundings of |e| |f|, at most S^2 / 4.
// The depth n . d: 2 h S (2 R + Z) from n; 2 h |n| from d, where |n| <= S^2 / 4 and S <= 2 (2 R
// + Z); 10 roundings of S^2 / 4 Z in all.
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

// One of eight shadows, the same in all lanes.
struct Shadow {
    std::array<WideFloats, 3> origin;
    std::array<std::array<WideFloats, 2>, 3> side;
    WideFloats second_offset;
    std::array<WideFloats, 3> depth;
    WideFloats low_dz;
    WideFloats high_dz;
    std::int32_t facet;
    bool is_edge_on;

    [[gnu::always_inline]] Shadow(const EightShadows& of, int k)
        : second_offset{of.second_offset[k]},
          low_dz{of.low_dz[k]},
          high_dz{of.high_dz[k]},
          facet{of.facet[k]},
          is_edge_on{!(of.facing[k] > 0)}
    {
        for (int j = 0; j < 3; ++j) {
            origin[j] = of.corner[0][j][k];
            side[j] = {of.side[j][0][k], of.side[j][1][k]};
            depth[j] = of.depth[j][k];
        }
    }
};

// Which points may be in a shadow, and which certainly are.
struct FoundPoints {
    WideBits may_be;
    WideBits surely;
};

[[gnu::always_inline]] inline FoundPoints points_in(const Shadow& shadow,
                                                    const PointBlock& points)
{
    const WideFloats dx = WideFloats{points.x.data()} - shadow.origin[0];
    const WideFloats dy = WideFloats{points.y.data()} - shadow.origin[1];
    const WideFloats dz =
        smaller(larger(WideFloats{points.z.data()} - shadow.origin[2], shadow.low_dz),
                shadow.high_dz);
    const WideFloats first = shadow.side[0][0] * dx + shadow.side[0][1] * dy;
    const WideFloats second =
        shadow.side[1][0] * dx + shadow.side[1][1] * dy + shadow.second_offset;
    const WideFloats third = shadow.side[2][0] * dx + shadow.side[2][1] * dy;
    const WideFloats below =
        shadow.depth[0] * dx + shadow.depth[1] * dy + shadow.depth[2] * dz;
    const WideFloats least = smaller(smaller(first, second), third);
    const WideBits is_other{points.number.data(), shadow.facet};
    if (shadow.is_edge_on) {  // the signs of the edge functions are in doubt
        const WideFloats most = larger(larger(first, second), third);
        return {((WideFloats{1} >= most) | (least >= -1)) & is_other, WideFloats{} > 0};
    }
    const WideFloats inside = smaller(least, below);
    return {(inside >= -1) & is_other, inside > 1};
}

// The points in the places begin … end, which are some.
[[gnu::always_inline]] inline void darken_range(const Shadow& shadow,
                                                const PointBlock* blocks,
                                                std::uint32_t begin, std::uint32_t end,
                                                Darkness& darkness)
{
    const std::uint32_t last = (end - 1) / lanes;
    for (std::uint32_t block = begin / lanes; block <= last; ++block) {
        const FoundPoints found = points_in(shadow, blocks[block]);
        if (!found.may_be.any())
            continue;
        const unsigned surely = found.surely.bits();
        for (unsigned rest = found.may_be.bits(); rest != 0; rest &= rest - 1) {
            const std::uint32_t place =
                block * lanes + static_cast<std::uint32_t>(std::countr_zero(rest));
            if (place < begin || place >= end)  // the bounds of errors do not reach there
                continue;
            if ((surely >> (place % lanes) & 1U) != 0)
                darkness.is_dark[place] = 1;
            else
                darkness.doubts.push_back({place, shadow.facet});
        }
    }
}

}  // namespace

ENDMILL_WIDEST_REGISTERS
void prepare_shadows(EightShadows& shadows, const PointCells& cells, float accuracy)
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
    // Empty beside the cells. Centroids that are covered within the errors lie in the box, widened by theirs.
    for (int axis = 0; axis < 2; ++axis) {
        larger(cells.steps_to(WideFloats{low[axis] - 16 * h}, axis), 0)
            .store_whole(shadows.cells[axis]);
        smaller(cells.steps_to(WideFloats{high[axis] + 16 * h}, axis),
                static_cast<float>((axis == 0 ? cells.columns() : cells.rows()) - 1))
            .store_whole(shadows.cells[axis + 2]);
    }
    const WideFloats reach =
        larger(high[0] - low[0], high[1] - low[1]) + 2 * cells.larger_side() + 64 * h;
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
    WideFloats{size_of(nz) - normal_error(h, sides)}.store(shadows.facing);
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
void darken(const EightShadows& shadows, const PointCells& cells, Darkness& darkness)
{
    const PointBlock* blocks = cells.blocks().data();
    for (int k = 0; k < shadows.count; ++k) {
        const int first = shadows.cells[0][k];
        const int last = shadows.cells[2][k];
        const int high = shadows.cells[3][k];
        int row = shadows.cells[1][k];
        while (row <= high && cells.is_empty(row, first, last))
            ++row;
        if (row > high)
            continue;
        const Shadow shadow{shadows, k};
        for (; row <= high; ++row) {
            const auto [begin, end] = cells.range(row, first, last);
            if (begin != end)
                darken_range(shadow, blocks, begin, end, darkness);
        }
    }
}

}  // namespace endmill
