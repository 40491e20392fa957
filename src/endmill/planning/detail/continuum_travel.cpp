// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/continuum_travel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/planning/path_interval.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// Feed directions tried at each sample.
constexpr int directions_at_a_place = 36;
// Bins across the feed, for each line of samples. In a bin the smallest interval holds,
// so a bin must contain several samples.
constexpr double planes_a_line = 0.25;

// A sample of the integrals over the surface.
struct Place {
    SurfaceJet jet;
    FundamentalForms forms;
    double area;  // mm^2
};

// Samples at the middles of `samples` by `samples` equal cells of the parameter domain.
std::vector<Place> places_of(const Surface& surface, int samples)
{
    const double side = tool_side_sign(surface, Vec3::UnitZ());
    const Interval u = surface.range(Parameter::U);
    const Interval v = surface.range(Parameter::V);
    const double cell = (u.high - u.low) * (v.high - v.low) / (double(samples) * samples);
    std::vector<Place> places;
    for (int j = 0; j < samples; ++j)
        for (int i = 0; i < samples; ++i) {
            const SurfaceJet jet =
                surface.jet(std::lerp(u.low, u.high, (i + 0.5) / samples),
                            std::lerp(v.low, v.high, (j + 0.5) / samples));
            places.push_back(
                {jet, fundamental_forms(jet, side), cell * jet.du.cross(jet.dv).norm()});
        }
    return places;
}

// Number of passes per mm across the feed: 1 / path interval.
// \param feed a tangent vector of any length.
double density(const Place& place, const Vec3& feed, const ScallopRequest& request)
{
    const Vec3 across = place.forms.normal.cross(feed).normalized();
    const double curvature =
        normal_curvature(place.forms, tangent_components(place.forms, place.jet, across));
    return 1 / path_interval(request.ball, curvature, request.scallop_height).chord;
}

double greatest_interval_density(const Place& place, const ScallopRequest& request)
{
    const Vec3 one = place.jet.du.normalized();
    const Vec3 other = place.forms.normal.cross(one);
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < directions_at_a_place; ++k) {
        const double angle = std::numbers::pi * k / directions_at_a_place;
        least = std::min(
            least,
            density(place, std::cos(angle) * one + std::sin(angle) * other, request));
    }
    return least;
}

// Travel in mm along parallel drive planes with the normal `across`.
double planar_travel(const std::vector<Place>& places, const ScallopRequest& request,
                     const Vec3& across, int planes)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Place& place : places) {
        low = std::min(low, across.dot(place.jet.point));
        high = std::max(high, across.dot(place.jet.point));
    }
    std::vector<double> length(planes, 0);  // sum of area times slant, mm^2
    std::vector<double> dense(planes, 0);   // planes per mm
    for (const Place& place : places) {
        const double at = (across.dot(place.jet.point) - low) / (high - low);
        const auto plane =
            static_cast<std::size_t>(std::clamp(at * planes, 0.0, planes - 1.0));
        const double slant = place.forms.normal.cross(across).norm();
        length[plane] += place.area * slant;
        dense[plane] =
            std::max(dense[plane],
                     density(place, across.cross(place.forms.normal), request) / slant);
    }
    double travel = 0;
    for (int k = 0; k < planes; ++k)
        travel +=
            length[static_cast<std::size_t>(k)] * dense[static_cast<std::size_t>(k)];
    return travel;
}

}  // namespace

ContinuumTravel continuum_travel(const Surface& surface, const ScallopRequest& request,
                                 Parameter direction, int samples)
{
    const std::vector<Place> places = places_of(surface, samples);
    const bool along_u = direction == Parameter::U;
    const Interval feed_range = surface.range(direction);
    const Interval across_range = surface.range(along_u ? Parameter::V : Parameter::U);
    const double step = (feed_range.high - feed_range.low) / samples;
    const double step_across = (across_range.high - across_range.low) / samples;
    ContinuumTravel travel{0, 0, 0};
    for (int pass = 0; pass < samples; ++pass) {
        double length = 0;
        double passes = 0;  // passes per unit of the parameter across the feed
        for (int k = 0; k < samples; ++k) {
            const auto number = static_cast<std::size_t>(along_u ? pass * samples + k
                                                                 : k * samples + pass);
            const Place& place = places[number];
            const Vec3& feed = along_u ? place.jet.du : place.jet.dv;
            const double dense = density(place, feed, request);
            const double width = place.jet.du.cross(place.jet.dv).norm() / feed.norm();
            length += feed.norm() * step;
            passes = std::max(passes, width * dense);
            travel.local += place.area * dense;
            travel.best_direction +=
                place.area * greatest_interval_density(place, request);
        }
        travel.iso += length * passes * step_across;
    }
    return travel;
}

PlanarExtremes planar_extremes(const Surface& surface, const ScallopRequest& request,
                               int directions, int samples)
{
    const std::vector<Place> places = places_of(surface, samples);
    const int planes = std::max(1, static_cast<int>(planes_a_line * samples));
    PlanarExtremes found{std::numeric_limits<double>::infinity(), 0, 0};
    for (int k = 0; k < directions; ++k) {
        const double degrees = 180.0 * k / directions;
        const double feed = Angle::degrees(degrees).radians();
        const double travel =
            planar_travel(places, request, {-std::sin(feed), std::cos(feed), 0}, planes);
        if (travel < found.least)
            found = {travel, degrees, found.greatest};
        found.greatest = std::max(found.greatest, travel);
    }
    return found;
}

}  // namespace endmill
