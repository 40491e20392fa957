// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 13 and 14 of Kang & Suh: every candidate of the teapot's best poses, and the
// hulls from which those of A,B follow.
//
//   five-axis-setup-figure-13-14 OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "endmill/core/text.h"
#include "endmill/setup/detail/rectangle_fit.h"
#include "support/candidate_charts.h"
#include "support/candidate_tables.h"
#include "support/experiment.h"
#include "support/setup_cells.h"
#include "support/studied_part.h"

using namespace endmill;

namespace {

// The directions of the family's best pose in the mode `paper`.
DirectionSet directions_of(const StudiedPart& part, RotaryFamily family)
{
    const FittedPose fit = *unlimited_setup(part, family, "paper").least;
    return {fit.pose.tool_axis, nearest_directions(part, fit)};
}

// Family, mode, pose and objective of a chart, such as "C,A, mode paper, tool axis at
// 11.2°: F = 18988 deg²", where the angle is that with the part's z.
template <class Candidate>
std::string title_of(const std::string& family, const DirectionSet& set,
                     const Candidate& candidate)
{
    const double tilt = std::acos(std::min(1.0, set.tool_axis.z()));
    const double tenths = std::round(10 * Angle::radians(tilt).degrees()) / 10;
    return family + ", mode paper, tool axis at " + to_text(tenths) +
           "°: F = " + to_text(std::round(square_degrees(candidate.area()))) + " deg²";
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
        const std::span<const SectorCandidate> paper_sectors = all.first(paper_count);
        const SectorCandidate& sector =
            *std::ranges::min_element(paper_sectors, {}, &SectorCandidate::area);
        const RectangleCandidate rectangle = least_area(
            rectangle_candidates(ab.tool_axis, ab.directions, SetupMode::Paper));
        run.write("sectors.svg", sector_chart(title_of("C,A", ca, sector), ca, sector));
        run.write("rectangle.svg",
                  rectangle_chart(title_of("A,B", ab, rectangle), ab, rectangle));
        run.write("gnomonic-hull.svg", hull_chart("A,B, mode paper: hull of MD, gnomonic",
                                                  ab, ChartProjection::Gnomonic));
        run.write("orthographic-hull.svg",
                  hull_chart("A,B, mode corrected: hull of MD, orthographic", ab,
                             ChartProjection::Orthographic));
        run.write_result(candidate_summary(ca, sectors, paper_count, ab, rectangles));
    });
}
