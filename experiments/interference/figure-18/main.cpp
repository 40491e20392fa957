// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 18 of Jang, Kim and Jeong: the offset after trimming; and the distance of the
// ball's centre from the part along the result, which the paper does not print.
//
//   interference-figure-18 OUTPUT_FOLDER
//
// Deterministic, under 60 s. Columns and verdicts: README.md beside this.

#include <cstdint>

#include "endmill/core/text.h"
#include "endmill/drop_cutter/detail/plane_gaps.h"
#include "endmill/figures/section_svg.h"
#include "support/experiment.h"
#include "support/offset_sections.h"

using namespace endmill;

namespace {

// Adds the smallest distance of the ball's centre from the part, and the number of planes
// in which it is too small.
void add_distance(Experiment& run, CsvTable& result, const SectionPlan& plan,
                  const std::string& label, const std::vector<PlaneLines>& planes)
{
    const std::vector part{dataset_surface(plan.surface)};
    const PlaneGaps gaps =
        plane_gaps(part, plan.cutter, planes, run.number("allowed_gouge_mm"));
    result.add_row({"at " + to_text(plan.direction_deg) + " deg, " + label,
                    static_cast<std::int64_t>(gaps.points),
                    plan.cutter.radius() + gaps.least,
                    static_cast<std::int64_t>(gaps.gouging_planes)});
}

std::string drawing(const std::vector<PlaneLines>& planes, const std::string& title)
{
    FigureOptions figure;
    figure.title = title;
    figure.azimuth = Angle::degrees(70);
    figure.elevation = Angle::degrees(25);
    figure.captions = {"every second of " + std::to_string(planes.size()) + " planes"};
    return curves_svg(every_nth(planes, 2), figure);
}

// The offset without contacts on the border, as in the paper.
void add_paper(Experiment& run, CsvTable& result, const SectionPlan& plan)
{
    const OffsetSections paper = offset_sections(plan);
    const auto before = untrimmed_lines(paper.planes, paper.sections);
    const auto after = trimmed_lines(paper, "3", FoldDetection::Guarded);
    add_distance(run, result, plan, "untrimmed", before);
    add_distance(run, result, plan, "3 literal",
                 trimmed_lines(paper, "3", FoldDetection::Literal));
    add_distance(run, result, plan, "3 guarded", after);
    for (const char* method : {"3r", "envelope"})
        add_distance(run, result, plan, method,
                     trimmed_lines(paper, method, FoldDetection::Guarded));
    if (plan.direction_deg == 0) {
        run.write("before.svg", drawing(before, "The sections of the offset"));
        run.write("after.svg", drawing(after, "As figure 18: after method 3"));
    }
}

void add_with_border(Experiment& run, CsvTable& result, SectionPlan plan)
{
    plan.boundary = BoundaryContact::Contact;
    for (const double lines : run.numbers("grids_with_border")) {
        plan.grid_lines = static_cast<int>(lines);
        const OffsetSections sections = offset_sections(plan);
        for (const std::string method : {"envelope", "winding"})
            add_distance(run, result, plan,
                         method + ", border touched, grid " + to_text(lines),
                         trimmed_lines(sections, method, FoldDetection::Guarded));
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-18", [](Experiment& run) {
        CsvTable result{{"row", "points", "least_distance_mm", "gouging_planes"}};
        for (const double feed : run.numbers("feeds_deg")) {
            const SectionPlan plan{.surface = run.text("surface"),
                                   .cutter = Cutter::ball(run.number("radius_mm")),
                                   .direction_deg = feed};
            add_paper(run, result, plan);
            add_with_border(run, result, plan);
        }
        run.write_result(result);
    });
}
