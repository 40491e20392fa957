// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 2 of Jang, Kim and Jeong: the ball's offset used for another cutter leaves stock
// or gouges. Closed forms, and the removal by cutters on that path.
//
//   interference-figure-2 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <cmath>

#include "endmill/core/text.h"
#include "endmill/cutter/detail/ball_path_stock.h"
#include "interference/figure-2/offset_pictures.h"
#include "support/experiment.h"
#include "support/named_cells.h"

using namespace endmill;

namespace {

void add_cutter(Experiment& run, CsvTable& result, const Cutter& cutter)
{
    const int samples = static_cast<int>(run.number("samples"));
    const double valley = run.number("valley_radius_mm");
    const double width = cutter.flat_radius();
    for (const double degrees : run.numbers("slopes_deg")) {
        const Angle slope = Angle::degrees(degrees);
        const double sine = std::sin(slope.radians());
        const double cosine = std::cos(slope.radians());
        const auto on_plane = [&](ControlPoint equated) {
            return stock_on_plane(cutter, equated, slope, samples);
        };
        const auto in_valley = [&](ControlPoint equated) {
            return stock_in_valley(cutter, equated, slope, valley, samples);
        };
        const double left = on_plane(ControlPoint::Reference);
        result.add_row({cutter_word(cutter) + ", " + to_text(degrees) + " deg",
                        cutter_word(cutter), degrees, width * (1 - sine), left,
                        in_valley(ControlPoint::Reference), width * (sine + cosine - 1),
                        -on_plane(ControlPoint::Tip), -in_valley(ControlPoint::Tip),
                        word(left > 0)});
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-2", [](Experiment& run) {
        CsvTable result{{"row", "cutter", "slope_deg", "stock_mm", "stock_plane_mm",
                         "stock_valley_mm", "gouge_mm", "gouge_plane_mm",
                         "gouge_valley_mm", "leaves_stock"}};
        const double radius = run.number("radius_mm");
        std::vector<Cutter> cutters{Cutter::ball(radius)};
        for (const double corner : run.numbers("corner_radii_mm")) {
            add_cutter(run, result, {radius, corner});
            cutters.emplace_back(radius, corner);
        }
        run.write("figure-2.svg", offset_pictures(cutters));
        run.write_result(result);
    });
}
