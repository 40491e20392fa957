// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/equations/rectangle_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>

#include <Eigen/Geometry>

#include "endmill/setup/detail/rectangle_fit.h"
#include "endmill/setup/detail/spherical_hull.h"
#include "five-axis-setup/equations/tally.h"
#include "support/candidate_tables.h"

namespace endmill {
namespace {

constexpr double rounding = 1e-12;
const Vec3 pole = Vec3::UnitZ();

std::vector<Vec3> hull_of(const std::vector<Vec3>& directions)
{
    return spherical_hull(pole, directions, HullProjection::Gnomonic);
}

std::vector<Vec3> sorted(std::vector<Vec3> points)
{
    std::ranges::sort(points, {}, [](const Vec3& point) {
        return std::tuple{point.x(), point.y(), point.z()};
    });
    return points;
}

bool is_on_one_side(const Vec3& normal, std::span<const Vec3> points)
{
    const auto dot = [&](const Vec3& point) { return point.dot(normal); };
    return std::ranges::all_of(
               points, [&](double d) { return d >= -rounding; }, dot) ||
           std::ranges::all_of(
               points, [&](double d) { return d <= rounding; }, dot);
}

// Calls `check(begin, end)` for each edge of a hull, the closing one included.
template <class Check>
void for_edges(const std::vector<Vec3>& hull, const Check& check)
{
    for (std::size_t k = 0; k < hull.size(); ++k)
        check(hull[k], hull[(k + 1) % hull.size()]);
}

// A direction within 90 degrees of the pole. Directions farther away have no hull.
Vec3 random_direction(RandomSets& random)
{
    const double z = random.number(0, 1);
    const double azimuth = random.number(0, 2 * std::numbers::pi);
    const double across = std::sqrt(1 - z * z);
    return {across * std::cos(azimuth), across * std::sin(azimuth), z};
}

RotaryRange random_range(RandomSets& random, double most)
{
    return {random.number(-most, 0), random.number(0, most)};
}

// Condition (20): the larger and the smaller end of each range, without signs.
bool fits_unsigned(const RotaryRange& needed, const RotaryRange& limits)
{
    constexpr double tolerance = 1e-9;  // rad, as `turn_tolerance`
    const auto need = magnitudes(needed);
    const auto most = magnitudes(limits);
    return need[0] <= most[0] + tolerance && need[1] <= most[1] + tolerance;
}

// As `fits_unsigned`, by < and not <=.
bool is_below(const RotaryRange& needed, const RotaryRange& limits)
{
    const auto need = magnitudes(needed);
    const auto most = magnitudes(limits);
    return need[0] < most[0] && need[1] < most[1];
}

RotaryRange spanned(const RotaryRange& one, const RotaryRange& other)
{
    return {std::min(one.from, other.from), std::max(one.to, other.to)};
}

bool are_equal(const RotaryRange& one, const RotaryRange& other)
{
    return std::abs(one.from - other.from) <= rounding &&
           std::abs(one.to - other.to) <= rounding;
}

}  // namespace

NamedCells hulls_by_projection(RandomSets random, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        const std::vector<Vec3> directions = random.directions();
        tally.add(sorted(hull_of(directions)) !=
                  sorted(incremental_hull(pole, directions)));
    }
    return tally.cells();
}

NamedCells hull_edges(RandomSets random, int sets)
{
    Tally tally;
    std::int64_t most = std::numeric_limits<std::int64_t>::min();
    for (int k = 0; k < sets; ++k) {
        const std::vector<Vec3> directions = random.directions();
        const std::vector<Vec3> hull = hull_of(directions);
        std::int64_t edges = 0;
        for_edges(hull, [&](const Vec3& begin, const Vec3& end) {
            edges += is_on_one_side(begin.cross(end), directions) ? 1 : 0;
        });
        const std::int64_t more = edges - std::ssize(hull);
        tally.add(more != -1);
        most = std::max(most, more);
    }
    return joined(tally.cells(), {{"edges_less_vertices", most}});
}

