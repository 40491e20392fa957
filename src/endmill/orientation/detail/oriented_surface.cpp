// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/oriented_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <sstream>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/cutter/cutting_body.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {
namespace {

// Lead beyond the least one at which the cutter fits.
constexpr double spare_lead_deg = 1;
// Share of a strip by which neighbouring passes are apart, for curvature that changes within
// a strip.
constexpr double used_strip = 0.97;
// The same share for the axes of a field. It leaves more, because a field uses all that there is
// at every contact, not only at the narrowest place of a pass.
constexpr double used_field_strip = 0.9;
// Contacts in each patch at which the width of a strip is examined.
constexpr int examined_contacts = 24;
// Rounds in which the distance of two passes is adapted to the narrower strip.
constexpr int adapting_rounds = 4;
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

ContactCurvature curvature_at(const FundamentalForms& forms, const SurfaceJet& jet,
                              const Vec3& feed, const Vec3& left)
{
    const TangentVector f = tangent_components(forms, jet, feed);
    const TangentVector b = tangent_components(forms, jet, left);
    return {
        normal_curvature(forms, f), normal_curvature(forms, b),
        -(forms.e * f.a * b.a + forms.f * (f.a * b.b + f.b * b.a) + forms.g * f.b * b.b)};
}

using IsFine = std::function<bool(const PassPose& from, const PassPose& to)>;

void add_rows(const PassPose& to, int halvings, const IsFine& is_fine,
              const OrientedSurface::Between& between, std::vector<PassPose>& rows)
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

OrientedSurface::OrientedSurface(const Surface& surface, double side, std::size_t number,
                                 const Cutter& cutter, const OrientedOptions& options)
    : surface_{surface},
      side_{side},
      number_{number},
      cutter_{cutter},
      options_{options}
{
    const auto range = curvature_range(surface, side);
    const double concave = range ? -range->least : 0;
    concave_radius_ = concave > 0 ? 1 / concave : std::numeric_limits<double>::infinity();
}

// Parameters along a pass at which strips are examined: some in each patch.
std::vector<double> OrientedSurface::examined() const
{
    const std::span<const double> breaks = surface_.breaks(options_.along);
    std::vector<double> places{breaks.front()};
    places.reserve((breaks.size() - 1) * examined_contacts + 1);
    for (std::size_t k = 1; k < breaks.size(); ++k)
        for (int part = 1; part <= examined_contacts; ++part)
            places.push_back(
                std::lerp(breaks[k - 1], breaks[k], double(part) / examined_contacts));
    return places;
}

PassPlace OrientedSurface::place(double along, const PassLine& line) const
{
    const bool is_u = options_.along == Parameter::U;
    const SurfacePoint at =
        is_u ? SurfacePoint{along, line.across} : SurfacePoint{line.across, along};
    const SurfaceJet jet = surface_.jet(at.u, at.v);
    const FundamentalForms forms = fundamental_forms(jet, side_);
    const Vec3 way = is_u ? jet.du : jet.dv;
    const Vec3 feed = (line.is_forward ? way : Vec3{-way}).normalized();
    const Vec3 left = forms.normal.cross(feed);
    return {{at.u, at.v, {jet.point, forms.normal}},
            feed,
            curvature_at(forms, jet, feed, left),
            std::abs((is_u ? jet.dv : jet.du).dot(left))};
}

Inclination OrientedSurface::inclination_at(const PassPlace& place) const
{
    Inclination inclination = options_.inclination;
    if (options_.mode == AxisMode::Fixed)
        return inclination;
    const auto beside = least_lead(cutter_, place.curvature);
    const auto heel = heel_lead(cutter_, concave_radius_);
    if (!beside || !heel)
        throw_gouge(place);
    const double needed = std::max(beside->degrees(), heel->degrees());
    const double spare = needed > 0 ? spare_lead_deg : 0;
    double lead = std::max(inclination.lead.degrees(), needed + spare);
    if (options_.mode == AxisMode::Field && !cutter_.is_ball())
        lead = std::max(lead, least_field_lead_deg);
    inclination.lead = Angle::degrees(lead);
    return inclination;
}

void OrientedSurface::throw_gouge(const PassPlace& place) const
{
    std::ostringstream message;
    message << "the cutter does not fit at "
            << place_text({place.at.u, place.at.v}, place.at.contact.point);
    if (number_ > 0)
        message << " of patch " << number_;
    const auto least = least_lead(cutter_, place.curvature);
    if (least)
        message << " with this inclination; the least lead there is "
                << to_text(std::ceil(100 * least->degrees()) / 100)
                << " degrees without tilt";
    else
        message << " with any lead; choose a smaller cutter or corner radius";
    throw GeometryError{message.str()};
}

PassPose OrientedSurface::posed(const PassPlace& place,
                                const Inclination& inclination) const
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

PassPose OrientedSurface::posed(const PassPlace& place, const Vec3& axis) const
{
    return posed(place, inclination_of(axis, place.at.contact.normal, place.feed));
}

PassPose OrientedSurface::pose(double along, const PassLine& line) const
{
    const PassPlace at = place(along, line);
    return posed(at, inclination_at(at));
}

RuledContact OrientedSurface::ruled(const PassPlace& place, const PassLine& line) const
{
    const double wanted = posed(place, inclination_at(place)).strip_mm;
    const double needed = 2 * line.covered * place.across / used_field_strip;
    return {place.at.contact, place.curvature,
            std::min(needed, wanted) * (1 - strip_slack), wanted};
}

Angle OrientedSurface::rear_lead() const
{
    const auto heel = heel_lead(cutter_, concave_radius_);
    return Angle::degrees(std::max(heel ? heel->degrees() : 0, least_field_lead_deg));
}

// Half the part of the strip that counts, as a length of the parameter across, at the
// narrowest place of a pass.
double OrientedSurface::reach(double across, const std::vector<double>& places) const
{
    double least = std::numeric_limits<double>::infinity();
    for (const double along : places)
        for (const bool is_forward : {true, false}) {
            const PassPose at = pose(along, {across, is_forward});
            least = std::min(least, used_strip * at.strip_mm / 2 / at.place.across);
        }
    return least;
}

std::vector<PassLine> OrientedSurface::passes() const
{
    const std::vector<double> places = examined();
    const Interval range = surface_.range(across());
    // the place whose strip begins at `begin`
    const auto place_beyond = [&](double begin) {
        double place = begin;
        for (int round = 0; round < adapting_rounds; ++round)
            place = std::min(range.high, begin + reach(place, places));
        return std::min(place, begin + reach(place, places));
    };
    std::vector<PassLine> found;
    double begin = range.low;
    while (begin < range.high || found.empty()) {
        const double next = place_beyond(begin);
        require(found.empty() || next > found.back().across,
                "plan_oriented: strips have no width");
        const double end = std::min(range.high, next + reach(next, places));
        const bool is_forward =
            options_.order == PassOrder::OneWay || found.size() % 2 == 0;
        found.push_back({next, is_forward, std::max(next - begin, end - next)});
        begin = end;
    }
    return found;
}

OrientedSurface::RowLimits OrientedSurface::row_limits(double share) const
{
    return {share * most_way * cutter_.radius(),
            std::cos(share * Angle::degrees(most_turn_deg).radians())};
}

std::vector<PassPose> OrientedSurface::rows(const PassLine& line) const
{
    const std::span<const double> breaks = surface_.breaks(options_.along);
    std::vector<PassPose> ends;
    ends.reserve(breaks.size());
    for (const double at : breaks)
        ends.push_back(pose(at, line));
    if (!line.is_forward)
        std::ranges::reverse(ends);
    const Between between{[&](const PassPose& from, const PassPose& to) {
                              return pose((along_of(from) + along_of(to)) / 2, line);
                          },
                          [](const ToolMotion&) { return true; }};
    return filled(ends, line,
                  row_limits(options_.mode == AxisMode::Field ? field_share : 1),
                  between);
}

std::vector<PassPose> OrientedSurface::with_rows_between(
    const std::vector<PassPose>& rows, const PassLine& line, const Between& between) const
{
    return filled(rows, line, row_limits(1), between);
}

std::vector<PassPose> OrientedSurface::filled(const std::vector<PassPose>& rows,
                                              const PassLine& line,
                                              const RowLimits& limits,
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

PassPlace OrientedSurface::place_between(const PassPose& from, const PassPose& to,
                                         const PassLine& line) const
{
    return place((along_of(from) + along_of(to)) / 2, line);
}

// Whether the motion between two rows keeps its tolerances at contacts between them.
bool OrientedSurface::is_fine(const PassPose& from, const PassPose& to,
                              const PassLine& line, const RowLimits& limits) const
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
            place(std::lerp(along_of(from), along_of(to), share), line).at.contact.point;
        double least = std::numeric_limits<double>::infinity();
        for (const double u : {share - shift, share, share + shift})
            least = std::min(least, body.distance(motion.seen(wanted, u)).value);
        if (least > most_left || least < -gouge_share * options_.inner_tolerance)
            return false;
    }
    return true;
}

}  // namespace endmill
