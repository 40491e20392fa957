// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/equations/sector_checks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "endmill/core/angle.h"
#include "endmill/setup/detail/sector_fit.h"
#include "five-axis-setup/equations/tally.h"
#include "support/candidate_tables.h"

namespace endmill {
namespace {

constexpr double equal_deg =
    1e-9;  // above the rounding of angles of some hundred degrees

// A direction about the tool axis +z, in degrees.
struct PolarAngles {
    double azimuth;  // alpha, within [0, 360)
    double polar;    // beta
};

// One step of the enumeration over j: azimuths in degrees, later ones with whole turns
// added (section 7, no. 7).
struct Step {
    double azimuth;  // alpha_j
    double next;     // alpha_(j+1)
    double beyond;   // alpha_l, the first one beyond the antipode of alpha_j

    double antipode() const { return azimuth + 180; }
    bool takes_next() const { return next <= beyond - 180; }  // (6) with alpha_l^c
    double width() const                                      // theta_j of (8)
    {
        return takes_next() ? antipode() - next : azimuth + 360 - beyond;
    }
};

double degrees(double angle)
{
    return Angle::radians(angle).degrees();
}

// `angle` shifted by multiples of `turn` into [0, turn).
double within(double angle, double turn)
{
    const double rest = std::fmod(angle, turn);
    return rest < 0 ? rest + turn : rest;
}

std::vector<PolarAngles> polar_angles(const std::vector<Vec3>& directions)
{
    std::vector<PolarAngles> found;
    found.reserve(directions.size());
    for (const Vec3& v : directions)
        found.push_back({within(degrees(std::atan2(v.y(), v.x())), 360),
                         degrees(std::atan2(std::hypot(v.x(), v.y()), v.z()))});
    std::ranges::sort(found, {}, &PolarAngles::azimuth);
    return found;
}

std::vector<Step> steps_of(const std::vector<PolarAngles>& points)
{
    std::vector<Step> steps;
    for (std::size_t j = 0; j < points.size(); ++j) {
        const double here = points[j].azimuth;
        const bool is_last = j + 1 == points.size();
        Step step{here, is_last ? points[0].azimuth + 360 : points[j + 1].azimuth,
                  std::numeric_limits<double>::infinity()};
        for (const PolarAngles& other : points)
            for (const double turned : {other.azimuth, other.azimuth + 360})
                if (turned > step.antipode())
                    step.beyond = std::min(step.beyond, turned);
        steps.push_back(step);
    }
    return steps;
}

// Calls `check` for each step of each random set.
void for_steps(
    RandomSets& random, int sets,
    const std::function<void(const Step&, const std::vector<PolarAngles>&)>& check)
{
    for (int k = 0; k < sets; ++k) {
        const std::vector<PolarAngles> points = polar_angles(random.directions());
        for (const Step& step : steps_of(points))
            check(step, points);
    }
}

// The largest value in the sector [from, from + width], and the largest of the others.
template <class Value>
std::pair<double, double> largest_of_both(const std::vector<PolarAngles>& points,
                                          double from, double width, const Value& value)
{
    double inside = 0;
    double outside = 0;
    for (const PolarAngles& point : points) {
        // A direction at the beginning may round to just below a whole turn.
        const double turned = within(point.azimuth - from + equal_deg, 360);
        double& most = turned <= width + 2 * equal_deg ? inside : outside;
        most = std::max(most, std::invoke(value, point));
    }
    return {inside, outside};
}

// The least F in square degrees of all double sectors between two directions or their
// antipodes.
double least_between_ends(const std::vector<PolarAngles>& points)
{
    double least = std::numeric_limits<double>::infinity();
    for (const PolarAngles& first : points)
        for (const PolarAngles& last : points) {
            const double width = within(last.azimuth - first.azimuth, 180);
            const bool holds_all =
                std::ranges::all_of(points, [&](const PolarAngles& point) {
                    return within(point.azimuth - first.azimuth + equal_deg, 180) <=
                           width + 2 * equal_deg;
                });
            if (!holds_all)
                continue;
            const auto [inside, outside] =
                largest_of_both(points, first.azimuth, width, &PolarAngles::polar);
            least = std::min(least, (inside + outside) * width);
        }
    return least;
}

double apart_deg(double one, double other)
{
    return std::abs(std::remainder(one - other, 360));
}

std::vector<SectorCandidate> candidates(const std::vector<Vec3>& directions)
{
    return sector_candidates(Vec3::UnitZ(), directions, SetupMode::Paper);
}

bool fits(const SectorCandidate& sector, const SectorCandidate& machine)
{
    constexpr double tolerance = 1e-9;  // rad, as `turn_tolerance`
    const auto [low, high] = std::minmax(sector.polar, sector.opposite_polar);
    const auto [least, most] = std::minmax(machine.polar, machine.opposite_polar);
    return low <= least + tolerance && high <= most + tolerance &&
           sector.width <= machine.width + tolerance;
}

}  // namespace

NamedCells sectors_against_all_ends(RandomSets random, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        const std::vector<Vec3> directions = random.directions();
        const double by_gaps = least_area(candidates(directions)).area();
        const double by_ends = least_between_ends(polar_angles(directions));
        const double found = degrees(degrees(by_gaps));
        tally.add(std::abs(found - by_ends) > 1e-6 * (1 + by_ends));
    }
    return tally.cells();
}

