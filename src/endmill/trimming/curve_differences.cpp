// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/trimming/trimming_quality.h"

// How two results are compared:
// 1. The segments of each result are sorted into bins of equal width in s.
// 2. For each vertex and midpoint of a segment of one result the nearest segment of the
//    other is looked up in the bins. Points that both results have are left out. A search
//    stops once the point cannot be farther than the farthest point so far.
// 3. Lost stretches of s are differences of unions of intervals.

namespace endmill {

namespace {

using Intervals = std::vector<std::pair<double, double>>;

// The union of `intervals`, as disjoint intervals in their order.
Intervals merged(Intervals intervals)
{
    std::ranges::sort(intervals);
    Intervals result;
    for (const auto& [low, high] : intervals) {
        if (result.empty() || low > result.back().second)
            result.emplace_back(low, high);
        else
            result.back().second = std::max(result.back().second, high);
    }
    return result;
}

// The intersection of two unions of disjoint intervals in their order.
Intervals common_of(const Intervals& one, const Intervals& other)
{
    Intervals result;
    for (std::size_t i = 0, k = 0; i < one.size() && k < other.size();) {
        const double low = std::max(one[i].first, other[k].first);
        const double high = std::min(one[i].second, other[k].second);
        if (low < high)
            result.emplace_back(low, high);
        one[i].second < other[k].second ? ++i : ++k;
    }
    return result;
}

double length_of(const Intervals& disjoint)
{
    double length = 0;
    for (const auto& [low, high] : disjoint)
        length += high - low;
    return length;
}

Intervals covered_by(const Trimmed& trimmed)
{
    Intervals covering;
    for (const TrimmedCurve& curve : trimmed.curves)
        for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
            covering.push_back(
                std::minmax({curve.points[i].at.x(), curve.points[i + 1].at.x()}));
    return merged(std::move(covering));
}

// The intervals of s between the ends of the open curves.
Intervals between_ends_of(std::span<const SectionCurve> curves)
{
    Intervals result;
    for (const SectionCurve& curve : curves)
        if (!curve.is_closed)
            result.push_back(
                std::minmax({curve.points.front().x(), curve.points.back().x()}));
    return merged(std::move(result));
}

// Length in s that `exact` covers and `trimmed` does not, between the ends of the curves.
double lost_length(std::span<const SectionCurve> curves, const Trimmed& exact,
                   const Trimmed& trimmed)
{
    const Intervals wanted = common_of(covered_by(exact), between_ends_of(curves));
    const Intervals kept = common_of(wanted, covered_by(trimmed));
    return std::max(length_of(wanted) - length_of(kept), 0.0);
}

// The segments of trimmed curves, in bins by s, for the distance of a point from them.
class NearestSegment {
public:
    explicit NearestSegment(const Trimmed& trimmed)
    {
        for (const TrimmedCurve& curve : trimmed.curves)
            for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
                add(curve.points[i].at, curve.points[i + 1].at);
        // bounds the memory: a long segment is in all bins
        constexpr std::size_t most_bins = 4096;
        bins_.resize(std::clamp<std::size_t>(segments_.size(), 1, most_bins));
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const auto [low, high] =
                std::minmax({segments_[i].from.x(), segments_[i].to.x()});
            for (std::ptrdiff_t bin = bin_of(low); bin <= bin_of(high); ++bin)
                bins_[static_cast<std::size_t>(bin)].push_back(i);
        }
    }

    // The distance of `point`, or any distance up to `enough` if it is at most `enough`.
    // Bins are visited from that of the point outwards, up to those that are farther away
    // in s than the distance found.
    double distance(const SectionPoint& point, double enough) const
    {
        const auto count = std::ssize(bins_);
        const std::ptrdiff_t start = bin_of(point.x());
        double best = std::numeric_limits<double>::infinity();
        for (std::ptrdiff_t ring = 0; ring < count; ++ring) {
            if (best <= enough || least_ds(point, start, ring) >= best)
                break;
            for (const std::ptrdiff_t bin : {start - ring, start + ring})
                if (0 <= bin && bin < count)
                    for (const std::size_t i : bins_[static_cast<std::size_t>(bin)])
                        best = std::min(best, segments_[i].distance(point));
        }
        return best;
    }

private:
    struct Segment {
        SectionPoint from;
        SectionPoint to;

        double distance(const SectionPoint& point) const
        {
            const SectionPoint along = to - from;
            const double squared = along.squaredNorm();
            const double share =
                squared > 0 ? std::clamp((point - from).dot(along) / squared, 0.0, 1.0)
                            : 0;
            return (point - from - share * along).norm();
        }
    };

