// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/section_views.h"

namespace endmill {
namespace {

const SectionPoint& place(const SectionPoint& point)
{
    return point;
}

const SectionPoint& place(const TrimmedPoint& point)
{
    return point.at;
}

template <typename Curve>
std::size_t points_of(std::span<const Curve> curves)
{
    std::size_t count = 0;
    for (const Curve& curve : curves)
        count += curve.points.size();
    return count;
}

template <typename Curve>
std::vector<Curve> near(std::span<const Curve> curves, const SectionPoint& centre,
                        double half_width)
{
    std::vector<Curve> stretches;
    for (const Curve& curve : curves) {
        stretches.emplace_back();
        for (const auto& point : curve.points) {
            const SectionPoint distance = (place(point) - centre).cwiseAbs();
            if (distance.maxCoeff() <= half_width)
                stretches.back().points.push_back(point);
            else if (!stretches.back().points.empty())
                stretches.emplace_back();
        }
    }
    std::erase_if(stretches, [](const Curve& curve) { return curve.points.size() < 2; });
    return stretches;
}

}  // namespace

std::size_t point_count(std::span<const SectionCurve> curves)
{
    return points_of(curves);
}

std::size_t point_count(std::span<const TrimmedCurve> curves)
{
    return points_of(curves);
}

std::vector<SectionCurve> curves_near(std::span<const SectionCurve> curves,
                                      const SectionPoint& centre, double half_width)
{
    return near(curves, centre, half_width);
}

std::vector<TrimmedCurve> curves_near(std::span<const TrimmedCurve> curves,
                                      const SectionPoint& centre, double half_width)
{
    return near(curves, centre, half_width);
}

std::optional<SectionPoint> mean_place(std::span<const CutOut> cuts)
{
    SectionPoint sum{0, 0};
    int count = 0;
    for (const CutOut& cut : cuts)
        if (cut.place) {
            sum += *cut.place;
            ++count;
        }
    return count > 0 ? std::optional<SectionPoint>{sum / count} : std::nullopt;
}

Trimmed untrimmed(std::span<const SectionCurve> curves)
{
    Trimmed result;
    for (std::size_t k = 0; k < curves.size(); ++k) {
        TrimmedCurve& curve = result.curves.emplace_back();
        curve.is_closed = curves[k].is_closed;
        for (std::size_t i = 0; i < curves[k].points.size(); ++i) {
            const SegmentNumber on{static_cast<std::int32_t>(k),
                                   static_cast<std::int32_t>(i)};
            curve.points.push_back({curves[k].points[i], on, on, TrimmedKind::Vertex});
        }
    }
    return result;
}

std::vector<std::vector<Vec3>> lines_in_space(std::span<const TrimmedCurve> curves,
                                              const DriveFrame& frame, double t)
{
    std::vector<std::vector<Vec3>> lines;
    for (const TrimmedCurve& curve : curves) {
        std::vector<Vec3>& line = lines.emplace_back();
        for (const TrimmedPoint& point : curve.points)
            line.push_back(frame.point(point.at.x(), t, point.at.y()));
    }
    return lines;
}

}  // namespace endmill
