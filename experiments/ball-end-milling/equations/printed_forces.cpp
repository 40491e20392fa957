// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/equations/printed_forces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "endmill/process/cutting_force.h"
#include "endmill/process/detail/engaged_region.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int rings = 4000;       // latitudes of a sum over the ball
constexpr int turn_steps = 3600;  // azimuths of a mean over a turn
constexpr int range_steps = 200;  // azimuths of a sum over a range

using Coefficients = std::array<double, 8>;

Coefficients listed(const CuttingCoefficients& c)
{
    return {c.I1, c.I2, c.I3, c.I4, c.I5, c.I6, c.I7, c.I8};
}

// A range of azimuths on one side of X = 0, where xi is constant.
struct SidedRange {
    double from;
    double to;
    double xi;
};

// Calls `visit(latitude, step, range)` for each engaged range of each ring of the ball.
template <typename Visit>
void for_each_range(const BallEngagement& engagement, const Visit& visit)
{
    const double step = pi / 2 / rings;
    for (int i = 0; i < rings; ++i) {
        const double latitude = (i + 0.5) * step;
        for (const auto& [from, to] : engaged_ranges(engagement, latitude))
            for (const auto& [low, high, xi] :
                 {SidedRange{-pi, 0, -1}, {0, pi, 1}, {pi, 2 * pi, -1}})
                if (std::max(from, low) < std::min(to, high))
                    visit(latitude, step,
                          SidedRange{std::max(from, low), std::min(to, high), xi});
    }
}

// Eq. (2) as printed.
Coefficients printed_coefficients(const BallEngagement& engagement)
{
    Coefficients sums{};
    for_each_range(engagement, [&](double latitude, double step, const SidedRange& r) {
        const double s = std::sin(latitude) * step;
        const double s2 = std::sin(latitude) * s;
        const auto g = [&](auto f) { return r.xi * (f(r.to) - f(r.from)); };
        const double g1 = g([](double t) { return std::sin(t) * std::sin(t) / 2; });
        const double g2 = g([](double t) { return t / 2 - std::sin(2 * t) / 4; });
        const double g3 = g([](double t) { return -std::cos(t); });
        const double sines = std::sin(r.to) - std::sin(r.from);
        const double angle = r.to - r.from;
        const Coefficients terms{2 * g1 * s, 2 * g2 * s, sines * s, -sines * s,
                                 2 * g3 * s, angle * s,  g3 * s2,   angle * s2};
        for (std::size_t k = 0; k < terms.size(); ++k)
            sums[k] += terms[k];
    });
    const double phi = shank_angle(engagement);
    const double lc = engagement.depth_ratio - 1;
    const double ph = engagement.pick_feed_ratio * std::cos(engagement.mu);
    const Coefficients shank{std::sin(phi) * std::sin(phi),
                             phi - std::sin(2 * phi) / 2,
                             std::sin(phi),
                             ph,
                             ph,
                             phi,
                             ph,
                             phi};
    for (std::size_t k = 0; k < sums.size(); ++k)
        sums[k] = (sums[k] + lc * shank[k]) / (k < 2 ? 4 * pi : 2 * pi);
    return sums;
}

// I6 of the ball with xi in place of zeta, as appendix B prints C6.
double i6_with_xi(const BallEngagement& engagement)
{
    double sum = 0;
    for_each_range(engagement, [&](double latitude, double step, const SidedRange& r) {
        sum += r.xi * (r.to - r.from) * std::sin(latitude) * step;
    });
    return (sum + (engagement.depth_ratio - 1) * shank_angle(engagement)) / (2 * pi);
}

double size(const CuttingForce& force)
{
    return std::hypot(force.x_n, force.y_n, force.z_n);
}

double distance(const CuttingForce& one, const CuttingForce& other)
{
    return size({one.x_n - other.x_n, one.y_n - other.y_n, one.z_n - other.z_n, 0});
}

// The chip term of eq. (1) as printed.
CuttingForce printed_force(const CuttingCoefficients& c, const MillingJob& job,
                           double feed_mm)
{
    const CuttingMaterial& m = job.material;
    const double unit =
        job.tool.flutes * job.tool.radius * m.specific_resistance_n_per_mm2 * feed_mm;
    return {unit * (c.I1 + m.r1 * c.I2), unit * (m.r1 * c.I1 - c.I2), unit * m.r3 * c.I5,
            unit * job.tool.radius * c.I7 / 1000};
}

// The chip forces on the ball when milling down, from the element of the edge of appendix
// A: milling down is milling up with the azimuth pi - theta, seen in a frame that is
// mirrored in Y.
CuttingForce mirrored_force(const BallEngagement& engagement, const MillingJob& job,
                            double feed_mm)
{
    double x = 0;
    double y = 0;
    double z = 0;
    const CuttingMaterial& m = job.material;
    for_each_range(engagement, [&](double latitude, double step, const SidedRange& r) {
        const double width = (r.to - r.from) / range_steps;
        const double part = std::sin(latitude) * step * width / (2 * pi);
        for (int i = 0; i < range_steps; ++i) {
            const double theta = pi - (r.from + (i + 0.5) * width);
            const double chip = std::abs(std::sin(theta));
            x += part * chip * (std::cos(theta) + m.r1 * std::sin(theta));
            y -= part * chip * (m.r1 * std::cos(theta) - std::sin(theta));
            z += part * chip * m.r3;
        }
    });
    const double unit =
        job.tool.flutes * job.tool.radius * m.specific_resistance_n_per_mm2 * feed_mm;
    return {unit * x, unit * y, unit * z, 0};
}

