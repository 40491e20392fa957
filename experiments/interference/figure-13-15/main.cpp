// SPDX-License-Identifier: GPL-3.0-or-later Figures 13 to 15 of Jang, Kim and Jeong: a
// section without a twist, one with interference at its ends, and one with a full twist,
// before and after trimming.
//
//   interference-figure-13-15 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "endmill/core/text.h"
#include "endmill/figures/section_svg.h"
#include "endmill/trimming/cut_out.h"
#include "endmill/trimming/detail/section_views.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/offset_sections.h"
#include "support/timed_trimming.h"

using namespace endmill;

namespace {

// A figure of the paper and the section that represents it.
struct PlaneFigure {
    std::string number;
    double feed_deg;
    std::size_t plane;
};

// Rounds to 1e-4 mm for the captions.
double rounded(double length)
{
    constexpr double parts_a_mm = 1e4;
    return std::round(length * parts_a_mm) / parts_a_mm;
}

void draw(Experiment& run, CsvTable& result, const PlaneFigure& shown)
{
    const Cutter cutter = Cutter::ball(run.number("radius_mm"));
    const OffsetSections offset =
        offset_sections({run.text("surface"), cutter, shown.feed_deg});
    const auto& curves = offset.sections.at(shown.plane).curves;
    const std::string method = run.text("method");
    const Trimmed trimmed = trimming_method(method).trim(curves, {});
    const auto cuts = cut_out(curves, trimmed);
    const std::int64_t folds = std::ranges::count(cuts, CutCause::Fold, &CutOut::cause);
    const std::int64_t ends = std::ranges::count(cuts, CutCause::End, &CutOut::cause);
    const double t = offset.planes.positions[shown.plane];
    result.add_row({"figure " + shown.number, shown.feed_deg,
                    static_cast<std::int64_t>(shown.plane), t,
                    static_cast<std::int64_t>(point_count(curves)),
                    static_cast<std::int64_t>(point_count(trimmed.curves)), folds, ends,
                    word(folds > 0), word(ends > 0)});
    std::vector<std::vector<SectionPoint>> part;
    const auto part_planes = slice(contact_mesh(offset.offset), offset.planes);
    for (const SectionCurve& curve : part_planes.at(shown.plane).curves)
        part.push_back(curve.points);
    FigureOptions figure;
    figure.title =
        "As figure " + shown.number + ": section before and after method " + method;
    figure.captions = {run.text("surface") + ", feed at " + to_text(shown.feed_deg) +
                       " deg, plane " + std::to_string(shown.plane) +
                       ", t = " + to_text(rounded(t)) + " mm, ball of radius " +
                       to_text(cutter.radius()) + " mm"};
    run.write("section-" + shown.number + ".svg",
              section_svg({curves, trimmed.curves, cutter, part}, figure));
    const auto middle = mean_place(cuts);
    if (!middle)
        return;
    const double half_width = run.number("detail_mm");
    figure.title += ", detail";
    const auto before = curves_near(curves, *middle, half_width);
    const auto after = curves_near(trimmed.curves, *middle, half_width);
    run.write("detail-" + shown.number + ".svg", section_svg({before, after}, figure));
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-13-15", [](Experiment& run) {
        CsvTable result{{"row", "feed_deg", "plane", "t_mm", "points", "points_left",
                         "folds_cut", "ends_cut", "full_twist", "end_deleted"}};
        const auto feeds = run.numbers("feeds_deg");
        const auto planes = run.numbers("planes");
        const auto names = run.texts("figures");
        for (std::size_t k = 0; k < names.size(); ++k)
            draw(run, result,
                 {names[k], feeds.at(k), static_cast<std::size_t>(planes.at(k))});
        run.write_result(result);
    });
}
