// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/closed_forms.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "endmill/core/text.h"
#include "endmill/verification/detail/closed_form_parts.h"
#include "endmill/verification/verification.h"

namespace endmill {
namespace {

using std::numbers::pi;

constexpr double R = 5;  // radius of all cutters, mm

// Slack for the rounding of sums of a million terms, relative to the value and at least
// absolute.
constexpr double sum_rounding = 1e-9;

// Measures the deviation of `part` after `path`. The limits control how far rays are
// refined: until the bound decides the verdict for them.
Deviation left_of(const Part& part, const ToolPath& path, double gouge, double scallop,
                  std::pair<double, int> pitch_and_refine)
{
    DeviationOptions options;
    options.limits = {gouge, scallop};
    options.pitch = pitch_and_refine.first;
    options.max_refine = pitch_and_refine.second;
    return deviation_in_block(part, path, Cutter::ball(R), options);
}

// Gouge limit, in mm, of a case that has no gouge.
constexpr double no_gouge = 0.01;

ClosedForm highest_rest(std::string name, double exact, const Part& part,
                        const ToolPath& path)
{
    const auto measure = [=](double pitch, int max_refine) -> MeasuredValue {
        const Deviation left = left_of(part, path, no_gouge, exact, {pitch, max_refine});
        return {left.max_scallop_mm, left.scallop_bound_mm};
    };
    return {std::move(name), "mm", exact, true, measure, true};
}

// Height of the cusp between two balls that touch a plane `apart` mm from each other.
double plane_scallop(double apart)
{
    return R - std::sqrt(R * R - apart * apart / 4);
}

// Mean height of the material between the same two balls.
double plane_mean(double apart)
{
    const double half = apart / 2;
    return (apart * R - half * std::sqrt(R * R - half * half) -
            R * R * std::asin(half / R)) /
           apart;
}

void add_planes(std::vector<ClosedForm>& forms)
{
    const Part part = plane_part(20 * Vec3::UnitX(), 12 * Vec3::UnitY());
    for (const double apart : {2.0, 3.0}) {
        const ToolPath path = level_passes(apart, {});
        const std::string passes = "passes " + to_text(apart) + " apart: ";
        forms.push_back(
            highest_rest(passes + "scallop", plane_scallop(apart), part, path));
        const auto mean = [=](double pitch, int) -> MeasuredValue {
            return {left_of(part, path, no_gouge, 1, {pitch, 0}).mean_scallop_mm, {}};
        };
        forms.push_back(
            {passes + "mean left", "mm", plane_mean(apart), true, mean, false});
    }
    forms.push_back(highest_rest("a pass left out: scallop", plane_scallop(3), part,
                                 level_passes(1.5, 3)));
}

// Height of the cusp on a cylinder of radius `rho` between two balls at the angle `step`.
// \param side +1: the balls are outside, -1: inside.
// Source: docs/methods/removal.md, section 4.
double cylinder_scallop(double rho, double side, double step)
{
    const double centre = rho + side * R;
    const double across = centre * std::sin(step / 2);
    const double cusp =
        centre * std::cos(step / 2) - side * std::sqrt(R * R - across * across);
    return side * (cusp - rho);
}

void add_cylinders(std::vector<ClosedForm>& forms)
{
    const double rho = 20;
    for (const auto& [name, side, degrees] :
         {std::tuple{"outside", 1.0, 4.0}, std::tuple{"inside", -1.0, 6.0}}) {
        const double step = degrees * pi / 180;
        const double from = side > 0 ? 0.3 : -2.5;
        forms.push_back(highest_rest("a cylinder " + std::string{name} + ": scallop",
                                     cylinder_scallop(rho, side, step),
                                     cylinder_part(rho, {from, from + 2}),
                                     passes_along_cylinder(rho + side * R, from, step)));
    }
}

void add_slopes(std::vector<ClosedForm>& forms)
{
    const double lowered = 0.2;
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        const double slope = degrees * pi / 180;
        const Vec3 up{std::cos(slope), 0, std::sin(slope)};
        const Part part = plane_part(6 * up, 6 * Vec3::UnitY());
        const ToolPath path = lowered_path(slope, lowered);
        const double exact = lowered * std::cos(slope);
        const auto measure = [=](double pitch, int max_refine) -> MeasuredValue {
            const Deviation left = left_of(part, path, exact, 1, {pitch, max_refine});
            return {left.max_gouge_mm, left.gouge_bound_mm};
        };
        forms.push_back({"lowered on " + to_text(degrees) + " deg: gouge", "mm", exact,
                         true, measure, true});
    }
}

// A straight cut into a block of 40 by 24 mm with its top at z = 0. Points are tips.
struct VolumeCase {
    std::string name;
    Cutter cutter;
    Vec3 from;
    Vec3 to;
    double exact;  // mm^3
    double wall;   // area of the vertical walls of the cut, mm^2
};

ClosedForm volume_form(const VolumeCase& one)
{
    const auto measure = [one](double pitch, int) -> MeasuredValue {
        HeightStock stock = block_stock({{-20, -12, -20}, {20, 12, 0}}, pitch);
        const double rims = 10;  // length of the rims, mm
        return {remove_along(stock, tip_path({one.from, one.to}), one.cutter).total,
                pitch * one.wall / 2 + pitch * pitch * rims};
    };
    return {one.name + ": removed", "mm^3", one.exact, false, measure, false};
}

void add_volumes(std::vector<ClosedForm>& forms)
{
    const Cutter ball = Cutter::ball(R);
    const Cutter flat = Cutter::flat(R);
    // Not at the centre of a cell, so that errors do not cancel by symmetry.
    const double x = 0.0123;
    const double y = 0.0217;
    const double section = R * R * std::acos(1 - 1 / R) - (R - 1) * std::sqrt(2 * R - 1);
    const double cap = pi * (3 * R - 1) / 3;
    const VolumeCase cases[] = {
        {"ball through, 1 deep", ball, {-40, y, -1}, {40, y, -1}, 40 * section, 0},
        {"ball inside, 1 deep", ball, {-10, y, -1}, {10, y, -1}, 20 * section + cap, 0},
        {"ball plunge, 1 deep", ball, {x, y, 30}, {x, y, -1}, cap, 0},
        {"flat plunge, 2 deep",
         flat,
         {x, y, 30},
         {x, y, -2},
         pi * R * R * 2,
         2 * pi * R * 2},
        {"bull plunge, 1 deep", {R, 2}, {x, y, 30}, {x, y, -1}, 56.6645449646, 0},
        {"ball ramp, 7 to 11 deep", ball, {-5, y, -7}, {5, y, -11}, 1398.908508070, 200},
        {"ball ramp, 0 to 1 deep", ball, {-5, y, 0}, {5, y, -1}, 24.8038806070, 0},
        {"flat ramp, 2 to 6 deep",
         flat,
         {-5, y, -2},
         {5, y, -6},
         R * 10 * 8 + pi * R * R * 6,
         200},
    };
    for (const VolumeCase& one : cases)
        forms.push_back(volume_form(one));
}

}  // namespace

std::vector<ClosedForm> closed_forms()
{
    std::vector<ClosedForm> forms;
    add_planes(forms);
    add_cylinders(forms);
    add_slopes(forms);
    add_volumes(forms);
    return forms;
}

Answer bound_holds(const ClosedForm& form, const MeasuredValue& measured)
{
    if (!measured.bound)
        return Answer::Undecided;
    const double slack = sum_rounding * std::max(1.0, std::abs(form.exact));
    const double missed = form.exact - measured.value;
    const double least = form.is_from_below ? 0 : -*measured.bound;
    return answer_of(missed >= least - slack && missed <= *measured.bound + slack);
}

}  // namespace endmill