NamedCells interval_widths(RandomSets random, int sets)
{
    Tally tally;
    for_steps(random, sets, [&](const Step& step, const auto&) {
        const double second = step.takes_next() ? step.next + 180 : step.beyond;
        const double opposite = step.takes_next() ? step.next : step.beyond + 180;
        tally.add_difference(apart_deg(step.azimuth - second, step.width()), equal_deg);
        tally.add_difference(apart_deg(step.antipode() - opposite, step.width()),
                             equal_deg);
    });
    return tally.difference_cells();
}

NamedCells width_forms(RandomSets random, int sets)
{
    Tally tally;
    for_steps(random, sets, [&](const Step& step, const auto&) {
        const double first =
            step.takes_next() ? step.antipode() - step.next : step.azimuth - step.beyond;
        const double second = step.takes_next() ? step.azimuth - (step.next + 180)
                                                : step.antipode() - (step.beyond + 180);
        tally.add_difference(apart_deg(first, second), equal_deg);
    });
    return tally.difference_cells();
}

NamedCells third_condition(RandomSets random, int sets)
{
    Tally tally;
    for_steps(random, sets, [&](const Step& step, const auto&) {
        const double tilt_deg = random.number(0, 180);  // Phi_L + Phi_S
        const double turn_deg = random.number(0, 360);  // Theta_L + Theta_S
        tally.add((step.width() <= tilt_deg) != (step.width() <= turn_deg));
    });
    return tally.cells();
}

NamedCells choice_of_second_end(RandomSets random, int sets)
{
    Tally tally;
    for_steps(random, sets, [&](const Step& step, const auto&) {
        tally.add((step.next <= step.antipode()) != step.takes_next());
    });
    return tally.cells();
}

NamedCells width_of_procedure(RandomSets random, int sets)
{
    Tally tally;
    for_steps(random, sets, [&](const Step& step, const auto&) {
        const double printed = step.takes_next() ? step.azimuth - step.next : 0;
        tally.add(apart_deg(printed, step.width()) > equal_deg);
    });
    return tally.cells();
}

NamedCells parts_of_width(RandomSets random, int sets)
{
    Tally tally;
    for_steps(random, sets, [&](const Step& step, const auto&) {
        const double most_deg = random.number(90, 180);  // Theta_L
        const double least_deg = random.number(10, 90);  // Theta_S
        double larger = most_deg;
        double smaller = least_deg;
        larger = step.width() * larger / (larger + smaller);
        smaller = step.width() * smaller / (larger + smaller);
        const double by_ratio = step.width() * least_deg / (most_deg + least_deg);
        tally.add(std::abs(smaller - by_ratio) > equal_deg);
    });
    return tally.cells();
}

NamedCells length_of_procedure(RandomSets random, int sets)
{
    Tally tally;
    for_steps(random, sets,
              [&](const Step& step, const std::vector<PolarAngles>& points) {
                  const double from = step.azimuth - step.width();
                  const auto by_alpha =
                      largest_of_both(points, from, step.width(), &PolarAngles::azimuth);
                  const auto by_beta =
                      largest_of_both(points, from, step.width(), &PolarAngles::polar);
                  tally.add(std::abs(by_alpha.first - by_beta.first) > equal_deg ||
                            std::abs(by_alpha.second - by_beta.second) > equal_deg);
              });
    return tally.cells();
}

NamedCells strict_comparisons(RandomSets random, int sets)
{
    Tally tally;
    for_steps(random, sets, [&](const Step& step, const auto&) {
        const double needed = step.width();
        const double limit = needed;  // a machine with exactly this range
        tally.add((needed < limit) != (needed <= limit));
    });
    return tally.cells();
}

NamedCells reported_sector(RandomSets random, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        const auto found = candidates(random.directions());
        const auto count = static_cast<double>(found.size());
        const auto chosen = static_cast<std::size_t>(random.number(0, count));
        tally.add(!fits(least_area(found), found[chosen]));
    }
    return tally.cells();
}

NamedCells area_against_solid_angle(RandomSets random, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        const auto found = candidates(random.directions());
        double least = std::numeric_limits<double>::infinity();
        for (const SectorCandidate& sector : found)
            least = std::min(least, solid_angle(sector));
        tally.add_ratio(solid_angle(least_area(found)) / least, 1.001);
    }
    return tally.ratio_cells();
}

}  // namespace endmill
