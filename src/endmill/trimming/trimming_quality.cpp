// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimming_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/trimming/trimmed_planes.h"

namespace endmill {
namespace {

// How the errors are measured:
// 1. All non-vertical segments of the curves are sorted into bins of equal width in s.
// 2. For each segment of the result the largest height of a curve over its two ends and
//    its midpoint is looked up in the bins. A vertical segment has depth 0, because its
//    |ds| is 0.
// 3. The depth below that height is projected onto the normal of the result's segment.
// 4. The uncovered share compares two unions of intervals of s: those between the ends of
//    the open curves, and those under the segments of the result.

constexpr double nowhere = -std::numeric_limits<double>::infinity();

// The side from which a limit is taken.
enum class Side { Left, Right, Both };

// The non-vertical segments of all curves, in bins by s.
class UpperHeights {
public:
    explicit UpperHeights(std::span<const SectionCurve> curves)
    {
        for (const SectionCurve& curve : curves) {
            for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
                add(curve.points[i], curve.points[i + 1]);
        }
        for (const Segment& segment : segments_) {
            low_ = std::min(low_, segment.left.x());
            high_ = std::max(high_, segment.right.x());
        }
        // bounds the memory: a long segment is in all bins
        constexpr std::size_t most_bins = 4096;
        bins_.resize(std::clamp<std::size_t>(segments_.size(), 1, most_bins));
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            const std::size_t last = bin_of(segments_[i].right.x());
            for (std::size_t bin = bin_of(segments_[i].left.x()); bin <= last; ++bin)
                bins_[bin].push_back(static_cast<std::int32_t>(i));
        }
    }

    // Largest z of all segments at s; minus infinity if there is none.
    double at(double s, Side side) const
    {
        double highest = nowhere;
        if (segments_.empty() || s < low_ || s > high_)
            return highest;
        for (const std::int32_t i : bins_[bin_of(s)]) {
            const Segment& segment = segments_[i];
            const bool is_over =
                side == Side::Left    ? segment.left.x() < s && s <= segment.right.x()
                : side == Side::Right ? segment.left.x() <= s && s < segment.right.x()
                                      : segment.left.x() <= s && s <= segment.right.x();
            if (is_over)
                highest = std::max(highest, segment.z_at(s));
        }
        return highest;
    }

private:
    struct Segment {
        SectionPoint left;
        SectionPoint right;

        double z_at(double s) const
        {
            const double share = (s - left.x()) / (right.x() - left.x());
            return std::lerp(left.y(), right.y(), share);
        }
    };

    void add(const SectionPoint& from, const SectionPoint& to)
    {
        if (from.x() < to.x())
            segments_.push_back({from, to});
        else if (to.x() < from.x())
            segments_.push_back({to, from});
    }

    std::size_t bin_of(double s) const
    {
        const double share = (s - low_) / (high_ - low_);
        const auto bin =
            static_cast<std::size_t>(share * static_cast<double>(bins_.size()));
        return std::min(bin, bins_.size() - 1);
    }

    std::vector<Segment> segments_;
    std::vector<std::vector<std::int32_t>> bins_;
    double low_ = std::numeric_limits<double>::infinity();
    double high_ = nowhere;
};

double depth_of_segment(const UpperHeights& heights, const SectionPoint& from,
                        const SectionPoint& to)
{
    const double ds = std::abs(to.x() - from.x());
    const double length = (to - from).norm();
    if (ds == 0 || length == 0)
        return 0;
    const bool goes_right = from.x() < to.x();
    const SectionPoint middle = (from + to) / 2;
    const double depth = std::max({
        heights.at(from.x(), goes_right ? Side::Right : Side::Left) - from.y(),
        heights.at(to.x(), goes_right ? Side::Left : Side::Right) - to.y(),
        heights.at(middle.x(), Side::Both) - middle.y(),
    });
    return std::max(depth * ds / length, 0.0);
}

// Length of the union of `intervals`.
double covered_length(std::vector<std::pair<double, double>> intervals)
{
    std::sort(intervals.begin(), intervals.end());
    double length = 0;
    double end = nowhere;
    for (const auto& [low, high] : intervals) {
        length += std::max(high - std::max(low, end), 0.0);
        end = std::max(end, high);
    }
    return length;
}

using Intervals = std::vector<std::pair<double, double>>;

Intervals between_ends(std::span<const SectionCurve> curves)
{
    Intervals result;
    for (const SectionCurve& curve : curves) {
        if (!curve.is_closed)
            result.push_back(
                std::minmax({curve.points.front().x(), curve.points.back().x()}));
    }
    return result;
}

// Length of the part of `wanted` that `covering` does not cover.
double length_not_covered(const Intervals& wanted, const Intervals& covering)
{
    Intervals both = wanted;
    both.insert(both.end(), covering.begin(), covering.end());
    return covered_length(both) - covered_length(covering);
}

}  // namespace

TrimmingQuality trimming_quality(std::span<const SectionCurve> curves,
                                 const Trimmed& trimmed)
{
    const UpperHeights heights{curves};
    TrimmingQuality result;
    Intervals covering;
    for (const TrimmedCurve& curve : trimmed.curves) {
        for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
            const SectionPoint& from = curve.points[i].at;
            const SectionPoint& to = curve.points[i + 1].at;
            result.step_back_mm = std::max(result.step_back_mm, from.x() - to.x());
            result.gouge_mm =
                std::max(result.gouge_mm, depth_of_segment(heights, from, to));
            covering.push_back(std::minmax({from.x(), to.x()}));
        }
    }
    const Intervals wanted = between_ends(curves);
    const double length = covered_length(wanted);
    if (length > 0)
        result.uncovered = length_not_covered(wanted, covering) / length;
    return result;
}

std::vector<double> interference_depths(std::span<const PlaneSection> planes)
{
    const std::vector<Trimmed> untrimmed = untrimmed_planes(planes);
    std::vector<double> depths(planes.size());
    parallel_for(planes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            depths[k] = trimming_quality(planes[k].curves, untrimmed[k]).gouge_mm;
    });
    return depths;
}

bool is_right(const TrimmingQuality& quality, const TrimmingTolerance& tolerance)
{
    return quality.step_back_mm <= tolerance.step_back_mm &&
           quality.gouge_mm <= tolerance.gouge_mm &&
           quality.uncovered <= tolerance.uncovered;
}

EnvelopeComparison compare_with_envelope(std::span<const PlaneSection> planes,
                                         std::span<const Trimmed> trimmed,
                                         double tolerance)
{
    require(planes.size() == trimmed.size(),
            "compare_with_envelope: need a result for each plane");
    std::vector<TrimmingQuality> qualities(planes.size());
    parallel_for(planes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            qualities[k] = trimming_quality(planes[k].curves, trimmed[k]);
    });
    EnvelopeComparison result;
    for (const TrimmingQuality& quality : qualities) {
        if (quality.step_back_mm > step_back_on_parts_mm || quality.gouge_mm > tolerance)
            ++result.wrong;
        result.max_gouge_mm = std::max(result.max_gouge_mm, quality.gouge_mm);
    }
    return result;
}

}  // namespace endmill
