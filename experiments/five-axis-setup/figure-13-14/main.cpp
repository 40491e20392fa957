// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 13 and 14 of Kang & Suh: every candidate of the teapot's best poses, and the
// hulls from which those of A,B follow.
//
//   five-axis-setup-figure-13-14 OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include <span>

#include "endmill/setup/detail/rectangle_fit.h"
#include "support/candidate_charts.h"
#include "support/candidate_tables.h"
#include "support/experiment.h"
#include "support/studied_part.h"

using namespace endmill;

namespace {

// The directions of the family's best pose in the mode `corrected`.
DirectionSet directions_of(const StudiedPart& part, RotaryFamily family)
{
    const FittedPose fit = *unlimited_setup(part, family, "corrected").least;
    return {fit.pose.tool_axis, nearest_directions(part, fit)};
}

}  // namespace

int main(int argc, char** argv)
{
    const std::string name = "five-axis-setup/figure-13-14";
    return run_experiment(argc, argv, name, [](Experiment& run) {
        const StudiedPart part =
            studied_part(run.text("mesh"), run.text("grid"),
                         Angle::degrees(run.number("incidence_deg")));
        const DirectionSet ca = directions_of(part, RotaryFamily::CA);
        const DirectionSet ab = directions_of(part, RotaryFamily::AB);
        const auto sectors =
            sector_candidates(ca.tool_axis, ca.directions, SetupMode::Corrected);
        const std::size_t paper_count =
            sector_candidates(ca.tool_axis, ca.directions, SetupMode::Paper).size();
        const auto rectangles =
            rectangle_candidates(ab.tool_axis, ab.directions, SetupMode::Corrected);
        const std::span<const SectorCandidate> all{sectors};
        run.write("sectors.csv", sector_table(all.first(paper_count)).text());
        run.write("wide-sectors.csv", sector_table(all.subspan(paper_count)).text());
        run.write("rectangles.csv", rectangle_table(ab.tool_axis, rectangles).text());
        run.write("sectors.svg",
                  sector_chart("Least double sector", ca, least_area(sectors)));
        run.write("rectangle.svg",
                  rectangle_chart("Least rectangle", ab, least_area(rectangles)));
        run.write("gnomonic-hull.svg",
                  hull_chart("Gnomonic hull", ab, ChartProjection::Gnomonic));
        run.write("orthographic-hull.svg",
                  hull_chart("Orthographic hull", ab, ChartProjection::Orthographic));
        run.write_result(candidate_summary(ca, sectors, paper_count, ab, rectangles));
    });
}
