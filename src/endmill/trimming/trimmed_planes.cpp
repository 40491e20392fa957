// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimmed_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "endmill/core/detail/finished_share.h"
#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/trimming/detail/clipped_sections.h"
#include "endmill/trimming/detail/refined_sections.h"
#include "endmill/trimming/detail/section_runs.h"

namespace endmill {
namespace {

constexpr std::string_view range_rule = "outside the range";

// Progress is reported whenever so many points are finished.
constexpr std::size_t points_a_report = 16;

// Whether the result contains each vertex, by curve and point.
using KeptVertices = std::vector<std::vector<bool>>;

KeptVertices kept_vertices(const std::vector<TrimmedCurve>& left,
                           std::span<const SectionCurve> curves)
{
    KeptVertices held;
    for (const SectionCurve& curve : curves)
        held.emplace_back(curve.points.size(), false);
    for (const TrimmedCurve& curve : left)
        for (const TrimmedPoint& point : curve.points)
            if (point.kind == TrimmedKind::Vertex)
                held[point.on.curve][point.on.point] = true;
    for (std::size_t c = 0; c < curves.size(); ++c)
        if (curves[c].is_closed)  // both ends are one point
            held[c].front() = held[c].back() = held[c].front() || held[c].back();
    return held;
}

// Appends a rule for each stretch of vertices that clipping removed.
void append_range_rules(const KeptVertices& before, const KeptVertices& after,
                        std::vector<AppliedRule>& rules)
{
    for (std::size_t c = 0; c < before.size(); ++c) {
        const auto went = [&](std::size_t k) { return before[c][k] && !after[c][k]; };
        for (std::size_t first = 0; first < before[c].size(); ++first) {
            if (!went(first))
                continue;
            std::size_t last = first;
            while (last + 1 < before[c].size() && went(last + 1))
                ++last;
            rules.push_back({static_cast<std::int32_t>(c),
                             static_cast<std::int32_t>(first),
                             static_cast<std::int32_t>(last), range_rule});
            first = last;
        }
    }
}

// Number of folds that a method left and that clipping did not remove.
int remaining_folds(const std::vector<TrimmedCurve>& left,
                    std::span<const SectionCurve> curves)
{
    int count = 0;
    for (const TrimmedCurve& curve : left) {
        const SectionCurve& section = curves[curve.points.front().on.curve];
        count += backward_runs(curve.points, dead_band(section.points));
    }
    return count;
}

void cut_off(const std::optional<Interval>& range, std::span<const SectionCurve> curves,
             Trimmed& trimmed)
{
    const KeptVertices before = kept_vertices(trimmed.curves, curves);
    trimmed.curves =
        range ? clipped(trimmed.curves, *range) : std::vector<TrimmedCurve>{};
    append_range_rules(before, kept_vertices(trimmed.curves, curves), trimmed.rules);
    if (trimmed.unresolved > 0)
        trimmed.unresolved = remaining_folds(trimmed.curves, curves);
}

// Calls refine(plane, section, finer) for all planes, on all threads. Each thread has its
// own `finer`.
template <typename Refine>
void for_each_plane(const SectionSource& source, std::span<const Trimmed> trimmed,
                    const Refine& refine)
{
    const std::vector<double>& positions = source.planes.positions;
    require(trimmed.size() == source.sections.size() &&
                positions.size() == source.sections.size(),
            "refine_planes: need as many planes as sections");
    const SmoothDrop drop{source.surfaces, source.offset.cutter};
    std::size_t points = 0;
    for (const Trimmed& plane : trimmed)
        for (const TrimmedCurve& curve : plane.curves)
            points += curve.points.size();
    FinishedShare finished{source.progress, points, points_a_report};
    const std::function<void(std::size_t)> finish = [&](std::size_t more) {
        finished.add(more);
    };
    parallel_for(trimmed.size(), [&](std::size_t begin, std::size_t end) {
        FinerPieces finer;
        for (std::size_t k = begin; k < end; ++k)
            refine(k,
                   SampledSection{source.sections[k],
                                  {source.planes.frame, positions[k]},
                                  source.offset,
                                  drop,
                                  finish},
                   finer);
    });
}

// Memory of one vertex of an offset: the grid, the mesh and the slicer's links. While
// strips are added, it is twice as much.
constexpr double bytes_a_vertex = 95;
constexpr double bytes_a_vertex_with_strips = 190;
// Memory of one section point: the point, its copy in the result, its point of the path,
// and its text in the files.
constexpr double bytes_a_section_point = 230;
// A section crosses each grid line once, and again in its folds. Strips add arcs that are
// sampled to 1.25e-4 mm.
constexpr double points_a_grid_line = 2;
constexpr double points_of_strips = 950;

}  // namespace

std::vector<Trimmed> trim_planes(std::span<const PlaneSection> planes,
                                 std::span<const std::optional<Interval>> ranges,
                                 const TrimmingMethod& method,
                                 const TrimmingOptions& options,
                                 const std::function<void(double share)>& progress)
{
    require(ranges.empty() || ranges.size() == planes.size(),
            "trim_planes: need a range for each plane, or none");
    std::vector<Trimmed> trimmed(planes.size());
    FinishedShare finished{progress, planes.size()};
    parallel_for(planes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Trimmed& plane = trimmed[k];
            plane = method.trim(planes[k].curves, options);
            if (!ranges.empty())
                cut_off(ranges[k], planes[k].curves, plane);
            finished.add(1);
        }
    });
    return trimmed;
}

