// SPDX-License-Identifier: GPL-3.0-or-later
// Figure A.1 of Park & Maeng: the frame of the force sums, an element of the edge in it,
// and the directions of its forces, in down and up milling.
//
//   ball-end-milling-figure-a-1 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include "ball-end-milling/figure-a-1/tables.h"
#include "endmill/core/angle.h"
#include "support/experiment.h"

using namespace endmill;

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "ball-end-milling/figure-a-1", [](Experiment& run) {
        const EdgeElement element{
            {0, 0, run.number("pick_feed_ratio"), run.number("depth_ratio")},
            Angle::degrees(run.number("latitude_deg")).radians(),
            Angle::degrees(run.number("azimuth_deg")).radians()};
        const double radius = run.number("radius_mm");
        CsvTable result{{"row", "x", "y", "z", "along_motion", "outwards", "from_deg",
                         "to_deg", "at_deg"}};
        for (const auto& [name, milling] :
             {std::pair{"down", Milling::Down}, {"up", Milling::Up}}) {
            const BallFrame frame{milling, radius};
            add_frame_rows(result, name, element, frame);
            run.write(std::string{name} + ".svg",
                      force_frame_svg(element, frame,
                                      std::string{"As figure A.1: milling "} + name));
        }
        run.write_result(result);
    });
}
