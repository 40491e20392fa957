// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/force_figures.h"

#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/figures/detail/ball_lines.h"
#include "endmill/process/force_profile.h"

namespace endmill {
namespace {

std::string border_name(BorderKind kind, PreviousPass previous)
{
    switch (kind) {
        case BorderKind::Front:
            return "front";
        case BorderKind::PreviousBall:
            return "previous pass";
        case BorderKind::Wall:
            break;
    }
    return previous == PreviousPass::Edge ? "edge" : "wall of the previous pass";
}

// The force at the element for a material with the given force ratios: the radial component
// is `radial` times the tangential one, the axial component `axial` times. Ratios of 0 leave
// only the tangential component.
CuttingForce force_with(const EdgeElement& element, Milling milling, double radial,
                        double axial)
{
    const CuttingMaterial material{.specific_resistance_n_per_mm2 = 1000,
                                   .edge_thickness_mm = 0,
                                   .r1 = radial,
                                   .r2 = radial,
                                   .r3 = axial,
                                   .r4 = axial,
                                   .alpha = 0.5,
                                   .v1_m_per_min = 1};
    return ForceProfile{{.engagement = element.engagement,
                         .material = material,
                         .tool = {.radius = 1, .flutes = 1},
                         .feed_per_tooth_mm = 1,
                         .milling = milling}}
        .at(element.azimuth);
}

Vec3 vector_of(const CuttingForce& force)
{
    return {force.x_n, force.y_n, force.z_n};
}

}  // namespace

Vec3 BallFrame::turned(const Vec3& place) const
{
    return {place.x(), milling == Milling::Up ? place.y() : -place.y(), place.z()};
}

Vec3 BallFrame::in_room(const Vec3& place) const
{
    return radius_mm * turned(place);
}

std::vector<Vec3> BallFrame::in_room(const std::vector<Vec3>& line) const
{
    std::vector<Vec3> places;
    places.reserve(line.size());
    for (const Vec3& place : line)
        places.push_back(in_room(place));
    return places;
}

std::vector<EngagementBorder> engagement_borders(const BallEngagement& engagement)
{
    constexpr int steps = 60;  // of an arc
    require_sound(engagement);
    require(!is_air(engagement), "engagement_borders: nothing is cut");
    const EngagedRegion region{engagement};
    std::vector<EngagementBorder> borders;
    for (const BorderArc& arc : region.borders(false)) {
        EngagementBorder border{border_name(arc.kind, region.previous), {}};
        for (int k = 0; k <= steps; ++k) {
            const double p = arc.from + (arc.to - arc.from) * k / steps;
            border.points.push_back(region.point(arc.kind, p));
        }
        borders.push_back(std::move(border));
    }
    const double top = std::atan2(region.top_sine, region.top_cosine);
    for (const AzimuthRange& range : engaged_ranges(engagement, top))
        borders.push_back({"stock's top", latitude_line(top, range.from, range.to)});
    return borders;
}

ForceDirections force_directions(const EdgeElement& element, const BallFrame& frame)
{
    const Vec3 tangential = vector_of(force_with(element, frame.milling, 0, 0));
    require(tangential.norm() > 0, "force_directions: the edge does not cut");
    const Vec3 with_radial = vector_of(force_with(element, frame.milling, 1, 0));
    const Vec3 with_axial = vector_of(force_with(element, frame.milling, 0, 1));
    return {frame.turned(tangential.normalized()),
            frame.turned((with_radial - tangential).normalized()),
            frame.turned((with_axial - tangential).normalized())};
}

}  // namespace endmill
