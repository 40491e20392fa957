// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 13 to 15 of Jang, Kim and Jeong: a section without a twist, one with
// interference at its ends, and one with a full twist, before and after method 3; and the
// least gap between the ball and the part along the result.
//
//   interference-figure-13-15 OUTPUT_FOLDER
//
// Deterministic, under 2 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "endmill/core/text.h"
#include "endmill/drop_cutter/detail/plane_gaps.h"
#include "endmill/figures/section_svg.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/detail/section_runs.h"
#include "endmill/trimming/detail/section_views.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/offset_sections.h"
#include "support/printed_search.h"
#include "support/side_by_side.h"
#include "support/timed_trimming.h"

using namespace endmill;

namespace {

constexpr double section_px = 640;  // width of the picture of a section
constexpr double detail_px = 640;   // of the magnified detail

// A figure of the paper, the plane that represents it, and its section.
struct PlaneFigure {
    std::string number;
    SectionPlan plan;
    std::size_t plane;
    OffsetSections offset;

    const std::vector<SectionCurve>& curves() const
    {
        return offset.sections.at(plane).curves;
    }
    double position() const { return offset.planes.positions.at(plane); }
};

// The result of a method for the section of a figure.
struct TrimmedFigure {
    std::string row;    // of the result
    std::string title;  // of the picture
    Trimmed trimmed;
    std::vector<CutOut> cuts;
};

TrimmedFigure trimmed_figure(const PlaneFigure& figure, FoldDetection detection)
{
    const bool is_literal = detection == FoldDetection::Literal;
    const TrimmingMethod& method = is_literal ? printed_method_3() : trimming_method("3");
    TrimmedFigure result{"figure " + figure.number + (is_literal ? "" : ", corrected"),
                         "As figure " + figure.number + ": before and after method 3 " +
                             (is_literal ? "as printed" : "with corrected detection"),
                         method.trim(figure.curves(), {.detection = detection}),
                         {}};
    result.cuts = cut_out(figure.curves(), result.trimmed);
    return result;
}

// Rounds to 1e-4 mm for the captions.
double rounded(double length)
{
    constexpr double parts_a_mm = 1e4;
    return std::round(length * parts_a_mm) / parts_a_mm;
}

// The largest number of changes of the sign of dz along a curve.
std::int64_t slope_changes(const std::vector<SectionCurve>& curves)
{
    std::int64_t most = 0;
    for (const SectionCurve& curve : curves) {
        const SectionChain chain{curve.points, 0};
        RunReader runs{chain, RunAxis::Z, dead_band(curve.points), chain.first()};
        std::int64_t count = 0;
        while (runs.next())
            ++count;
        most = std::max(most, count - 1);
    }
    return most;
}

double least_gap_of(const PlaneFigure& figure, const Trimmed& trimmed)
{
    const std::vector part{dataset_surface(figure.plan.surface)};
    const std::vector<PlaneLines> lines{
        lines_in_space(trimmed.curves, figure.offset.planes.frame, figure.position())};
    return plane_gaps(part, figure.plan.cutter, lines, 0).least;
}

void add_result(CsvTable& result, const PlaneFigure& figure, const TrimmedFigure& shown)
{
    const auto& curves = figure.curves();
    const std::int64_t folds =
        std::ranges::count(shown.cuts, CutCause::Fold, &CutOut::cause);
    const std::int64_t ends =
        std::ranges::count(shown.cuts, CutCause::End, &CutOut::cause);
    result.add_row(
        {shown.row, figure.plan.direction_deg, static_cast<std::int64_t>(figure.plane),
         figure.position(), static_cast<std::int64_t>(point_count(curves)),
         static_cast<std::int64_t>(point_count(shown.trimmed.curves)),
         slope_changes(curves), folds, ends, least_gap_of(figure, untrimmed(curves)),
         least_gap_of(figure, shown.trimmed)});
}

// The section, and beside it a detail about `place` if there is one.
std::string drawing(const PlaneFigure& figure, const TrimmedFigure& shown,
                    const std::optional<SectionPoint>& place, double half_width)
{
    std::vector<std::vector<SectionPoint>> part;
    const auto part_planes =
        slice(contact_mesh(figure.offset.offset), figure.offset.planes);
    for (const SectionCurve& curve : part_planes.at(figure.plane).curves)
        part.push_back(curve.points);
    FigureOptions options;
    options.width_px = section_px;
    options.title = shown.title;
    options.captions = {
        figure.plan.surface + ", feed at " + to_text(figure.plan.direction_deg) +
        " deg, plane " + std::to_string(figure.plane) +
        ", t = " + to_text(rounded(figure.position())) + " mm, ball of radius " +
        to_text(figure.plan.cutter.radius()) + " mm"};
    const std::string whole = section_svg(
        {figure.curves(), shown.trimmed.curves, figure.plan.cutter, part}, options);
    if (!place)
        return whole;
    options.width_px = detail_px;
    options.title = "Detail";
    options.captions = {"the offset where it folds, magnified"};
    const auto before = curves_near(figure.curves(), *place, half_width);
    const auto after = curves_near(shown.trimmed.curves, *place, half_width);
    return side_by_side(whole, section_svg({before, after}, options));
}

void add_figure(Experiment& run, CsvTable& result, const PlaneFigure& figure)
{
    const TrimmedFigure printed = trimmed_figure(figure, FoldDetection::Literal);
    const TrimmedFigure corrected = trimmed_figure(figure, FoldDetection::Guarded);
    add_result(result, figure, printed);
    add_result(result, figure, corrected);
    const double half_width = run.number("detail_mm");
    const auto place = mean_place(corrected.cuts);
    run.write("section-" + figure.number + ".svg",
              drawing(figure, printed, place, half_width));
    if (figure.number == run.text("drawn_corrected"))
        run.write("section-" + figure.number + "-corrected.svg",
                  drawing(figure, corrected, place, half_width));
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-13-15", [](Experiment& run) {
        CsvTable result{{"row", "feed_deg", "plane", "t_mm", "points", "points_left",
                         "slope_changes", "folds_cut", "ends_cut", "least_gap_before_mm",
                         "least_gap_mm"}};
        const auto feeds = run.numbers("feeds_deg");
        const auto planes = run.numbers("planes");
        const auto names = run.texts("figures");
        for (std::size_t k = 0; k < names.size(); ++k) {
            const SectionPlan plan{run.text("surface"),
                                   Cutter::ball(run.number("radius_mm")), feeds.at(k)};
            add_figure(run, result,
                       {names[k], plan, static_cast<std::size_t>(planes.at(k)),
                        offset_sections(plan)});
        }
        run.write_result(result);
    });
}
