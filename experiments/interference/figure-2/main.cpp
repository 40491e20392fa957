// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 2 of Jang, Kim and Jeong: the ball's offset used for another cutter leaves stock
// or gouges. Closed forms, and the removal by cutters on that path.
//
//   interference-figure-2 OUTPUT_FOLDER
//
// Deterministic, under 5 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <limits>

#include "endmill/core/angle.h"
#include "endmill/core/text.h"
#include "endmill/cutter/cutter.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

// The point of the cutter that follows that of the ball.
enum class Equated { References, Tips };

// Height of the cutter's tip relative to the ball's centre.
double tip_height(const Cutter& cutter, Equated equated)
{
    return equated == Equated::References ? -cutter.corner_radius() : -cutter.radius();
}

// A profile along which the ball's centre moved, in the direction of a slope.
struct Slope {
    double sine;
    double cosine;
};

// Largest extent of the cutter's body from the ball's centre against the normal of
// `slope`, in mm, over `samples` of its lower outline.
double reach(const Cutter& cutter, Equated equated, const Slope& slope, int samples)
{
    double farthest = -std::numeric_limits<double>::infinity();
    for (int k = 0; k <= samples; ++k) {
        const double across = cutter.radius() * (2.0 * k / samples - 1);
        const double z = tip_height(cutter, equated) + cutter.profile(std::abs(across));
        farthest = std::max(farthest, across * slope.sine - z * slope.cosine);
    }
    return farthest;
}

// Remaining stock (positive) or gouge (negative) on a plane of `slope`: the lowest
// outline over all positions of the cutter on the ball's path, above one point of the
// plane.
double left_on_plane(const Cutter& cutter, Equated equated, const Slope& slope,
                     int samples)
{
    const double R = cutter.radius();
    const double tangent = slope.sine / slope.cosine;
    double lowest = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= samples; ++k) {
        const double across = R * (2.0 * k / samples - 1);
        const double centre = across * tangent + R / slope.cosine;
        lowest = std::min(lowest, centre + tip_height(cutter, equated) +
                                      cutter.profile(std::abs(across)));
    }
    return lowest * slope.cosine;
}

// The same in a round valley at equal slopes. The ball's centre moves on a circle of
// radius `valley` - R; the extent of the body is measured along the normal.
double left_in_valley(const Cutter& cutter, Equated equated, const Slope& slope,
                      double valley, int samples)
{
    const double path = valley - cutter.radius();
    double farthest = -std::numeric_limits<double>::infinity();
    for (int k = 0; k <= samples; ++k) {
        const Angle at = Angle::degrees(180.0 * k / samples - 90);
        const double centre = path * (std::sin(at.radians()) * slope.sine +
                                      std::cos(at.radians()) * slope.cosine);
        farthest = std::max(farthest, centre);
    }
    return valley - farthest - reach(cutter, equated, slope, samples);
}

void add_cutter(Experiment& run, CsvTable& result, const Cutter& cutter)
{
    const int samples = static_cast<int>(run.number("samples"));
    const double valley = run.number("valley_radius_mm");
    const double width = cutter.flat_radius();
    for (const double degrees : run.numbers("slopes_deg")) {
        const double angle = Angle::degrees(degrees).radians();
        const Slope slope{std::sin(angle), std::cos(angle)};
        const double left = left_on_plane(cutter, Equated::References, slope, samples);
        result.add_row(
            {cutter_word(cutter) + ", " + to_text(degrees) + " deg", cutter_word(cutter),
             degrees, width * (1 - slope.sine), left,
             left_in_valley(cutter, Equated::References, slope, valley, samples),
             width * (slope.sine + slope.cosine - 1),
             -left_on_plane(cutter, Equated::Tips, slope, samples),
             -left_in_valley(cutter, Equated::Tips, slope, valley, samples),
             left > 0 ? "yes" : "no"});
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-2", [](Experiment& run) {
        CsvTable result{{"row", "cutter", "slope_deg", "stock_mm", "stock_plane_mm",
                         "stock_valley_mm", "gouge_mm", "gouge_plane_mm",
                         "gouge_valley_mm", "leaves_stock"}};
        for (const double corner : run.numbers("corner_radii_mm"))
            add_cutter(run, result, {run.number("radius_mm"), corner});
        run.write_result(result);
    });
}
