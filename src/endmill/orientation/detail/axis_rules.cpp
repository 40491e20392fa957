// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/axis_rules.h"

#include <algorithm>
#include <numbers>

namespace endmill {
namespace {

// Slack of the rear lead in rad, for rounding.
constexpr double lead_slack = 1e-9;

}  // namespace

AxisRules::AxisRules(const RuledTool& tool, const ToolClearance& clearance,
                     const ContactCones* cones)
    : tool_{tool},
      clearance_{clearance},
      cones_{cones},
      cutter_{tool.cutter}
{
    body_.reserve(tool.body.size());
    for (const ToolCylinder& cylinder : tool.body)
        body_.push_back(CuttingBody::of_cylinder(cylinder));
}

JudgedAxis AxisRules::judge(const RuledContact& at, const Vec3& axis,
                            const Inclination& inclination) const
{
    const auto strip =
        strip_width(tool_.cutter, at.curvature, inclination, tool_.scallop_height);
    if (!strip)
        return {.broken = AxisRule::Curvature};
    if (*strip < at.needed_strip_mm)
        return {.broken = AxisRule::Strip};
    if (!tool_.cutter.is_ball() &&
        inclination.lead.radians() < tool_.rear_lead.radians() - lead_slack)
        return {.broken = AxisRule::RearLead};
    if (!is_reached(axis))
        return {.broken = AxisRule::Machine};
    if (at.hidden && !cones_->is_seen(*at.hidden, axis))
        return {.broken = AxisRule::Visibility};
    const ToolFrame frame = frame_at(
        {control_point(tool_.cutter, at.contact, ControlPoint::Tip, axis), axis});
    if (!is_cutter_clear(at, frame))
        return {.broken = AxisRule::Cutter};
    if (!is_body_clear(frame, tool_.spare_gap))
        return {.broken = AxisRule::Shank};
    return {.lost_width = std::max(0.0, 1 - *strip / at.wanted_strip_mm)};
}

void AxisRules::prepare(RuledContact& at) const
{
    at.front = clearance_.front(at.contact, least_gap());
    if (!cones_)
        return;
    // Rays are dear. On most parts nothing rises so high that it hides an axis.
    const double lean = tool_.greatest_lean.radians();
    const double elevation =
        std::max(0.0, std::numbers::pi / 2 - lean - 2 * cones_->cell_radius());
    if (clearance_.rises_above(elevation, at.contact, *at.front))
        at.hidden = cones_->hidden(at.contact, lean);
}

bool AxisRules::is_cutter_clear(const RuledContact& at, const ToolFrame& frame) const
{
    return at.front ? clearance_.is_clear(cutter_, frame, least_gap(), *at.front)
                    : clearance_.is_clear(cutter_, frame, least_gap());
}

bool AxisRules::is_reached(const Vec3& axis) const
{
    if (!tool_.machine)
        return true;
    const std::vector<RotarySolution> solutions = rotary_solutions(*tool_.machine, axis);
    return std::ranges::any_of(solutions, &RotarySolution::is_within_limits);
}

bool AxisRules::is_body_clear(const ToolFrame& frame, double least) const
{
    return std::ranges::all_of(body_, [&](const CuttingBody& cylinder) {
        return clearance_.is_clear(cylinder, frame, least);
    });
}

bool AxisRules::is_clear(const CutterLocation& location) const
{
    const ToolFrame frame = frame_at(location);
    return clearance_.is_clear(cutter_, frame, -tool_.deepest_gouge) &&
           is_body_clear(frame, 0);
}

double AxisRules::cutter_gap(const CutterLocation& location, double enough) const
{
    return std::min(enough, clearance_.gap(cutter_, frame_at(location), enough));
}

}  // namespace endmill
