// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/wide_sectors.h"

#include <algorithm>
#include <numbers>
#include <tuple>

#include "endmill/core/tolerance.h"

// A wide sector leaves out one gap, of at most 180 degrees, between its end and its begin.
// There are n^2 sectors, but most of them are not better than a narrower one:
//
// 1. Let the gap contain the largest polar angle. The sector can shrink from its end,
//    until it is only just wide. This leaves one sector for each begin.
// 2. Otherwise the largest polar angle is inside, and only the largest one in the gap
//    counts. The gap can grow at both ends, until it meets a direction with a larger polar
//    angle or the sector is only just wide. The gaps that cannot grow at their first end
//    are the neighbours on a stack of falling polar angles. Each pair of neighbours has one
//    largest gap. There are at most two pairs for each listed direction.
//
// Equal scores are decided by the order of begins. Sectors that begin a little earlier
// than the least one, at a distance below the tolerance of equal scores, come before it.
// Their begins are an interval, the scores rise with the distance, and a binary search
// finds the first of them.

namespace endmill {
namespace {

// The first number from `begin` to `end` without a property that only the numbers before
// it have; `end` if all have it.
template <typename Property>
std::size_t first_without(std::size_t begin, std::size_t end, const Property& has)
{
    while (begin < end) {
        const std::size_t middle = begin + (end - begin) / 2;
        if (has(middle))
            begin = middle + 1;
        else
            end = middle;
    }
    return begin;
}

constexpr double least_width = std::numbers::pi - equal_angles;  // rad

class WideSectorList {
public:
    explicit WideSectorList(const DirectionFan& fan) : fan_{fan} {}

    std::vector<WideSectors> take()
    {
        add_narrowest_of_each_begin();
        add_largest_gaps();
        return std::move(sectors_);
    }

private:
    bool is_wide(std::size_t begin, std::size_t end) const
    {
        return fan_.azimuth(end) - fan_.azimuth(begin) >= least_width;
    }

    void add_narrowest_of_each_begin()
    {
        const std::size_t count = fan_.size();
        RunMaximum inside{fan_};
        RunMaximum outside{fan_};
        std::size_t end = 0;
        for (std::size_t begin = 0; begin < count; ++begin) {
            end = std::max(end, begin);
            while (end < begin + count && !is_wide(begin, end))
                ++end;
            if (end < begin + count)
                sectors_.push_back({begin, begin, end, inside.of(begin, end + 1),
                                    outside.of(end + 1, begin + count)});
        }
    }

    void add_largest_gaps()
    {
        const std::size_t count = fan_.size();
        RunMaximum all{fan_};
        largest_ = all.of(0, count);
        std::vector<std::size_t> falling;  // directions higher than all later ones
        const auto pop = [&](std::size_t upto) {
            const std::size_t highest = falling.back();
            falling.pop_back();
            if (!falling.empty())
                add_gap(falling.back(), highest, upto);
        };
        for (std::size_t i = 0; i < 2 * count; ++i) {
            while (!falling.empty() && fan_.polar(falling.back()) <= fan_.polar(i))
                pop(i);
            falling.push_back(i);
            if (i + 1 < 2 * count)
                add_gap(i, i, i + 1);
        }
        while (!falling.empty())
            pop(2 * count - 1);
    }

    // Adds the gap after the direction `end` whose largest polar angle is that of
    // `highest`. It reaches up to `upto`, or less far if the sector would not be wide. The
    // gap is empty if `end` is `highest`.
    void add_gap(std::size_t end, std::size_t highest, std::size_t upto)
    {
        const std::size_t count = fan_.size();
        const std::size_t earliest = std::max(highest + 1, count) - count;
        const std::size_t after = std::max(upto + 1, count) - count;
        if (earliest >= after || !is_wide(earliest, end))
            return;
        const std::size_t beyond = first_without(
            earliest, after, [&](std::size_t begin) { return is_wide(begin, end); });
        sectors_.push_back({earliest, beyond - 1, end, largest_,
                            end == highest ? 0 : fan_.polar(highest)});
    }

    const DirectionFan& fan_;
    double largest_ = 0;  // of the listed polar angles, rad
    std::vector<WideSectors> sectors_;
};

struct ScoredSector {
    SectorCandidate sector;
    SetupScore score;
};

ScoredSector scored(const DirectionFan& fan, const WideSectors& sectors,
                    std::size_t begin)
{
    const double width = fan.azimuth(sectors.end) - fan.azimuth(begin);
    const SectorCandidate sector =
        fan.candidate(fan.azimuth(begin), width, sectors.inside, sectors.outside);
    return {sector, {sector.area(), sector.polar + sector.opposite_polar + sector.width}};
}

}  // namespace

std::vector<WideSectors> least_wide_sectors(const DirectionFan& fan)
{
    return WideSectorList{fan}.take();
}

void offer_wide_sectors(const DirectionFan& fan, const std::vector<WideSectors>& sectors,
                        const std::function<bool(const SectorCandidate&)>& is_allowed,
                        BestCandidate<SectorCandidate>& best)
{
    BestCandidate<SectorCandidate> least = best;
    for (const WideSectors& run : sectors) {
        const auto [sector, score] = scored(fan, run, run.begin);
        if (least.wants(score.area) && is_allowed(sector))
            least.offer(sector, score);
    }
    const SetupScore limit = least.limit();
    const auto is_best = [&](const ScoredSector& tried) {
        return tried.score.area <= limit.area && tried.score.sum <= limit.sum &&
               is_allowed(tried.sector);
    };
    std::vector<WideSectors> found;
    for (const WideSectors& run : sectors) {
        if (!is_best(scored(fan, run, run.begin)))
            continue;
        found.push_back(run);
        found.push_back(run);
        found.back().begin = first_without(
            run.earliest, run.begin,
            [&](std::size_t begin) { return !is_best(scored(fan, run, begin)); });
    }
    std::ranges::sort(found, {}, [](const WideSectors& run) {
        return std::tuple{run.begin, run.end};
    });
    for (const WideSectors& run : found) {
        const auto [sector, score] = scored(fan, run, run.begin);
        best.offer(sector, score);
    }
}

}  // namespace endmill