    void add(const SectionPoint& from, const SectionPoint& to)
    {
        segments_.push_back({from, to});
        low_ = std::min({low_, from.x(), to.x()});
        high_ = std::max({high_, from.x(), to.x()});
    }

    double width() const { return (high_ - low_) / static_cast<double>(bins_.size()); }

    std::ptrdiff_t bin_of(double s) const
    {
        if (!(high_ > low_))
            return 0;
        const double place = (s - low_) / width();
        return static_cast<std::ptrdiff_t>(
            std::clamp(place, 0.0, static_cast<double>(bins_.size() - 1)));
    }

    // Lower bound of the distance in s of `point` from the bins of a ring about `start`.
    // Half a bin allows for rounding of the bins' borders.
    double least_ds(const SectionPoint& point, std::ptrdiff_t start,
                    std::ptrdiff_t ring) const
    {
        if (ring == 0)
            return 0;
        const double left =
            point.x() - (low_ + static_cast<double>(start - ring + 1) * width());
        const double right =
            low_ + static_cast<double>(start + ring) * width() - point.x();
        return std::min(left, right) - width() / 2;
    }

    std::vector<Segment> segments_;
    std::vector<std::vector<std::size_t>> bins_;
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = -std::numeric_limits<double>::infinity();
};

using Place = std::pair<double, double>;

Place place_of(const TrimmedPoint& point)
{
    return {point.at.x(), point.at.y()};
}

// The places of all points, sorted.
std::vector<Place> places_of(const Trimmed& trimmed)
{
    std::vector<Place> places;
    for (const TrimmedCurve& curve : trimmed.curves)
        for (const TrimmedPoint& point : curve.points)
            places.push_back(place_of(point));
    std::ranges::sort(places);
    return places;
}

// A point of one result that is far from the other one.
struct FarPoint {
    SectionPoint place{0, 0};
    double distance = 0;
};

// The vertex or midpoint of `from` that is farthest from the curves of `to`.
FarPoint farthest_from(const Trimmed& from, const Trimmed& to)
{
    const NearestSegment nearest{to};
    const std::vector<Place> common = places_of(to);
    const auto is_common = [&](const TrimmedPoint& point) {
        return std::ranges::binary_search(common, place_of(point));
    };
    FarPoint farthest;
    const auto measure = [&](const SectionPoint& point) {
        const double distance = nearest.distance(point, farthest.distance);
        if (distance > farthest.distance)
            farthest = {point, distance};
    };
    for (const TrimmedCurve& curve : from.curves) {
        bool was_common = true;
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const bool is_now_common = is_common(curve.points[i]);
            if (!is_now_common)
                measure(curve.points[i].at);
            if (i > 0 && !(was_common && is_now_common))
                measure((curve.points[i - 1].at + curve.points[i].at) / 2);
            was_common = is_now_common;
        }
    }
    return farthest;
}

// The first point of a result that the other result lacks, with the extent as distance.
FarPoint whole_of(const Trimmed& trimmed)
{
    Eigen::AlignedBox2d box;
    for (const TrimmedCurve& curve : trimmed.curves)
        for (const TrimmedPoint& point : curve.points)
            box.extend(point.at);
    if (box.isEmpty())
        return {};
    return {trimmed.curves.front().points.front().at, box.diagonal().norm()};
}

FarPoint farthest_between(const Trimmed& one, const Trimmed& other)
{
    const bool has_both = !one.curves.empty() && !other.curves.empty();
    const FarPoint from_one = has_both ? farthest_from(one, other) : whole_of(one);
    const FarPoint from_other = has_both ? farthest_from(other, one) : whole_of(other);
    return from_one.distance >= from_other.distance ? from_one : from_other;
}

}  // namespace

std::vector<CurveDifference> differences_from_exact(std::span<const PlaneSection> planes,
                                                    std::span<const Trimmed> exact,
                                                    std::span<const Trimmed> trimmed)
{
    require(planes.size() == trimmed.size() && planes.size() == exact.size(),
            "differences_from_exact: need two results for each plane");
    std::vector<CurveDifference> differences(planes.size());
    parallel_for(planes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::vector<SectionCurve>& curves = planes[k].curves;
            const TrimmingQuality quality = trimming_quality(curves, trimmed[k]);
            const FarPoint farthest = farthest_between(trimmed[k], exact[k]);
            differences[k] = {farthest.distance, farthest.place, quality.gouge_mm,
                              quality.step_back_mm,
                              lost_length(curves, exact[k], trimmed[k])};
        }
    });
    return differences;
}

bool is_right(const CurveDifference& difference, double tolerance)
{
    return difference.step_back_mm <= step_back_on_parts_mm &&
           difference.below_mm <= tolerance && difference.lost_mm <= tolerance;
}

}  // namespace endmill