// The mean of the forces in time.
CuttingForce mean_of_turn(const BallEngagement& engagement, const MillingJob& job,
                          double feed_mm)
{
    std::vector<double> turns;
    turns.reserve(turn_steps);
    for (int i = 0; i < turn_steps; ++i)
        turns.push_back(2 * pi * i / turn_steps);
    CuttingForce mean{};
    for (const CuttingForce& force : force_profile({.engagement = engagement,
                                     .material = job.material,
                                     .tool = job.tool,
                                     .feed_per_tooth_mm = feed_mm},
                                                   turns)) {
        mean.x_n += force.x_n / turn_steps;
        mean.y_n += force.y_n / turn_steps;
        mean.z_n += force.z_n / turn_steps;
    }
    return mean;
}

// The part of `engagement` below the shank.
BallEngagement ball_of(BallEngagement engagement)
{
    engagement.depth_ratio = std::min(engagement.depth_ratio, 1.0);
    return engagement;
}

}  // namespace

void add_force_equations(CsvTable& result, const std::vector<BallEngagement>& engagements,
                         const MillingJob& job, double feed_mm)
{
    const CuttingMaterial& m = job.material;
    const double edge_mm = m.edge_thickness_mm;
    CuttingMaterial chip_only = m;
    chip_only.edge_thickness_mm = 0;
    MillingJob sharp = job;
    sharp.material = chip_only;
    Coefficients eq2{};
    double eq1 = 0;
    double eq3 = 0;
    double means = 0;
    double down = 0;
    double with_xi = 0;
    double axial = 0;
    for (const BallEngagement& engagement : engagements) {
        const CuttingCoefficients c = cutting_coefficients(engagement);
        const Coefficients exact = listed(c);
        const Coefficients printed = printed_coefficients(engagement);
        for (std::size_t k = 0; k < exact.size(); ++k)
            eq2[k] = std::max(eq2[k], std::abs(printed[k] - exact[k]));
        const CuttingForce chip =
            mean_force(c, chip_only, job.tool, feed_mm, Milling::Down);
        eq1 = std::max(eq1, distance(printed_force(c, job, feed_mm), chip) / size(chip));
        const double torque = feed_mm * c.I7 + edge_mm * c.I8;
        eq3 = std::max(eq3, std::abs(torque / (feed_mm * c.I4 + edge_mm * c.I6) -
                                     torque / (feed_mm * c.I5 + edge_mm * c.I6)));
        const CuttingForce whole = mean_force(c, m, job.tool, feed_mm, Milling::Down);
        means = std::max(
            means, distance(mean_of_turn(engagement, job, feed_mm), whole) / size(whole));
        const CuttingForce ball = mean_force(cutting_coefficients(ball_of(engagement)),
                                             chip_only, job.tool, feed_mm, Milling::Down);
        down = std::max(down, distance(mirrored_force(engagement, sharp, feed_mm), ball) /
                                  size(ball));
        with_xi = std::max(with_xi, std::abs(i6_with_xi(engagement) - c.I6));
        axial = std::max(axial, std::abs(c.I3 - c.I5));
    }
    add_named(result, "eq. (1)", {{"deviation", eq1}});
    for (std::size_t k = 0; k < eq2.size(); ++k)
        add_named(result, "eq. (2), I" + std::to_string(k + 1), {{"deviation", eq2[k]}});
    add_named(result, "eq. (3)", {{"deviation", eq3}});
    add_named(result, "appendix A, means", {{"deviation", means}});
    add_named(result, "appendix A, down milling", {{"deviation", down}});
    add_named(result, "appendix B, I6 with xi", {{"deviation", with_xi}});
    add_named(result, "appendix B, end", {{"deviation", axial}});
}

void add_printed_limits(CsvTable& result, const std::vector<BallEngagement>& engagements,
                        const MillingJob& job, double feed_mm)
{
    const CuttingMaterial& m = job.material;
    const double unit_n =
        job.tool.flutes * job.tool.radius * m.specific_resistance_n_per_mm2;
    double thrust = 0;
    double torque = 0;
    double end_torque = 0;
    double end_edge = 0;
    for (const BallEngagement& engagement : engagements) {
        const CuttingCoefficients c = cutting_coefficients(engagement);
        const CuttingForce mean = mean_force(c, m, job.tool, feed_mm, Milling::Up);
        const double printed_n =
            unit_n * (feed_mm * m.r3 * c.I5 + m.edge_thickness_mm * m.r4 * c.I6);
        const double printed_n_m = unit_n * job.tool.radius *
                                   (feed_mm * c.I7 + m.edge_thickness_mm * c.I8) / 1000;
        thrust = std::max(thrust, std::abs(printed_n / mean.z_n - 1));
        torque = std::max(torque, std::abs(printed_n_m / mean.torque_n_m - 1));
        end_torque = std::max(end_torque, std::abs(c.I5 - c.I7));
        end_edge = std::max({end_edge, std::abs(c.I4 - c.I3), std::abs(c.I7 - c.I6)});
    }
    add_named(result, "eq. (16)", {{"deviation", thrust}});
    add_named(result, "eq. (17)", {{"deviation", torque}});
    add_named(result, "appendix B, end, torque", {{"deviation", end_torque}});
    add_named(result, "appendix B, end, edge", {{"deviation", end_edge}});
}

}  // namespace endmill
