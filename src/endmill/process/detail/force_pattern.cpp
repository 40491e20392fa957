// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/force_pattern.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "endmill/process/detail/border_integrals.h"

// Outline:
// - Construction tabulates the moments of the edge over the latitude. It samples the sums
//   at nine azimuths of the tip between each pair of neighbouring events.
// - `at` adds the closed sums over the engaged ranges of each flute. The paper's chip
//   |sin u| needs ranges split where sin u changes its sign; the exact chip does not on
//   the ball.
// - `largest` finds the maximum of any function of the sums, such as a load, over a
//   revolution. It refines by golden-section search the intervals whose best sample comes
//   close to the best of all.

namespace endmill {
namespace {

using std::numbers::pi;

// Number of cells of the table of moments over the ball. With three Gauss nodes in each
// cell the error is 1e-13 up to a helix of 80 degrees.
constexpr int moment_cells = 128;
constexpr double moment_cell = pi / 2 / moment_cells;

// Integral of sin(t - z tangent) over a range of z, written as a product to avoid
// cancellation.
double sine_integral(const EdgeRange& range, double turn, double tangent)
{
    const double length = range.to - range.from;
    const double middle = turn - (range.from + range.to) / 2 * tangent;
    const double half = tangent * length / 2;
    const double share = half != 0 ? std::sin(half) / half : 1;
    return length * share * std::sin(middle);
}

// Latitude in rad of a height above the tip, at most a right angle.
double latitude_at(double height)
{
    return 2 * std::asin(std::sqrt(std::clamp(height / 2, 0.0, 0.5)));
}

// Integral of r dz from the tip to `height`.
double radius_integral(double height)
{
    return height * std::sqrt(height * (2 - height)) * torque_height_share(height);
}

// Calls `visit` with the parts of a range in which sin(t - z tangent) has one sign.
template <typename Visit>
void for_each_half_turn(const EdgeRange& range, double turn, double tangent,
                        const Visit& visit)
{
    const double bottom = turn - range.from * tangent;
    const double top = turn - range.to * tangent;
    double from = range.from;
    const double step = top > bottom ? 1 : -1;
    double half_turns =
        step > 0 ? std::floor(bottom / pi) + 1 : std::ceil(bottom / pi) - 1;
    for (; step * half_turns * pi < step * top; half_turns += step) {
        const double to = (turn - half_turns * pi) / tangent;
        if (to > from && to < range.to) {
            visit(EdgeRange{from, to});
            from = to;
        }
    }
    visit(EdgeRange{from, range.to});
}

}  // namespace

ForcePattern::ForcePattern(const BallEngagement& engagement, ChipModel chip,
                           const MillingTool& tool)
    : engagement_{engagement},
      chip_{chip},
      flutes_{(require_sound(tool), tool.flutes)},
      cos_lambda_{std::cos(engagement.lambda)},
      sin_lambda_{std::sin(engagement.lambda)},
      edge_{engagement, tool.helix}
{
    tabulate_moments();
    sample();
}

void ForcePattern::tabulate_moments()
{
    moments_.assign(moment_cells + 1, {0, 0});
    for (int k = 0; k < moment_cells; ++k)
        moments_[k + 1] = moments_from(k, (k + 1) * moment_cell);
}

std::array<double, 2> ForcePattern::torque_moments(double latitude) const
{
    const int below = static_cast<int>(latitude / moment_cell);
    return moments_from(std::clamp(below, 0, moment_cells - 1), latitude);
}

// The moments from the tip to `latitude`: the table's entry `below`, plus three Gauss
// nodes from the latitude of that entry.
std::array<double, 2> ForcePattern::moments_from(int below, double latitude) const
{
    constexpr std::array<double, 3> weight{5.0 / 9, 8.0 / 9, 5.0 / 9};
    const double outer_node = std::sqrt(0.6);
    std::array<double, 2> sums = moments_[below];
    const double half = (latitude - below * moment_cell) / 2;
    for (int k = 0; k < 3; ++k) {
        const double at = below * moment_cell + half * (1 + (k - 1) * outer_node);
        const double sine = std::sin(at);
        const double trail = (1 - std::cos(at)) * edge_.tangent();
        const double share = weight[k] * half * sine * sine;
        sums[0] += share * std::cos(trail);
        sums[1] += share * std::sin(trail);
    }
    return sums;
}

void ForcePattern::add_range(const EdgeRange& range, double turn, EdgeSums& sums) const
{
    const bool is_on_ball = range.to <= 1;
    const double length = range.to - range.from;
    sums.edge += length;
    if (!is_on_ball) {
        const double share = chip_ == ChipModel::Exact ? cos_lambda_ : 1;
        const double chip = share * std::abs(sine_integral(range, turn, edge_.tangent()));
        sums.chip += chip;
        sums.chip_torque += chip;
        sums.edge_torque += length;
        return;
    }
    const double low = latitude_at(range.from);
    const double high = latitude_at(range.to);
    const std::array<double, 2> from = torque_moments(low);
    const std::array<double, 2> to = torque_moments(high);
    const double torque =
        std::sin(turn) * (to[0] - from[0]) - std::cos(turn) * (to[1] - from[1]);
    sums.edge_torque += radius_integral(range.to) - radius_integral(range.from);
    if (chip_ == ChipModel::Paper) {
        sums.chip += std::abs(sine_integral(range, turn, edge_.tangent()));
        sums.chip_torque += std::abs(torque);
        return;
    }
    // The exact chip over dz is (P T) / sin(latitude) = cos(lambda) sin(u) -
    // sin(lambda) cot(latitude).
    const double sin_low = std::sin(low);
    const double sin_high = std::sin(high);
    sums.chip += cos_lambda_ * sine_integral(range, turn, edge_.tangent()) -
                 sin_lambda_ * (sin_high - sin_low);
    sums.chip_torque += cos_lambda_ * torque -
                        sin_lambda_ / 2 * (sin_high - sin_low) * (sin_high + sin_low);
}

EdgeSums ForcePattern::at(double turn) const
{
    EdgeSums sums;
    for (int flute = 0; flute < flutes_; ++flute) {
        const double azimuth = turn + 2 * pi * flute / flutes_;
        for (const EdgeRange& range : edge_.engaged(azimuth)) {
            if (chip_ == ChipModel::Exact && range.to <= 1)
                add_range(range, azimuth, sums);
            else
                for_each_half_turn(
                    range, azimuth, edge_.tangent(),
                    [&](const EdgeRange& part) { add_range(part, azimuth, sums); });
        }
    }
    // The sums of a thin chip are differences of larger terms and may round to below 0. A
    // negative sum would look like a load that falls as the feed grows.
    sums.chip = std::max(sums.chip, 0.0);
    sums.chip_torque = std::max(sums.chip_torque, 0.0);
    return sums;
}

EdgeSums ForcePattern::mean() const
{
    const CuttingCoefficients one = cutting_coefficients(engagement_, chip_);
    return scaled({one.I5, one.I6, one.I7, one.I8}, flutes_);
}

// Between two neighbouring events the sums are smooth functions of the azimuth of the
// tip, except for square roots at the ends. The samples are therefore dense at the ends;
// the outermost are almost at the events.
void ForcePattern::sample()
{
    constexpr int nodes = 9;
    constexpr double inside =
        1e-10;  // distance of the outermost samples, share of the interval
    const double period = 2 * pi / flutes_;
    std::vector<double> ends{0, period};
    for (const double event : edge_.events())
        ends.push_back(event - period * std::floor(event / period));
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 1; k < ends.size(); ++k) {
        const double middle = (ends[k - 1] + ends[k]) / 2;
        const double half = (ends[k] - ends[k - 1]) / 2;
        if (!(half > inside))
            continue;
        std::vector<Sample> samples;
        for (int j = 0; j < nodes; ++j) {
            const double turn =
                middle - half * (1 - inside) * std::cos(pi * j / (nodes - 1));
            samples.push_back({turn, at(turn)});
        }
        samples_.push_back(std::move(samples));
    }
}

