// SPDX-License-Identifier: GPL-3.0-or-later
// Figures 13 to 15 of Jang, Kim and Jeong: a section without a twist, one with interference
// at its ends, and one with a full twist, before and after trimming.
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
#include "endmill/trimming/trimming_methods.h"
#include "support/experiment.h"
#include "support/offset_sections.h"

using namespace endmill;

namespace {

std::size_t points_of(std::span<const SectionCurve> curves)
{
    std::size_t count = 0;
    for (const SectionCurve& curve : curves)
        count += curve.points.size();
    return count;
}

std::size_t points_of(std::span<const TrimmedCurve> curves)
{
    std::size_t count = 0;
    for (const TrimmedCurve& curve : curves)
        count += curve.points.size();
    return count;
}

// The stretches of `points` within `reach` of `middle` in both coordinates, with at least
// two points.
template <typename Point, typename At>
std::vector<std::vector<Point>> near(const std::vector<Point>& points, const At& at,
                                     const SectionPoint& middle, double reach)
{
    std::vector<std::vector<Point>> stretches(1);
    for (const Point& point : points) {
        const bool is_near = (at(point) - middle).cwiseAbs().maxCoeff() <= reach;
        if (is_near)
            stretches.back().push_back(point);
        else if (!stretches.back().empty())
            stretches.emplace_back();
    }
    std::erase_if(stretches, [](const auto& stretch) { return stretch.size() < 2; });
    return stretches;
}

// The middle of all cuts.
std::optional<SectionPoint> middle_of(std::span<const CutOut> cuts)
{
    SectionPoint sum{0, 0};
    int count = 0;
    for (const CutOut& cut : cuts)
        if (cut.place) {
            sum += *cut.place;
            ++count;
        }
    return count > 0 ? std::optional<SectionPoint>{sum / count} : std::nullopt;
}

// The parts of the curves within `reach` mm of `middle`.
std::string detail(std::span<const SectionCurve> curves, const Trimmed& trimmed,
                   const SectionPoint& middle, double reach, const FigureOptions& figure)
{
    std::vector<SectionCurve> before;
    for (const SectionCurve& curve : curves)
        for (auto& points : near(
                 curve.points, [](const SectionPoint& point) { return point; }, middle,
                 reach))
            before.push_back({std::move(points)});
    std::vector<TrimmedCurve> after;
    for (const TrimmedCurve& curve : trimmed.curves)
        for (auto& points : near(
                 curve.points, [](const TrimmedPoint& point) { return point.at; }, middle,
                 reach))
            after.push_back({std::move(points)});
    return section_svg({before, after}, figure);
}

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

const TrimmingMethod& method_named(const std::string& name)
{
    return *std::ranges::find(trimming_methods(), name, &TrimmingMethod::name);
}

void draw(Experiment& run, CsvTable& result, const PlaneFigure& shown)
{
    const Cutter cutter = Cutter::ball(run.number("radius_mm"));
    const OffsetSections offset =
        offset_sections({run.text("surface"), cutter, shown.feed_deg});
    const auto& curves = offset.sections.at(shown.plane).curves;
    const std::string method = run.text("method");
    const Trimmed trimmed = method_named(method).trim(curves, {});
    const auto cuts = cut_out(curves, trimmed);
    const auto count = [&](CutCause cause) {
        return static_cast<std::int64_t>(std::ranges::count(cuts, cause, &CutOut::cause));
    };
    const double t = offset.planes.positions[shown.plane];
    result.add_row(
        {"figure " + shown.number, shown.feed_deg, static_cast<std::int64_t>(shown.plane),
         t, static_cast<std::int64_t>(points_of(curves)),
         static_cast<std::int64_t>(points_of(trimmed.curves)), count(CutCause::Fold),
         count(CutCause::End), count(CutCause::Fold) > 0 ? "yes" : "no",
         count(CutCause::End) > 0 ? "yes" : "no"});
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
    const auto middle = middle_of(cuts);
    if (!middle)
        return;
    const double reach = run.number("detail_mm");
    figure.title += ", detail";
    run.write("detail-" + shown.number + ".svg",
              detail(curves, trimmed, *middle, reach, figure));
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
