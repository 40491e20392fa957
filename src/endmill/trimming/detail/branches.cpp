// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/branches.h"

#include <algorithm>

#include "endmill/core/orientation.h"

namespace endmill {
namespace {

struct Segment {
    const SectionPoint& from;
    const SectionPoint& to;

    // A point on the line counts as right of it.
    bool has_left(const SectionPoint& point) const
    {
        return orientation(from, to, point) > 0;
    }
};

Segment segment_behind(const SectionChain& chain, std::int32_t vertex)
{
    return {chain.at(vertex), chain.at(chain.next(vertex))};
}

bool are_apart(const Segment& a, const Segment& b, int axis)
{
    return std::max(a.from[axis], a.to[axis]) < std::min(b.from[axis], b.to[axis]) ||
           std::max(b.from[axis], b.to[axis]) < std::min(a.from[axis], a.to[axis]);
}

double cross(const SectionPoint& a, const SectionPoint& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

// The crossing of two segments that cross. It is clamped to the boxes of both segments,
// so that rounding does not make s step back.
SectionPoint crossing_point(const Segment& a, const Segment& b)
{
    const SectionPoint along_a = a.to - a.from;
    const SectionPoint along_b = b.to - b.from;
    const double turned = cross(along_a, along_b);
    const double share = turned != 0 ? cross(b.from - a.from, along_b) / turned : 0;
    const SectionPoint point = a.from + share * along_a;
    const SectionPoint low = a.from.cwiseMin(a.to).cwiseMax(b.from.cwiseMin(b.to));
    const SectionPoint high = a.from.cwiseMax(a.to).cwiseMin(b.from.cwiseMax(b.to));
    return point.cwiseMax(low).cwiseMin(high);
}

// The other coordinate at which `segment` meets the line where coordinate `axis` is
// `value`. The test is half open: an end on the line counts as below it, so that two
// neighbouring segments never both meet the line in their common vertex, and no division
// by zero occurs.
std::optional<double> meeting(const Segment& segment, int axis, double value)
{
    const double from = segment.from[axis];
    const double to = segment.to[axis];
    if ((from <= value) == (to <= value))
        return std::nullopt;
    const double share = (value - from) / (to - from);
    return segment.from[1 - axis] +
           share * (segment.to[1 - axis] - segment.from[1 - axis]);
}

}  // namespace

CrossingFinder bound(CrossingSearch* search, const TrimmingOptions& options)
{
    return [search, &options](const SectionChain& chain, const Branches& branches) {
        return search(chain, branches, options);
    };
}

CrossingType crossing_type(FoldDetection detection)
{
    return detection == FoldDetection::Guarded ? CrossingType::Valley : CrossingType::Any;
}

std::optional<ChainCrossing> crossing_of(const SectionChain& chain, std::int32_t a,
                                         std::int32_t b, CrossingType type)
{
    const Segment on_a = segment_behind(chain, a);
    const Segment on_b = segment_behind(chain, b);
    if (are_apart(on_a, on_b, 0) || are_apart(on_a, on_b, 1))
        return std::nullopt;
    const bool ends_left = on_a.has_left(on_b.to);
    if (ends_left == on_a.has_left(on_b.from) ||
        (type == CrossingType::Valley && !ends_left))
        return std::nullopt;
    if (on_b.has_left(on_a.from) == on_b.has_left(on_a.to))
        return std::nullopt;
    return ChainCrossing{a, b, crossing_point(on_a, on_b)};
}

std::optional<std::int32_t> first_crossed_of_a(const SectionChain& chain,
                                               const Branches& branches,
                                               std::int32_t line)
{
    const Segment on_line = segment_behind(chain, line);
    const bool cusp_is_left = on_line.has_left(chain.at(branches.cusp_a));
    for (std::int32_t vertex = branches.cusp_a; vertex != branches.first_a;) {
        vertex = chain.previous(vertex);
        if (on_line.has_left(chain.at(vertex)) != cusp_is_left)
            return vertex;
    }
    return std::nullopt;
}

std::optional<std::int32_t> first_crossed_of_b(const SectionChain& chain,
                                               const Branches& branches,
                                               std::int32_t line)
{
    const Segment on_line = segment_behind(chain, line);
    const bool cusp_is_left = on_line.has_left(chain.at(branches.cusp_b));
    for (std::int32_t vertex = branches.cusp_b; vertex != branches.last_b;) {
        const std::int32_t next = chain.next(vertex);
        if (on_line.has_left(chain.at(next)) != cusp_is_left)
            return vertex;
        vertex = next;
    }
    return std::nullopt;
}

std::optional<BranchMeeting> first_meeting_of_a(const SectionChain& chain,
                                                const Branches& branches, int axis,
                                                double value)
{
    for (std::int32_t vertex = branches.cusp_a; vertex != branches.first_a;) {
        vertex = chain.previous(vertex);
        if (const auto other = meeting(segment_behind(chain, vertex), axis, value))
            return BranchMeeting{vertex, *other};
    }
    return std::nullopt;
}

std::optional<BranchMeeting> first_meeting_of_b(const SectionChain& chain,
                                                const Branches& branches, int axis,
                                                double value)
{
    for (std::int32_t vertex = branches.cusp_b; vertex != branches.last_b;
         vertex = chain.next(vertex)) {
        if (const auto other = meeting(segment_behind(chain, vertex), axis, value))
            return BranchMeeting{vertex, *other};
    }
    return std::nullopt;
}

}  // namespace endmill