NamedCells supporting_vertices(RandomSets random, int sets)
{
    Tally tally;
    double as_printed = 0;
    double as_text = 0;
    while (tally.cases() < sets) {
        std::vector<Vec3> directions = random.directions();
        const Vec3 next = directions.back();
        directions.pop_back();
        const std::vector<Vec3> hull = hull_of(directions);
        bool is_outside = false;
        for_edges(hull, [&](const Vec3& begin, const Vec3& end) {
            is_outside |= begin.cross(end).dot(next) < -rounding;
        });
        if (hull.size() < 3 || !is_outside)
            continue;
        const auto printed = std::ranges::count_if(hull, [&](const Vec3& vertex) {
            return next.cross(vertex).dot(vertex) >= -rounding;
        });
        const auto text = std::ranges::count_if(hull, [&](const Vec3& vertex) {
            return is_on_one_side(next.cross(vertex), hull);
        });
        tally.add(printed != text);
        as_printed += static_cast<double>(printed) / sets;
        as_text += static_cast<double>(text) / sets;
    }
    return joined(tally.cells(), {{"as_printed", as_printed}, {"as_text", as_text}});
}

NamedCells axis_residuals(RandomSets random, int sets)
{
    Tally tally;
    double largest = 0;
    for (int k = 0; k < sets; ++k)
        for_edges(hull_of(random.directions()), [&](const Vec3& begin, const Vec3& end) {
            const Vec3 normal = begin.cross(end).normalized();
            const Vec3 r1 = pole.cross(normal).normalized();
            const Vec3 r2 = pole.cross(r1);
            const double residual =
                std::max({std::abs(r1.dot(pole)), std::abs(r1.dot(normal)),
                          std::abs(r2.dot(pole)), std::abs(r2.dot(r1))});
            tally.add(residual > rounding);
            largest = std::max(largest, residual);
        });
    return joined(tally.cells(), {{"largest_residual", largest}});
}

NamedCells signs_about_initial_axis(RandomSets random, int directions)
{
    const Vec3 r1 = Vec3::UnitX();
    const Vec3 r2 = pole.cross(r1);
    Tally tally;
    for (int k = 0; k < directions; ++k) {
        const Vec3 v = random_direction(random);
        const Vec3 projected = (v - v.dot(r1) * r1).normalized();
        const Vec3 turn = v.cross(projected);
        const Vec3 turned_r2 = projected.cross(r1);
        tally.add((turn.dot(r2) > 0) != (turn.dot(turned_r2) > 0));
    }
    return tally.cells();
}

NamedCells projection_roots(RandomSets random, int directions)
{
    constexpr int steps = 3600;
    const Vec3 r1 = Vec3::UnitX();
    const Vec3 r2 = pole.cross(r1);
    Tally tally;
    std::int64_t most = 0;
    for (int k = 0; k < directions; ++k) {
        const Vec3 v = random_direction(random);
        const auto left_side = [&](int step) {
            // Half a step off, so that no root at the pole falls on a step.
            const double angle = 2 * std::numbers::pi * (step + 0.5) / steps;
            const Vec3 on_circle = std::cos(angle) * pole + std::sin(angle) * r2;
            return v.cross(on_circle).dot(pole.cross(on_circle));
        };
        std::int64_t roots = 0;
        for (int step = 0; step < steps; ++step)
            roots += (left_side(step) > 0) != (left_side(step + 1) > 0) ? 1 : 0;
        tally.add(roots != 1);
        most = std::max(most, roots);
    }
    return joined(tally.cells(), {{"as_printed", most}});
}

NamedCells extremes_over_vertices(RandomSets random, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        const std::vector<Vec3> directions = random.directions();
        const std::vector<Vec3> hull = hull_of(directions);
        for (const RectangleCandidate& all :
             rectangle_candidates(pole, directions, SetupMode::Paper)) {
            const RectangleCandidate some = rectangle_about(pole, all.r1_axis, hull);
            tally.add(some.beta.from > all.beta.from + rounding ||
                      some.beta.to < all.beta.to - rounding);
        }
    }
    return tally.cells();
}