void clip_planes(std::span<const PlaneSection> planes,
                 std::span<const std::optional<Interval>> ranges,
                 std::span<Trimmed> trimmed)
{
    require(trimmed.size() == planes.size() &&
                (ranges.empty() || ranges.size() == planes.size()),
            "clip_planes: need a result for each plane, and a range for each or none");
    for (std::size_t k = 0; k < ranges.size(); ++k)
        cut_off(ranges[k], planes[k].curves, trimmed[k]);
}

std::vector<Trimmed> untrimmed_planes(std::span<const PlaneSection> planes)
{
    std::vector<Trimmed> kept(planes.size());
    for (std::size_t k = 0; k < planes.size(); ++k)
        for (std::size_t c = 0; c < planes[k].curves.size(); ++c) {
            TrimmedCurve& curve = kept[k].curves.emplace_back();
            curve.is_closed = planes[k].curves[c].is_closed;
            const std::vector<SectionPoint>& points = planes[k].curves[c].points;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const SegmentNumber on{static_cast<std::int32_t>(c),
                                       static_cast<std::int32_t>(i)};
                curve.points.push_back({points[i], on, on, TrimmedKind::Vertex});
            }
        }
    return kept;
}

std::vector<Trimmed> thinned_planes(std::span<const Trimmed> trimmed, double tolerance,
                                    const std::function<void(double share)>& progress)
{
    std::vector<Trimmed> result{trimmed.begin(), trimmed.end()};
    FinishedShare finished{progress, result.size()};
    parallel_for(result.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            for (TrimmedCurve& curve : result[k].curves) {
                std::vector<SectionPoint> points;
                points.reserve(curve.points.size());
                for (const TrimmedPoint& point : curve.points)
                    points.push_back(point.at);
                std::vector<TrimmedPoint> kept;
                for (const std::size_t number : thinned(points, tolerance))
                    kept.push_back(curve.points[number]);
                curve.points = std::move(kept);
            }
            finished.add(1);
        }
    });
    return result;
}

double section_height(std::span<const PlaneSection> planes)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const PlaneSection& plane : planes)
        for (const SectionCurve& curve : plane.curves)
            for (const SectionPoint& point : curve.points) {
                low = std::min(low, point.y());
                high = std::max(high, point.y());
            }
    return high > low ? high - low : 0;
}

TrimmingOptions default_trimming_options(double height)
{
    constexpr double step_share = 1.0 / 1000;
    TrimmingOptions options;
    // The step must be positive. Curves at one height have no folds, so any step serves
    // them.
    options.scan_step = std::max(step_share * height, std::numeric_limits<double>::min());
    options.scan_threshold = scan_threshold_in_steps * options.scan_step;
    return options;
}

std::vector<Vec3> section_points(const DrivePlanes& planes,
                                 std::span<const Trimmed> trimmed)
{
    require(trimmed.size() == planes.positions.size(),
            "section_points: need a section for each plane");
    std::vector<Vec3> places;
    for (std::size_t k = 0; k < trimmed.size(); ++k)
        for (const TrimmedCurve& curve : trimmed[k].curves)
            for (const TrimmedPoint& point : curve.points)
                places.push_back(
                    planes.frame.point(point.at.x(), planes.positions[k], point.at.y()));
    return places;
}

RefinedPlanes refine_planes(const SectionSource& source, std::span<const Trimmed> trimmed)
{
    std::vector<RefinedCurves> all(trimmed.size());
    for_each_plane(source, trimmed,
                   [&](std::size_t k, const SampledSection& sampled, FinerPieces& finer) {
                       all[k] = refined(sampled, trimmed[k].curves, finer);
                   });
    RefinedPlanes result;
    for (std::size_t k = 0; k < all.size(); ++k) {
        result.planes.push_back({std::move(all[k].curves), trimmed[k].rules,
                                 trimmed[k].rule, trimmed[k].unresolved});
        result.unrefined += all[k].unrefined;
        result.greatest_shift = std::max(result.greatest_shift, all[k].greatest_shift);
    }
    return result;
}

double sampling_error(const SectionSource& source, std::span<const Trimmed> trimmed)
{
    std::vector<double> shifts(trimmed.size());
    for_each_plane(source, trimmed,
                   [&](std::size_t k, const SampledSection& sampled, FinerPieces& finer) {
                       shifts[k] = greatest_shift(sampled, trimmed[k].curves, 0, finer);
                   });
    return shifts.empty() ? 0 : *std::ranges::max_element(shifts);
}

double trimming_bytes(const TrimmingSize& size)
{
    const bool has_strips = size.boundary == BoundaryContact::Contact;
    const double lines = size.grid_lines;
    const auto surfaces = static_cast<double>(size.surfaces);
    const double vertices = surfaces * lines * lines *
                            (has_strips ? bytes_a_vertex_with_strips : bytes_a_vertex);
    const double a_plane =
        points_a_grid_line * lines + (surfaces > 0 && has_strips ? points_of_strips : 0);
    return vertices + static_cast<double>(size.planes) * a_plane * bytes_a_section_point;
}

void require_trimming_memory(const TrimmingSize& size, double memory_gib)
{
    const double bytes = trimming_bytes(size);
    if (bytes / 2 <= memory_gib * bytes_per_gib)
        return;
    throw LimitError{
        std::to_string(size.planes) + " planes over a grid of " +
        std::to_string(size.grid_lines) + " lines would need about " +
        to_text(std::ceil(bytes / bytes_per_gib * 10) / 10) + " GiB; expected at most " +
        to_text(memory_gib) +
        " GiB (--max-memory), with fewer planes (--planes) or a coarser --grid"};
}

}  // namespace endmill
