// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/wall_lanes.h"

#include <bit>

#include "endmill/core/detail/widest_registers.h"

namespace endmill {
namespace {

// Rays that start beside a corner of the border are certain. As many walls come to a point
// of the border as leave it, because the border consists of closed curves. So if a start
// moves across past the point, the number of its exits stays the same, provided that it
// certainly meets all walls beside which it is, or misses them, by their place along and by
// their depth. Neither an error across nor the choice of the wall that has the point
// changes the number. The same holds for all starts in a box.

// A ray or a box near more blocks of walls than these gets no answer.
constexpr std::uint32_t most_blocks = 8;
constexpr std::uint32_t most_blocks_of_a_box = 32;

[[gnu::always_inline]] inline WideFloats wide(const LaneFloats& values)
{
    return WideFloats{values.data()};
}

// The exits of a ray, or of all rays from a box, through the walls of one block.
struct Meeting {
    bool is_certain;  // else the number of exits is not known
    int exits;        // exits less entries
};

// Walls in `met` are met by all rays that start beside them, and those in `uncertain`
// perhaps. A wall has its first end, but not its last one.
[[gnu::always_inline]] inline Meeting meeting(const WallLanes& walls,
                                              const WideFloats& first,
                                              const WideFloats& last, float across,
                                              const WideBits& met,
                                              const WideBits& uncertain)
{
    const WideFloats place{across};
    const unsigned counted = (met & (place >= first) & (last > place)).bits();
    return {!uncertain.any(), std::popcount(counted & walls.leaving) -
                                  std::popcount(counted & ~walls.leaving)};
}

[[gnu::always_inline]] inline Meeting meeting_at(const WallLanes& walls, float doubt,
                                                 float across, float along, float depth)
{
    const WideFloats first = wide(walls.first);
    const WideFloats last = wide(walls.last);
    const WideFloats from_first =
        smaller(larger(WideFloats{across} - first, 0), last - first);
    const WideFloats beyond =
        WideFloats{along} - wide(walls.along) - wide(walls.along_slope) * from_first;
    const WideFloats under =
        wide(walls.depth) + wide(walls.depth_slope) * from_first - WideFloats{depth};
    const WideFloats along_doubt = wide(walls.along_doubt);
    const WideFloats depth_doubt = wide(walls.depth_doubt);
    const WideBits is_beside =
        (WideFloats{across + doubt} >= first) & (last >= WideFloats{across - doubt});
    const WideBits may_meet =
        is_beside & (beyond >= -along_doubt) & (under >= -depth_doubt);
    const WideBits in_doubt =
        may_meet & ((along_doubt >= beyond) | (depth_doubt >= under));
    return meeting(walls, first, last, across, may_meet, in_doubt);
}

[[gnu::always_inline]] inline Meeting meeting_all(const WallLanes& walls, float doubt,
                                                  const ProjectedBox& box)
{
    const WideFloats first = wide(walls.first);
    const WideFloats last = wide(walls.last);
    const WideFloats width = last - first;
    const WideFloats left = smaller(larger(WideFloats{box.low.x()} - first, 0), width);
    const WideFloats right = smaller(larger(WideFloats{box.high.x()} - first, 0), width);
    const WideFloats along_slope = wide(walls.along_slope);
    const WideFloats depth_slope = wide(walls.depth_slope);
    const WideFloats along_left = wide(walls.along) + along_slope * left;
    const WideFloats along_right = wide(walls.along) + along_slope * right;
    const WideFloats depth_left = wide(walls.depth) + depth_slope * left;
    const WideFloats depth_right = wide(walls.depth) + depth_slope * right;
    const WideFloats along_doubt = wide(walls.along_doubt);
    const WideFloats depth_doubt = wide(walls.depth_doubt);
    const WideBits is_beside = (WideFloats{box.high.x() + doubt} >= first) &
                               (last >= WideFloats{box.low.x() - doubt});
    const WideBits may_meet =
        is_beside &
        (WideFloats{box.high.y()} >= smaller(along_left, along_right) - along_doubt) &
        (larger(depth_left, depth_right) + depth_doubt >= WideFloats{box.low.z()});
    const WideBits may_miss =
        (larger(along_left, along_right) + along_doubt >= WideFloats{box.low.y()}) |
        (WideFloats{box.high.z()} >= smaller(depth_left, depth_right) - depth_doubt);
    return meeting(walls, first, last, box.low.x(), may_meet, may_meet & may_miss);
}

}  // namespace

ENDMILL_WIDEST_REGISTERS
ExitLanes ray_exits(const WallStrips& walls, const PlaceLanes& places,
                    const Eigen::Matrix3f& frame, unsigned asked)
{
    std::array<LaneFloats, 3> at;
    for (int axis = 0; axis < 3; ++axis)
        WideFloats{WideFloats{frame(axis, 0)} * wide(places.at[0]) +
                   WideFloats{frame(axis, 1)} * wide(places.at[1]) +
                   WideFloats{frame(axis, 2)} * wide(places.at[2])}
            .store(at[axis]);
    const WideFloats most = static_cast<float>(walls.begin.size() - 2);
    std::array<std::int32_t, float_lanes> strips;
    smaller(larger((wide(at[0]) - walls.low) * walls.strips_per_length, 0), most)
        .store_whole(strips);
    ExitLanes found;
    for (unsigned rest = asked; rest != 0; rest &= rest - 1) {
        const int lane = std::countr_zero(rest);
        const std::uint32_t begin = walls.begin[strips[lane]];
        const std::uint32_t end = walls.begin[strips[lane] + 1];
        bool is_certain = end - begin <= most_blocks;
        int exits = 0;
        for (std::uint32_t block = begin; is_certain && block < end; ++block) {
            const Meeting here = meeting_at(walls.blocks[block], walls.doubt, at[0][lane],
                                            at[1][lane], at[2][lane]);
            is_certain = here.is_certain;
            exits += here.exits;
        }
        found.none |= unsigned{is_certain && exits == 0} << lane;
        found.some |= unsigned{is_certain && exits != 0} << lane;
    }
    return found;
}

ENDMILL_WIDEST_REGISTERS
std::optional<int> box_exits(const WallStrips& walls, const ProjectedBox& box)
{
    const std::uint32_t first = walls.strip_at(box.low.x());
    const std::uint32_t last = walls.strip_at(box.high.x());
    if (walls.begin[last + 1] - walls.begin[first] > most_blocks_of_a_box)
        return std::nullopt;
    int exits = 0;
    for (std::uint32_t strip = first; strip <= last; ++strip)
        for (std::uint32_t block = walls.begin[strip]; block < walls.begin[strip + 1];
             ++block) {
            const Meeting here = meeting_all(walls.blocks[block], walls.doubt, box);
            if (!here.is_certain)
                return std::nullopt;
            // All rays have the number of one that starts at the box's least place across,
            // and the first strip has all walls there.
            exits += strip == first ? here.exits : 0;
        }
    return exits;
}

}  // namespace endmill
