// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/slicer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "endmill/core/detail/finished_share.h"
#include "endmill/core/parallel.h"
#include "endmill/offset/detail/mesh_segments.h"
#include "endmill/offset/detail/segment_links.h"

namespace endmill {
namespace {

using Index = std::int32_t;

// Planes whose segments exist at the same time. All triangles are visited for each batch, which
// takes little beside 4096 sections. Many planes more would take much memory, and the first
// share of the work would be known late.
constexpr std::size_t planes_a_batch = 4096;
static_assert(planes_a_batch <= most_planes_a_batch);

bool is_before(const SectionPoint& one, const SectionPoint& other)
{
    return std::pair{one.x(), one.y()} < std::pair{other.x(), other.y()};
}

// A growing curve whose consecutive points are different.
struct TracedCurve {
    std::vector<SectionPoint> points;
    std::vector<CrossedEdge> edges;

    explicit TracedCurve(std::size_t most)
    {
        points.reserve(most);
        edges.reserve(most);
    }

    void add(const SectionPoint& point, const CrossedEdge& edge)
    {
        if (!points.empty() && points.back() == point)
            return;
        points.push_back(point);
        edges.push_back(edge);
    }

    // Reverses an open curve that runs towards smaller s.
    void direct()
    {
        if (points.front().x() <= points.back().x())
            return;
        std::ranges::reverse(points);
        std::ranges::reverse(edges);
    }

    // Lets a closed curve begin at its smallest point, which is repeated at its end. If
    // all points are equal, one point remains.
    void close()
    {
        while (points.size() > 1 && points.back() == points.front()) {
            points.pop_back();
            edges.pop_back();
        }
        if (points.size() < 2)
            return;
        const auto least = std::ranges::min_element(points, is_before) - points.begin();
        std::rotate(points.begin(), points.begin() + least, points.end());
        std::rotate(edges.begin(), edges.begin() + least, edges.end());
        points.push_back(SectionPoint{points.front()});
        edges.push_back(CrossedEdge{edges.front()});
    }
};

// Traces the curves of one plane after the other; keeps its buffers between planes.
// Curves that begin at a segment without predecessor are traced first, since they are
// open. What remains is closed.
class SectionTracer {
public:
    SectionTracer(const TriangleMesh& mesh, const DrivePlanes& planes,
                  std::size_t part_triangles, const MeshSegments& segments)
        : mesh_{mesh},
          planes_{planes},
          part_triangles_{static_cast<Index>(
              std::min<std::size_t>(part_triangles, std::numeric_limits<Index>::max()))},
          segments_{segments}
    {
    }

    // The section by plane `number` of all planes, which is plane `plane` of the batch.
    PlaneSection section(std::size_t number, std::size_t plane)
    {
        first_ = static_cast<std::ptrdiff_t>(segments_.first[plane]);
        const std::size_t count = segments_.first[plane + 1] - segments_.first[plane];
        position_ = planes_.positions[number];
        links_.link(std::span{segments_.from}.subspan(first_, count),
                    std::span{segments_.to}.subspan(first_, count));
        is_traced_.assign(count, 0);
        PlaneSection section;
        section.crossed_triangles = count;
        for (const bool closed : {false, true})
            for (Index k = 0; k < static_cast<Index>(count); ++k)
                if (is_traced_[k] == 0 && (closed || !links_.is_entered(k)))
                    trace(k, closed, section);
        sort_curves(section);
        return section;
    }

private:
    // Traces the curve that begins with segment `start` and adds it to `section`.
    void trace(Index start, bool is_closed, PlaneSection& section)
    {
        order_.clear();
        for (Index k = start; k != SegmentLinks::none && is_traced_[k] == 0;
             k = links_.next(k)) {
            is_traced_[k] = 1;
            order_.push_back(k);
        }
        Interval own{std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()};
        const auto extend = [&](double s) {
            own = {std::min(own.low, s), std::max(own.high, s)};
        };
        TracedCurve curve{order_.size() + 1};
        const auto from = std::span{segments_.from}.subspan(first_);
        const auto triangle = std::span{segments_.triangle}.subspan(first_);
        bool was_part = false;
        for (const Index k : order_) {
            const SectionPoint point = point_of(from[k]);
            const bool is_part = triangle[k] < part_triangles_;
            if (is_part || was_part)
                extend(point.x());
            curve.add(point, from[k]);
            was_part = is_part;
        }
        if (is_closed) {
            curve.close();
        } else {
            const CrossedEdge& edge = segments_.to[first_ + order_.back()];
            const SectionPoint end = point_of(edge);
            if (was_part)
                extend(end.x());
            curve.add(end, edge);
            curve.direct();
        }
        if (own.low <= own.high)
            section.part_range = hull(section.part_range, own);
        if (curve.points.size() < 2)
            return;
        section.curves.push_back({std::move(curve.points), is_closed});
        section.edges.push_back(std::move(curve.edges));
    }

    SectionPoint point_of(const CrossedEdge& edge) const
    {
        return point_on(edge, mesh_.points(), planes_.frame, position_);
    }

    static Interval hull(const std::optional<Interval>& one, const Interval& other)
    {
        return one ? Interval{std::min(one->low, other.low),
                              std::max(one->high, other.high)}
                   : other;
    }

    static void sort_curves(PlaneSection& section)
    {
        if (section.curves.size() < 2)
            return;
        std::vector<std::pair<SectionPoint, std::size_t>> order;
        for (std::size_t k = 0; k < section.curves.size(); ++k)
            order.emplace_back(
                *std::ranges::min_element(section.curves[k].points, is_before), k);
        std::ranges::stable_sort(order, is_before,
                                 [](const auto& at) { return at.first; });
        std::vector<SectionCurve> curves;
        std::vector<std::vector<CrossedEdge>> edges;
        for (const auto& [least, k] : order) {
            curves.push_back(std::move(section.curves[k]));
            edges.push_back(std::move(section.edges[k]));
        }
        section.curves = std::move(curves);
        section.edges = std::move(edges);
    }

    const TriangleMesh& mesh_;
    const DrivePlanes& planes_;
    Index part_triangles_;
    const MeshSegments& segments_;
    std::ptrdiff_t first_ = 0;  // first segment of the plane
    double position_ = 0;
    SegmentLinks links_;
    std::vector<std::uint8_t> is_traced_;
    std::vector<Index> order_;  // the segments of the current curve
};

}  // namespace

std::vector<PlaneSection> slice(const TriangleMesh& mesh, const DrivePlanes& planes,
                                const SliceOptions& options)
{
    std::vector<PlaneSection> sections(planes.positions.size());
    FinishedShare finished{options.progress, sections.size()};
    for (std::size_t begin = 0; begin < sections.size(); begin += planes_a_batch) {
        const auto positions = std::span{planes.positions}.subspan(
            begin, std::min(planes_a_batch, sections.size() - begin));
        const MeshSegments segments = mesh_segments(mesh, planes.frame, positions);
        parallel_for(positions.size(), [&](std::size_t first, std::size_t last) {
            SectionTracer tracer{mesh, planes, options.part_triangles, segments};
            for (std::size_t k = first; k < last; ++k) {
                sections[begin + k] = tracer.section(begin + k, k);
                finished.add(1);
            }
        });
    }
    return sections;
}

}  // namespace endmill
