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
#include "endmill/drop_cutter/clearance.h"
#include "endmill/figures/section_svg.h"
#include "endmill/trimming/trimmed_planes.h"
#include "support/experiment.h"
#include "support/offset_sections.h"

using namespace endmill;

namespace {

constexpr int paper_grid = 200;  // contacts along each parameter by default

using PlaneCurvesInSpace = std::vector<std::vector<Vec3>>;

// An offset with its sections, and the part's surface.
struct Case {
    OffsetSections offset;
    std::vector<Surface> part;
    Cutter cutter;
    std::string name;
};

PlaneCurvesInSpace in_space(const DrivePlanes& planes, std::size_t plane,
                            std::span<const SectionCurve> curves)
{
    PlaneCurvesInSpace result;
    for (const SectionCurve& curve : curves) {
        auto& line = result.emplace_back();
        for (const SectionPoint& point : curve.points)
            line.push_back(
                planes.frame.point(point.x(), planes.positions[plane], point.y()));
    }
    return result;
}

std::vector<PlaneCurvesInSpace> untrimmed(const Case& the)
{
    std::vector<PlaneCurvesInSpace> result;
    for (std::size_t k = 0; k < the.offset.sections.size(); ++k)
        result.push_back(in_space(the.offset.planes, k, the.offset.sections[k].curves));
    return result;
}

std::vector<PlaneCurvesInSpace> trimmed(const Case& the, const std::string& method,
                                        FoldDetection detection)
{
    const auto found =
        std::ranges::find(trimming_methods(), method, &TrimmingMethod::name);
    TrimmingOptions options;
    options.detection = detection;
    const auto ranges =
        path_ranges(the.offset.offset, the.offset.planes, the.offset.sections);
    const auto left = trim_planes(the.offset.sections, ranges, *found, options);
    std::vector<PlaneCurvesInSpace> result;
    for (std::size_t k = 0; k < left.size(); ++k) {
        std::vector<SectionCurve> curves;
        for (const TrimmedCurve& curve : left[k].curves) {
            curves.emplace_back();
            for (const TrimmedPoint& point : curve.points)
                curves.back().points.push_back(point.at);
        }
        result.push_back(in_space(the.offset.planes, k, curves));
    }
    return result;
}

// Adds the smallest distance of the ball's centre from the part, and the number of planes
// in which it is too small.
void add_distance(Experiment& run, CsvTable& result, const Case& the,
                  const std::string& label, const std::vector<PlaneCurvesInSpace>& planes)
{
    const double allowed = run.number("allowed_gouge_mm");
    double least = std::numeric_limits<double>::infinity();
    std::int64_t gouging = 0;
    std::size_t points = 0;
    for (const PlaneCurvesInSpace& curves : planes) {
        std::vector<Vec3> places;
        for (const auto& curve : curves)
            places.insert(places.end(), curve.begin(), curve.end());
        points += places.size();
        const auto gap = least_gap(the.part, the.cutter, places);
        if (!gap)
            continue;
        least = std::min(least, gap->gap);
        gouging += gap->gap < -allowed ? 1 : 0;
    }
    result.add_row({the.name + ", " + label, static_cast<std::int64_t>(points),
                    the.cutter.radius() + least, gouging});
}

std::string drawing(const std::vector<PlaneCurvesInSpace>& planes,
                    const std::string& title)
{
    constexpr std::size_t every =
        2;  // draw every second plane, so that the lines are distinct
    PlaneCurvesInSpace curves;
    for (std::size_t k = 0; k < planes.size(); k += every)
        curves.insert(curves.end(), planes[k].begin(), planes[k].end());
    FigureOptions figure;
    figure.title = title;
    figure.azimuth = Angle::degrees(70);
    figure.elevation = Angle::degrees(25);
    figure.captions = {"every second of " + std::to_string(planes.size()) + " planes"};
    return curves_svg(curves, figure);
}

Case case_of(Experiment& run, double feed, int grid_lines, BoundaryContact boundary)
{
    const std::string surface = run.text("surface");
    const Cutter cutter = Cutter::ball(run.number("radius_mm"));
    return {offset_sections({.surface = surface,
                             .cutter = cutter,
                             .direction_deg = feed,
                             .grid_lines = grid_lines,
                             .boundary = boundary}),
            {dataset_surface(surface)},
            cutter,
            "at " + to_text(feed) + " deg"};
}

void add_feed(Experiment& run, CsvTable& result, double feed)
{
    const Case paper = case_of(run, feed, paper_grid, BoundaryContact::None);
    const auto before = untrimmed(paper);
    const auto after = trimmed(paper, "3", FoldDetection::Guarded);
    add_distance(run, result, paper, "untrimmed", before);
    add_distance(run, result, paper, "3 literal",
                 trimmed(paper, "3", FoldDetection::Literal));
    add_distance(run, result, paper, "3 guarded", after);
    for (const char* method : {"3r", "envelope"})
        add_distance(run, result, paper, method,
                     trimmed(paper, method, FoldDetection::Guarded));
    if (feed == 0) {
        run.write("before.svg", drawing(before, "The sections of the offset"));
        run.write("after.svg", drawing(after, "As figure 18: after method 3"));
    }
    for (const double lines : run.numbers("grids_with_border")) {
        const Case ours =
            case_of(run, feed, static_cast<int>(lines), BoundaryContact::Contact);
        for (const std::string method : {"envelope", "winding"})
            add_distance(run, result, ours,
                         method + ", border touched, grid " + to_text(lines),
                         trimmed(ours, method, FoldDetection::Guarded));
    }
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-18", [](Experiment& run) {
        CsvTable result{{"row", "points", "least_distance_mm", "gouging_planes"}};
        for (const double feed : run.numbers("feeds_deg"))
            add_feed(run, result, feed);
        run.write_result(result);
    });
}
