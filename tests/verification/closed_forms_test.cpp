// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/closed_forms.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/cutter/cutter.h"

namespace endmill {
namespace {

constexpr double R = 5;

const ClosedForm& form_named(const std::string& name)
{
    static const std::vector<ClosedForm> forms = closed_forms();
    const auto found = std::ranges::find(forms, name, &ClosedForm::name);
    if (found == forms.end())
        throw std::out_of_range{name};
    return *found;
}

// Height of a cutter's lower side over its tip at the distance d from the axis.
double ball_height(double d)
{
    return d < R ? R - std::sqrt(R * R - d * d) : std::numeric_limits<double>::infinity();
}

double flat_height(double d)
{
    return d < R ? 0 : std::numeric_limits<double>::infinity();
}

double bull_height(double d)
{
    const double beyond = std::max(0.0, d - 3);
    return d < R ? 2 - std::sqrt(4 - beyond * beyond)
                 : std::numeric_limits<double>::infinity();
}

// Volume that tips from (-length / 2, 0, from_z) to (length / 2, 0, to_z) remove below z = 0, by
// the midpoint rule over columns and the lowest of many positions. Within |x| <= 20 mm.
double swept_volume(double (*height)(double), double length, double from_z, double to_z)
{
    const double cell = 0.05;
    const int positions = length > 0 ? static_cast<int>(length / 0.02) : 1;
    double volume = 0;
    for (double x = -20 + cell / 2; x < 20; x += cell)
        for (double y = cell / 2; y < R; y += cell) {
            double lowest = 0;
            for (int k = 0; k <= positions; ++k) {
                const double t = static_cast<double>(k) / positions;
                const double axis = (t - 0.5) * length;
                if (std::abs(x - axis) < R)
                    lowest = std::min(lowest, std::lerp(from_z, to_z, t) +
                                                  height(std::hypot(x - axis, y)));
            }
            volume -= 2 * cell * cell * lowest;  // both halves
        }
    return volume;
}

TEST(ClosedForms, OfVolumesAreSumsOfColumns)
{
    const auto expect = [](const std::string& name, double volume) {
        const double exact = form_named(name + ": removed").exact;
        EXPECT_NEAR(volume / exact, 1, 5e-3) << name;
    };
    expect("ball inside, 1 deep", swept_volume(ball_height, 20, -1, -1));
    expect("ball plunge, 1 deep", swept_volume(ball_height, 0, -1, -1));
    expect("flat plunge, 2 deep", swept_volume(flat_height, 0, -2, -2));
    expect("bull plunge, 1 deep", swept_volume(bull_height, 0, -1, -1));
    expect("ball ramp, 7 to 11 deep", swept_volume(ball_height, 10, -7, -11));
    expect("ball ramp, 0 to 1 deep", swept_volume(ball_height, 10, 0, -1));
    expect("flat ramp, 2 to 6 deep", swept_volume(flat_height, 10, -2, -6));
}

// The highest point and the mean of the lower of two balls between their axes, by sampling.
TEST(ClosedForms, OfPassesOnAPlaneAreThoseOfSamples)
{
    for (const double apart : {2.0, 3.0}) {
        double highest = 0;
        double mean = 0;
        constexpr int samples = 100000;
        for (int k = 0; k < samples; ++k) {
            const double x = apart * (k + 0.5) / samples;
            const double left = std::min(ball_height(x), ball_height(apart - x));
            highest = std::max(highest, left);
            mean += left / samples;
        }
        const std::string name = "passes " + std::to_string(int(apart)) + " apart: ";
        EXPECT_NEAR(form_named(name + "scallop").exact, highest, 1e-4);
        EXPECT_NEAR(form_named(name + "mean left").exact, mean, 1e-9);
    }
}

// Along each radius of the cylinder, the distance from its surface to the nearer of two balls.
TEST(ClosedForms, OfPassesAlongACylinderAreThoseOfSamples)
{
    const double rho = 20;
    const auto sampled = [&](double side, double step) {
        const double centre = rho + side * R;
        double highest = 0;
        constexpr int samples = 20000;
        for (int k = 0; k <= samples; ++k) {
            const double angle = step * k / samples;
            double left = std::numeric_limits<double>::infinity();
            for (const double off : {angle, step - angle}) {
                // The ball's boundary on this radius, the intersection near the surface.
                const double across = centre * std::sin(off);
                const double along =
                    centre * std::cos(off) - side * std::sqrt(R * R - across * across);
                left = std::min(left, side * (along - rho));
            }
            highest = std::max(highest, left);
        }
        return highest;
    };
    const double degree = std::numbers::pi / 180;
    EXPECT_NEAR(form_named("a cylinder outside: scallop").exact, sampled(1, 4 * degree),
                1e-8);
    EXPECT_NEAR(form_named("a cylinder inside: scallop").exact, sampled(-1, 6 * degree),
                1e-8);
}

TEST(ClosedForms, AreMeasuredWithinTheirBoundsAtACoarsePitch)
{
    for (const char* name : {"passes 3 apart: scallop", "lowered on 30 deg: gouge",
                             "flat plunge, 2 deep: removed"}) {
        const ClosedForm& form = form_named(name);
        EXPECT_EQ(bound_holds(form, form.measure(0.4, 0)), Answer::Yes) << name;
    }
}

TEST(BoundHolds, JudgesTheSideAndTheSizeOfTheError)
{
    ClosedForm form{"", "mm", 2, true, {}, false};
    EXPECT_EQ(bound_holds(form, {1.9, 0.2}), Answer::Yes);
    EXPECT_EQ(bound_holds(form, {1.9, 0.05}), Answer::No);
    EXPECT_EQ(bound_holds(form, {2.1, 0.2}), Answer::No);
    form.is_from_below = false;
    EXPECT_EQ(bound_holds(form, {2.1, 0.2}), Answer::Yes);
    EXPECT_EQ(bound_holds(form, {2.1, {}}), Answer::Undecided);
}

}  // namespace
}  // namespace endmill