NamedCells unsigned_limits(RandomSets random, int pairs)
{
    const double most = std::numbers::pi / 2;
    Tally tally;
    for (int k = 0; k < pairs; ++k) {
        RectangleCandidate rectangle{};
        rectangle.alpha = random_range(random, most);
        rectangle.beta = random_range(random, most);
        const RotaryLimits limits{random_range(random, most), random_range(random, most)};
        if (fits_unsigned(rectangle.alpha, limits.phi) &&
            fits_unsigned(rectangle.beta, limits.theta))
            tally.add(!fits_rigidly(rectangle, limits));
    }
    return tally.cells();
}

NamedCells ranges_by_one_index(RandomSets random, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        const std::vector<Vec3> hull = hull_of(random.directions());
        RotaryRange alpha{0, 0};
        RotaryRange beta{0, 0};
        for_edges(hull, [&](const Vec3& begin, const Vec3& end) {
            const Vec3 r1 = pole.cross(begin.cross(end)).normalized();
            const RectangleCandidate own =
                rectangle_about(pole, r1, std::span{&begin, 1});
            alpha = spanned(alpha, own.alpha);
            beta = spanned(beta, own.beta);
            const RectangleCandidate all = rectangle_about(pole, r1, hull);
            tally.add(!are_equal(alpha, all.alpha) || !are_equal(beta, all.beta));
        });
    }
    return tally.cells();
}

NamedCells strict_rectangle_comparisons(RandomSets random, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k)
        for (const RectangleCandidate& found :
             rectangle_candidates(pole, random.directions(), SetupMode::Paper)) {
            const RectangleCandidate& machine = found;  // exactly these ranges
            const bool by_text = fits_unsigned(found.alpha, machine.alpha) &&
                                 fits_unsigned(found.beta, machine.beta);
            const bool as_printed = is_below(found.alpha, machine.alpha) &&
                                    is_below(found.beta, machine.beta);
            tally.add(as_printed != by_text);
        }
    return tally.cells();
}

NamedCells reported_rectangle(RandomSets random, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        const auto found =
            rectangle_candidates(pole, random.directions(), SetupMode::Paper);
        const auto count = static_cast<double>(found.size());
        const auto& machine = found[static_cast<std::size_t>(random.number(0, count))];
        const RectangleCandidate& least = least_area(found);
        tally.add(!fits_unsigned(least.alpha, machine.alpha) ||
                  !fits_unsigned(least.beta, machine.beta));
    }
    return tally.cells();
}

NamedCells rectangle_against_solid_angle(RandomSets random, int sets)
{
    constexpr int steps = 180;
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        const std::vector<Vec3> directions = random.directions();
        std::vector<RectangleCandidate> found;
        for (int step = 0; step < steps; ++step) {
            const double azimuth = std::numbers::pi * step / steps;
            found.push_back(rectangle_about(
                pole, {std::cos(azimuth), std::sin(azimuth), 0}, directions));
        }
        double least = std::numeric_limits<double>::infinity();
        for (const RectangleCandidate& rectangle : found)
            least = std::min(least, solid_angle(rectangle));
        tally.add_ratio(solid_angle(least_area(found)) / least, 1.001);
    }
    return tally.ratio_cells();
}

NamedCells near_optimal_rectangles(RandomSets random, int sets)
{
    Tally tally;
    for (int k = 0; k < sets; ++k) {
        const std::vector<Vec3> directions = random.directions();
        const auto paper = rectangle_candidates(pole, directions, SetupMode::Paper);
        const auto all = rectangle_candidates(pole, directions, SetupMode::Corrected);
        tally.add_ratio(least_area(paper).area() / least_area(all).area(), 1.05);
    }
    return tally.ratio_cells();
}

}  // namespace endmill
