// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/section_linking.h"

#include <cstddef>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// Turns curves, one after the other, into passes of one path.
class SectionPath {
public:
    SectionPath(const DriveFrame& frame, const Cutter& cutter, const LinkOptions& options)
        : frame_{frame},
          corner_radius_{cutter.corner_radius()},
          safe_height_{options.safe_height}
    {
    }

    void reserve(std::size_t points) { path_.points.reserve(points); }

    void add_pass(const TrimmedCurve& curve, double across, bool backwards)
    {
        const std::size_t count = curve.points.size();
        point_ = 0;
        for (std::size_t k = 0; k < count; ++k) {
            const SectionPoint& at = curve.points[backwards ? count - 1 - k : k].at;
            const Vec3 tip = tip_of(at, across);
            if (k == 0 && pass_ > 0)
                lift_over(tip);
            add(k == 0 ? Move::Plunge : Move::Cut, tip);
        }
        ++pass_;
    }

    ToolPath take() { return std::move(path_); }

private:
    Vec3 tip_of(const SectionPoint& at, double across) const
    {
        const Vec3 tip = frame_.point(at.x(), across, at.y() - corner_radius_);
        if (tip.z() > safe_height_)
            throw GeometryError{"the safe height " + to_text(safe_height_) +
                                " mm lies below the path, which reaches " +
                                to_text(tip.z()) + " mm"};
        return tip;
    }

    void lift_over(const Vec3& next)
    {
        const Vec3& last = path_.points.back().location.tip;
        const Vec3 up{last.x(), last.y(), safe_height_};
        add(Move::Retract, up);
        add(Move::Rapid, {next.x(), next.y(), safe_height_});
    }

    void add(Move move, const Vec3& tip)
    {
        path_.points.push_back({pass_, point_++, move, {tip, Vec3::UnitZ()}, {}});
    }

    const DriveFrame& frame_;
    double corner_radius_;
    double safe_height_;
    ToolPath path_;
    int pass_ = 0;
    int point_ = 0;
};

}  // namespace

ToolPath link_sections(std::span<const PlaneCurves> planes, const DriveFrame& frame,
                       const Cutter& cutter, const LinkOptions& options)
{
    require(options.axis == Vec3::UnitZ(),
            "link_sections: sections are cut with the axis +z");
    std::size_t points = 0;
    for (const PlaneCurves& plane : planes)
        for (const TrimmedCurve& curve : plane.curves)
            points += curve.points.size() + 2;
    SectionPath path{frame, cutter, options};
    path.reserve(points);
    for (std::size_t k = 0; k < planes.size(); ++k) {
        const auto& [across, curves] = planes[k];
        const bool backwards = options.order == PassOrder::ZigZag && k % 2 == 1;
        for (std::size_t c = 0; c < curves.size(); ++c)
            path.add_pass(curves[backwards ? curves.size() - 1 - c : c], across,
                          backwards);
    }
    return path.take();
}

}  // namespace endmill