// The largest value in an interval with a single maximum, by golden-section search.
double ForcePattern::largest_between(const Measure& measure, double low,
                                     double high) const
{
    constexpr int sections = 17;  // to 3e-4 of the interval, where a maximum is flat
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double left = high - golden * (high - low);
    double right = low + golden * (high - low);
    double at_left = measure(at(left));
    double at_right = measure(at(right));
    for (int k = 0; k < sections; ++k) {
        if (at_left > at_right) {
            high = std::exchange(right, left);
            at_right = at_left;
            left = high - golden * (high - low);
            at_left = measure(at(left));
        } else {
            low = std::exchange(left, right);
            at_left = at_right;
            right = low + golden * (high - low);
            at_right = measure(at(right));
        }
    }
    return std::max(at_left, at_right);
}

double ForcePattern::largest(const Measure& measure) const
{
    // Only intervals whose best sample comes within this share of the best of all are
    // refined: a maximum between samples exceeds them by less.
    constexpr double share = 0.02;
    double highest = -std::numeric_limits<double>::infinity();
    for (const std::vector<Sample>& samples : samples_)
        for (const Sample& sample : samples)
            highest = std::max(highest, measure(sample.sums));
    const double worth = highest - share * std::abs(highest);
    double found = highest;
    for (const std::vector<Sample>& samples : samples_) {
        std::size_t best = 0;
        for (std::size_t k = 1; k < samples.size(); ++k)
            if (measure(samples[k].sums) > measure(samples[best].sums))
                best = k;
        if (!(measure(samples[best].sums) >= worth))
            continue;
        const double low = samples[best > 0 ? best - 1 : 0].turn;
        const double high = samples[std::min(best + 1, samples.size() - 1)].turn;
        found = std::max(found, largest_between(measure, low, high));
    }
    return found;
}

