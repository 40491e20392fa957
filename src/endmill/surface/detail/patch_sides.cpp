// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/patch_sides.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace endmill {
namespace {

constexpr double same_end_share = 1e-6;  // of the part's size
// If more sides meet at one place, their patches lie on each other. This number of
// partners is enough.
constexpr int most_partners = 8;

// A number that is nearly equal for two sides with the same ends: the sum of the ends,
// projected onto a direction in which patches are not usually aligned.
double middle_of_ends(const PatchSide& side)
{
    return (side.ends[0] + side.ends[1]).dot(Vec3{0.742, 0.518, 0.425});
}

// The side of a patch on the border where `across` has its lowest or highest value.
PatchSide side_of(std::span<const Surface> surfaces, std::size_t number, Parameter along,
                  int end, int patch)
{
    const Surface& surface = surfaces[number];
    const auto breaks = surface.breaks(along);
    const Parameter across = along == Parameter::U ? Parameter::V : Parameter::U;
    const Interval range = surface.range(across);
    const double edge = end == 0 ? range.low : range.high;
    const auto place = [&](double parameter) {
        return along == Parameter::U ? SurfacePoint{parameter, edge}
                                     : SurfacePoint{edge, parameter};
    };
    PatchSide side{number,
                   &surface,
                   along,
                   end,
                   patch,
                   place(breaks[patch]),
                   place(breaks[patch + 1]),
                   {}};
    side.ends = {side.tangents(0).point, side.tangents(1).point};
    return side;
}

// Greatest distance of four places of the side from its start.
double reach(const PatchSide& side)
{
    double length = 0;
    for (const double t : {0.25, 0.5, 0.75, 1.0})
        length = std::max(length, (side.tangents(t).point - side.ends.front()).norm());
    return length;
}

// Whether the middle of `one` is close to `other`, so that they are not two different
// curves between the same ends.
bool runs_beside(const PatchSide& one, const PatchSide& other)
{
    // Share of the side's reach; the samples are about 0.03 apart.
    constexpr double beside = 0.05;
    constexpr int samples = 32;
    const Vec3 middle = one.tangents(0.5).point;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= samples; ++k)
        least =
            std::min(least, (other.tangents(k / double(samples)).point - middle).norm());
    return least <= beside * reach(one);
}

// Whether the sides have the same ends, in either order, and run beside each other.
bool meet(const PatchSide& one, const PatchSide& other, double same_end)
{
    const auto are_same = [&](int a, int b) {
        return (one.ends[a] - other.ends[b]).norm() <= same_end;
    };
    return ((are_same(0, 0) && are_same(1, 1)) || (are_same(0, 1) && are_same(1, 0))) &&
           runs_beside(one, other);
}

}  // namespace

SurfacePoint PatchSide::at(double t) const
{
    return {std::lerp(from.u, to.u, t), std::lerp(from.v, to.v, t)};
}

SurfaceTangents PatchSide::tangents(double t) const
{
    const SurfacePoint place = at(t);
    return surface->tangents(place.u, place.v);
}

double same_end_mm(std::span<const Surface> surfaces)
{
    double size = 0;
    for (const Surface& surface : surfaces)
        size = std::max(size, surface.diagonal());
    return same_end_share * size;
}

std::vector<PatchSide> patch_sides(std::span<const Surface> surfaces)
{
    const double same_end = same_end_mm(surfaces);
    std::vector<PatchSide> sides;
    for (std::size_t number = 0; number < surfaces.size(); ++number)
        for (const Parameter along : {Parameter::U, Parameter::V})
            for (const int end : {0, 1})
                for (int patch = 0; patch < surfaces[number].patches(along); ++patch) {
                    const PatchSide side = side_of(surfaces, number, along, end, patch);
                    if (reach(side) > same_end)
                        sides.push_back(side);
                }
    return sides;
}

// Sorts the sides by the number that is equal for meeting sides, and compares each with
// its successors in that order.
std::vector<std::pair<std::size_t, std::size_t>> meeting_sides(
    std::span<const PatchSide> sides, double same_end)
{
    std::vector<std::size_t> order(sides.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(
        order, {}, [&](std::size_t number) { return middle_of_ends(sides[number]); });
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (auto one = order.begin(); one != order.end(); ++one) {
        int partners = 0;
        for (auto other = one + 1;
             other != order.end() && partners < most_partners &&
             middle_of_ends(sides[*other]) <= middle_of_ends(sides[*one]) + 4 * same_end;
             ++other)
            if (meet(sides[*one], sides[*other], same_end)) {
                pairs.emplace_back(std::min(*one, *other), std::max(*one, *other));
                ++partners;
            }
    }
    return pairs;
}

}  // namespace endmill
