// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/detail/oriented_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {
namespace {

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
ContactCurvature curvature_at(const FundamentalForms& forms, const SurfaceJet& jet,
                              const Vec3& feed, const Vec3& left)
{
    const TangentVector f = tangent_components(forms, jet, feed);
    const TangentVector b = tangent_components(forms, jet, left);
    return {
        normal_curvature(forms, f), normal_curvature(forms, b),
        -(forms.e * f.a * b.a + forms.f * (f.a * b.b + f.b * b.a) + forms.g * f.b * b.b)};
}

double concave_radius(const Surface& surface, double side)
{
    const auto range = curvature_range(surface, side);
    const double concave = range ? -range->least : 0;
    return concave > 0 ? 1 / concave : std::numeric_limits<double>::infinity();
}

}  // namespace

OrientedSurface::OrientedSurface(const Surface& surface, double side, std::size_t number,
                                 const Cutter& cutter, const OrientedOptions& options)
    : OrientedPart{cutter, options, concave_radius(surface, side)},
      surface_{surface},
      side_{side},
      number_{number}
{
}

// Parameters along a pass at which strips are examined: some in each patch.
std::vector<double> OrientedSurface::examined() const
{
    const std::span<const double> breaks = surface_.breaks(options().along);
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
    const bool is_u = options().along == Parameter::U;
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
            std::abs((is_u ? jet.dv : jet.du).dot(left)),
            along};
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
            options().order == PassOrder::OneWay || found.size() % 2 == 0;
        found.push_back({next, is_forward, std::max(next - begin, end - next)});
        begin = end;
    }
    return found;
}

std::vector<double> OrientedSurface::fixed_rows(const PassLine&) const
{
    const std::span<const double> breaks = surface_.breaks(options().along);
    return {breaks.begin(), breaks.end()};
}

double OrientedSurface::needed_strip(const PassPlace& place, const PassLine& line) const
{
    return 2 * line.covered * place.across / used_field_strip;
}

std::string OrientedSurface::name_of(const PassPlace& place) const
{
    std::string name = place_text({place.at.u, place.at.v}, place.at.contact.point);
    if (number_ > 0)
        name.append(" of patch ").append(std::to_string(number_));
    return name;
}

}  // namespace endmill
