// SPDX-License-Identifier: GPL-3.0-or-later
#include "economic-cl-data/other-surfaces/surface_study.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "endmill/planning/detail/continuum_travel.h"
#include "endmill/post/gcode_writer.h"

namespace endmill {
namespace {

constexpr std::size_t middle =
    1;  // index of the ball of 15 mm and of the tolerance of 0.5 mm

// Samples of the integrals along each parameter. Planes need more, since their intervals are least values
// over the samples between two planes.
constexpr int continuum_samples = 100;
constexpr int planar_samples = 400;
constexpr int planar_feeds = 36;  // directions of drive planes

// Chords along a pass: its length is short of the curve's by less than 1e-4 of it.
constexpr int chords_of_pass = 256;

// The constant parameter of each pass of `path`, rising.
std::vector<double> pass_parameters(const ToolPath& path, Parameter direction)
{
    std::vector<double> parameters;
    for (const PathPoint& point : path.points) {
        if (point.contact() == nullptr)
            continue;
        const double at =
            direction == Parameter::U ? point.contact()->v : point.contact()->u;
        if (parameters.empty() || at > parameters.back())
            parameters.push_back(at);
    }
    return parameters;
}

double pass_length(const Surface& surface, Parameter direction, double at)
{
    const Interval range = surface.range(direction);
    double length = 0;
    Vec3 last;
    for (int k = 0; k <= chords_of_pass; ++k) {
        const double along = std::lerp(range.low, range.high, k / double(chords_of_pass));
        const Vec3 point = direction == Parameter::U ? surface.tangents(along, at).point
                                                     : surface.tangents(at, along).point;
        if (k > 0)
            length += (point - last).norm();
        last = point;
    }
    return length;
}

// The last interval is left out: it ends at the border, wherever the pass before lies.
double least_interval(const std::vector<double>& parameters)
{
    double least = parameters[1] - parameters[0];
    for (std::size_t k = 2; k + 1 < parameters.size(); ++k)
        least = std::min(least, parameters[k] - parameters[k - 1]);
    return least;
}

PassTravel pass_travel(const Surface& surface, const ToolPath& path, Parameter direction)
{
    const std::vector<double> parameters = pass_parameters(path, direction);
    PassTravel travel{0, 0};
    for (const double at : parameters)
        travel.planned += pass_length(surface, direction, at);

    const Interval range{parameters.front(), parameters.back()};
    // A hair below a whole number is one: equal intervals give no additional pass.
    const int intervals =
        static_cast<int>(std::ceil(range.length() / least_interval(parameters) - 1e-6));
    for (int k = 0; k <= intervals; ++k)
        travel.uniform += pass_length(
            surface, direction, std::lerp(range.low, range.high, k / double(intervals)));
    return travel;
}

double tape_metres(const ToolPath& path)
{
    GcodeOptions options;
    options.feed_mm_per_min = 1000;  // any: the length of one word
    return gcode(path, options).tape_length_m();
}

}  // namespace

SurfaceStudy study_surface(const Surface& surface, double scale)
{
    SurfaceStudy study{};
    const TablePolicies policies;
    for (std::size_t along = 0; along < table_directions.size(); ++along)
        for (std::size_t i = 0; i < table_tolerances_mm.size(); ++i)
            for (std::size_t j = 0; j < table_diameters_mm.size(); ++j) {
                const Parameter direction = table_directions[along];
                const ToolPath path = table_plan(surface, policies, direction,
                                                 scale * table_tolerances_mm[i],
                                                 scale * table_diameters_mm[j])
                                          .path;
                study.tables.runs[along][i][j] = path_cost(path, policies);
                if (i == middle && j == middle) {
                    const PathEconomy economy = path_economy(path);
                    study.tips_mm[along] = economy.cut.tip_mm + economy.link.tip_mm;
                    study.travel[along] = pass_travel(surface, path, direction);
                }
                if (along == 0 && i + 1 == table_tolerances_mm.size() && j == 0)
                    study.tape_m = tape_metres(path);
            }
    const ScallopRequest request{BallCutter{scale * table_diameters_mm[middle] / 2},
                                 scale * table_tolerances_mm[middle]};
    for (std::size_t along = 0; along < table_directions.size(); ++along) {
        const ContinuumTravel travel = continuum_travel(
            surface, request, table_directions[along], continuum_samples);
        study.iso_mm[along] = travel.iso;
        study.local_mm[along] = travel.local;
    }
    study.planes_mm =
        planar_extremes(surface, request, planar_feeds, planar_samples).least;
    return study;
}

std::string smaller(double u, double v)
{
    constexpr double rounding = 1e-9;
    if (std::abs(u - v) <= rounding * std::max(u, v))
        return "either";
    return u < v ? "u" : "v";
}

}  // namespace endmill