double ForcePattern::peak_factor() const
{
    const double mean_torque = mean().chip_torque;
    if (!(mean_torque > 0))
        return 1;
    return largest([](const EdgeSums& sums) { return sums.chip_torque; }) / mean_torque;
}

FeedBounds ForcePattern::direct_bounds(const LoadModel& model,
                                       const LoadLimits& limits) const
{
    constexpr double never = -std::numeric_limits<double>::infinity();
    // The least bound over a revolution is the largest negative bound.
    const auto least = [&](std::optional<double> FeedBounds::*bound,
                           const LoadLimits& limit) -> std::optional<double> {
        const double found = -largest([&](const EdgeSums& sums) {
            const std::optional<double> feed = feed_bounds(model, sums, limit).*bound;
            return feed ? -*feed : never;
        });
        return std::isfinite(found) ? std::optional{found} : std::nullopt;
    };
    FeedBounds bounds;
    if (limits.cutting_force_n)
        bounds.cutting_force =
            least(&FeedBounds::cutting_force, {limits.cutting_force_n, {}, {}});
    if (limits.thrust_n)
        bounds.thrust = least(&FeedBounds::thrust, {{}, limits.thrust_n, {}});
    if (limits.torque_n_m)
        bounds.torque = least(&FeedBounds::torque, {{}, {}, limits.torque_n_m});
    return bounds;
}

CuttingLoads ForcePattern::largest_loads(const LoadModel& model,
                                         double feed_per_tooth_mm) const
{
    const auto most = [&](double CuttingLoads::*load) {
        return largest([&](const EdgeSums& sums) {
            return cutting_loads(model, sums, feed_per_tooth_mm).*load;
        });
    };
    return {most(&CuttingLoads::cutting_force_n), most(&CuttingLoads::thrust_n),
            most(&CuttingLoads::torque_n_m)};
}

}  // namespace endmill
