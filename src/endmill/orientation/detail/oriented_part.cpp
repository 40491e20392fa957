// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/oriented_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/cutting_body.h"

namespace endmill {
namespace {

// Lead beyond the least one at which the cutter fits.
constexpr double spare_lead_deg = 1;
// Shares of the tolerances that a motion between two rows may use.
constexpr double gouge_share = 0.5;
constexpr double left_share = 0.05;
// Greatest turn of the axis, and greatest way in radii of the cutter, between two rows.
constexpr double most_turn_deg = 10;
constexpr double most_way = 1;
// Share of these limits for the contacts of a field, which has no axis between them.
constexpr double field_share = 0.5;
// Least lead of a field for a cutter that is no ball. Near an upright axis the contact runs
// round the rim.
constexpr double least_field_lead_deg = 1;
// Slack of the needed strip, for rounding.
constexpr double strip_slack = 1e-9;
constexpr int most_halvings = 20;
// Places between two rows at which the motion is examined, and parts of a step up to which
// the cutter may be ahead of them or behind.
constexpr int examined_places = 4;
constexpr double shift = 0.05;

using IsFine = std::function<bool(const PassPose& from, const PassPose& to)>;

void add_rows(const PassPose& to, int halvings, const IsFine& is_fine,
              const OrientedPart::Between& between, std::vector<PassPose>& rows)
{
    const PassPose from = rows.back();
    if (halvings == 0 || is_fine(from, to)) {
        rows.push_back(to);
        return;
    }
    add_rows(between.pose(from, to), halvings - 1, is_fine, between, rows);
    add_rows(to, halvings - 1, is_fine, between, rows);
}

}  // namespace

double contact_way(const PassPose& from, const PassPose& to)
{
    return (to.place.at.contact.point - from.place.at.contact.point).norm();
}

std::optional<Inclination> OrientedPart::fitting_inclination(const PassPlace& place) const
{
    Inclination inclination = options_.inclination;
    if (options_.mode == AxisMode::Fixed)
        return inclination;
    const auto beside = least_lead(cutter_, place.curvature);
    const auto heel = heel_lead(cutter_, concave_radius_);
    if (!beside || !heel)
        return std::nullopt;
    const double needed = std::max(beside->degrees(), heel->degrees());
    const double spare = needed > 0 ? spare_lead_deg : 0;
    double lead = std::max(inclination.lead.degrees(), needed + spare);
    if (options_.mode == AxisMode::Field && !cutter_.is_ball())
        lead = std::max(lead, least_field_lead_deg);
    inclination.lead = Angle::degrees(lead);
    return inclination;
}

Inclination OrientedPart::inclination_at(const PassPlace& place) const
{
    const auto inclination = fitting_inclination(place);
    if (!inclination)
        throw_gouge(place);
    return *inclination;
}

void OrientedPart::throw_gouge(const PassPlace& place) const
{
    std::ostringstream message;
    message << "the cutter does not fit at " << name_of(place);
    const auto least = least_lead(cutter_, place.curvature);
    if (least)
        message << " with this inclination; the least lead there is "
                << to_text(std::ceil(100 * least->degrees()) / 100)
                << " degrees without tilt";
    else
        message << " with any lead; choose a smaller cutter or corner radius";
    throw GeometryError{message.str()};
}

PassPose OrientedPart::posed(const PassPlace& place, const Inclination& inclination) const
{
    const auto strip =
        strip_width(cutter_, place.curvature, inclination, options_.scallop_height);
    if (!strip)
        throw_gouge(place);
    const CutterContact& contact = place.at.contact;
    const Vec3 axis = inclined_axis(contact.normal, place.feed, inclination);
    return {place,
            {control_point(cutter_, contact, ControlPoint::Tip, axis), axis},
            inclination,
            *strip};
}

PassPose OrientedPart::posed(const PassPlace& place, const Vec3& axis) const
{
    return posed(place, inclination_of(axis, place.at.contact.normal, place.feed));
}

PassPose OrientedPart::pose(double along, const PassLine& line) const
{
    const PassPlace at = place(along, line);
    return posed(at, inclination_at(at));
}

RuledContact OrientedPart::ruled(const PassPlace& place, const PassLine& line) const
{
    const double wanted = posed(place, inclination_at(place)).strip_mm;
    return {place.at.contact, place.curvature,
            std::min(needed_strip(place, line), wanted) * (1 - strip_slack), wanted};
}

Angle OrientedPart::rear_lead() const
{
    const auto heel = heel_lead(cutter_, concave_radius_);
    return Angle::degrees(std::max(heel ? heel->degrees() : 0, least_field_lead_deg));
}

OrientedPart::RowLimits OrientedPart::row_limits(double share) const
{
    return {share * most_way * cutter_.radius(),
            std::cos(share * Angle::degrees(most_turn_deg).radians())};
}

std::vector<PassPose> OrientedPart::rows(const PassLine& line) const
{
    const std::vector<double> fixed = fixed_rows(line);
    std::vector<PassPose> ends;
    ends.reserve(fixed.size());
    for (const double at : fixed)
        ends.push_back(pose(at, line));
    if (!line.is_forward)
        std::ranges::reverse(ends);
    const Between between{[&](const PassPose& from, const PassPose& to) {
                              return pose((from.place.along + to.place.along) / 2, line);
                          },
                          [](const ToolMotion&) { return true; }};
    return filled(ends, line,
                  row_limits(options_.mode == AxisMode::Field ? field_share : 1),
                  between);
}

std::vector<PassPose> OrientedPart::with_rows_between(const std::vector<PassPose>& rows,
                                                      const PassLine& line,
                                                      const Between& between) const
{
    return filled(rows, line, row_limits(1), between);
}

std::vector<PassPose> OrientedPart::filled(const std::vector<PassPose>& rows,
                                           const PassLine& line, const RowLimits& limits,
                                           const Between& between) const
{
    std::vector<PassPose> found{rows.front()};
    const IsFine is_between_fine = [&](const PassPose& from, const PassPose& to) {
        return is_fine(from, to, line, limits) &&
               between.is_right({from.location, to.location});
    };
    for (std::size_t k = 1; k < rows.size(); ++k)
        add_rows(rows[k], most_halvings, is_between_fine, between, found);
    return found;
}

PassPlace OrientedPart::place_between(const PassPose& from, const PassPose& to,
                                      const PassLine& line) const
{
    return place((from.place.along + to.place.along) / 2, line);
}

// Whether the motion between two rows keeps its tolerances at contacts between them.
bool OrientedPart::is_fine(const PassPose& from, const PassPose& to, const PassLine& line,
                           const RowLimits& limits) const
{
    if (contact_way(from, to) > limits.way ||
        from.location.axis.dot(to.location.axis) < limits.turn_cosine)
        return false;
    const CuttingBody body{cutter_};
    const ToolMotion motion{from.location, to.location};
    const double most_left =
        std::min(left_share * options_.scallop_height, options_.inner_tolerance);
    for (int k = 1; k < examined_places; ++k) {
        const double share = double(k) / examined_places;
        const Vec3 wanted =
            place(std::lerp(from.place.along, to.place.along, share), line)
                .at.contact.point;
        double least = std::numeric_limits<double>::infinity();
        for (const double u : {share - shift, share, share + shift})
            least = std::min(least, body.distance(motion.seen(wanted, u)).value);
        if (least > most_left || least < -gouge_share * options_.inner_tolerance)
            return false;
    }
    return true;
}

}  // namespace endmill
