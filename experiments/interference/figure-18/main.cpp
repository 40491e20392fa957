// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 18 of Jang, Kim and Jeong: the offset after trimming; and the distance of the
// ball's centre from the part along the result, which the paper does not print.
//
//   interference-figure-18 OUTPUT_FOLDER
//
// Deterministic, under 60 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <cstdint>

#include "endmill/core/text.h"
#include "endmill/drop_cutter/detail/plane_gaps.h"
#include "endmill/figures/section_svg.h"
#include "endmill/trimming/detail/wrong_curves.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/offset_sections.h"
#include "support/printed_search.h"
#include "support/timed_trimming.h"

using namespace endmill;

namespace {

// Number of planes in which a line crosses itself.
std::size_t twisted_planes(const DrivePlanes& planes,
                           const std::vector<PlaneLines>& lines)
{
    std::size_t count = 0;
    for (const PlaneLines& plane : lines) {
        std::vector<TrimmingTrial> curves;
        for (const std::vector<Vec3>& line : plane) {
            if (line.size() < 2)
                continue;
            TrimmingTrial& curve = curves.emplace_back();
            for (const Vec3& point : line)
                curve.curve.points.emplace_back(planes.frame.along(point), point.z());
        }
        count += crossing_curves(curves) > 0 ? 1 : 0;
    }
    return count;
}

// The sections of a plan, and the table that their results are added to.
struct Study {
    Experiment& run;
    CsvTable& result;
    SectionPlan plan;
    OffsetSections sections;
};

// Adds the smallest distance of the ball's centre from the part, the largest gouge, and
// the numbers of planes that gouge and that have a twist.
// \return the number of planes that gouge.
std::size_t add_distance(const Study& study, const std::string& label,
                         const std::vector<PlaneLines>& planes)
{
    const SectionPlan& plan = study.plan;
    const std::vector part{dataset_surface(plan.surface)};
    const PlaneGaps gaps =
        plane_gaps(part, plan.cutter, planes, study.run.number("allowed_gouge_mm"));
    study.result.add_row(
        {"at " + to_text(plan.direction_deg) + " deg, " + label,
         static_cast<std::int64_t>(gaps.points), plan.cutter.radius() + gaps.least,
         std::max(0.0, -gaps.least), static_cast<std::int64_t>(gaps.gouging_planes),
         static_cast<std::int64_t>(twisted_planes(study.sections.planes, planes))});
    return gaps.gouging_planes;
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

// Every second plane in blue, and all planes that gouge in red.
std::string drawing_with_gouges(const Study& study, const std::vector<PlaneLines>& planes)
{
    constexpr LineStyle clean_style{"#1d4f91", 0.8, ""};
    constexpr LineStyle gouging_style{"#d1402f", 1.8, ""};
    const std::vector part{dataset_surface(study.plan.surface)};
    const double allowed = study.run.number("allowed_gouge_mm");
    FigureOptions options;
    options.title = "After method 2 as printed: sections that still gouge";
    options.azimuth = Angle::degrees(70);
    options.elevation = Angle::degrees(25);
    options.captions = {"every second of " + std::to_string(planes.size()) +
                        " planes, and all that gouge"};
    std::vector<Vec3> extent;
    for (const PlaneLines& plane : planes)
        for (const auto& line : plane)
            extent.insert(extent.end(), line.begin(), line.end());
    AxonometricFigure picture{options, extent};
    for (std::size_t k = 0; k < planes.size(); ++k) {
        const bool gouges =
            plane_gaps(part, study.plan.cutter, {&planes[k], 1}, allowed).gouging_planes >
            0;
        for (const auto& line : planes[k])
            if (gouges || k % 2 == 0)
                picture.add_curve(line, gouges ? gouging_style : clean_style);
    }
    picture.add_legend("section without gouge", clean_style);
    picture.add_legend("section that gouges the part", gouging_style);
    return picture.text();
}

// The offset without contacts on the border, as in the paper.
void add_paper(Experiment& run, CsvTable& result, const SectionPlan& plan)
{
    const Study study{run, result, plan, offset_sections(plan)};
    const OffsetSections& paper = study.sections;
    const auto before = untrimmed_lines(paper.planes, paper.sections);
    add_distance(study, "untrimmed", before);
    const TrimmingOptions printed = literal_trimming(run.number("step_mm"));
    const auto after = trimmed_lines(paper, printed_method_3(), printed);
    const std::size_t by_sequence = add_distance(study, "3 as printed", after);
    if (plan.direction_deg == 0) {
        const auto by_lines = trimmed_lines(paper, "2", printed);
        const std::size_t others[]{
            add_distance(study, "1 literal", trimmed_lines(paper, "1", printed)),
            add_distance(study, "2 literal", by_lines)};
        add_named(
            result, "at 0 deg, worst of 1, 2 and 3",
            {{"gouging_planes",
              static_cast<std::int64_t>(std::max({by_sequence, others[0], others[1]}))}});
        run.write("before.svg", drawing(before, "The sections of the offset"));
        run.write("after.svg", drawing(after, "As figure 18: after method 3 as printed"));
        run.write("after-2.svg", drawing_with_gouges(study, by_lines));
    }
    add_distance(study, "3 literal", trimmed_lines(paper, "3", printed));
    add_distance(study, "3 guarded", trimmed_lines(paper, "3", {}));
    for (const char* method : {"3r", "envelope"})
        add_distance(study, method, trimmed_lines(paper, method, {}));
}

void add_with_border(Experiment& run, CsvTable& result, SectionPlan plan)
{
    plan.boundary = BoundaryContact::Contact;
    for (const double lines : run.numbers("grids_with_border")) {
        plan.grid_lines = static_cast<int>(lines);
        const Study study{run, result, plan, offset_sections(plan)};
        for (const std::string method : {"envelope", "winding"})
            add_distance(study, method + ", border touched, grid " + to_text(lines),
                         trimmed_lines(study.sections, method, {}));
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-18", [](Experiment& run) {
        CsvTable result{{"row", "points", "least_distance_mm", "gouge_mm",
                         "gouging_planes", "twisted_planes"}};
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
