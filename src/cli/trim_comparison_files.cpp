// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a comparison of trimming methods: tables, chart and picture of a plane.
#include <algorithm>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "cli/shown_numbers.h"
#include "cli/trim_comparison.h"
#include "cli/trim_files.h"
#include "endmill/core/text.h"
#include "endmill/figures/section_svg.h"

namespace endmill {
namespace {

// Half the side of the drawn square about the largest difference: in radii of the cutter,
// and in the distance itself; the larger one counts.
constexpr double window_radii = 1.3;
constexpr double window_distances = 2;

std::string times_csv(std::span<const MethodRuns> methods)
{
    std::string text = "repetition,method,measured_ms\n";
    for (std::size_t k = 0; k < methods.front().times_ms.size(); ++k)
        for (const MethodRuns& method : methods)
            text +=
                fmt::format("{},{},{}\n", k, method.name, to_text(method.times_ms[k]));
    return text;
}

// Differences below the rounding of coordinates are left out.
std::string differences_csv(std::span<const MethodRuns> methods, const TrimInput& input,
                            double tolerance)
{
    std::string text =
        "plane,t_mm,method,distance_mm,s_mm,z_mm,below_mm,lost_mm,step_back_mm,right\n";
    for (std::size_t k = 0; k < input.sections.size(); ++k)
        for (const MethodRuns& method : methods) {
            const CurveDifference& found = method.differences[k];
            if (found.distance_mm <= step_back_on_parts_mm &&
                found.step_back_mm <= step_back_on_parts_mm)
                continue;
            text += fmt::format(
                "{},{},{},{},{},{},{},{},{},{}\n", k,
                input.part ? to_text(input.part->planes.positions[k]) : "", method.name,
                to_text(found.distance_mm), to_text(found.place.x()),
                to_text(found.place.y()), to_text(found.below_mm), to_text(found.lost_mm),
                to_text(found.step_back_mm), is_right(found, tolerance) ? "yes" : "no");
        }
    return text;
}

std::string chart(std::span<const MethodRuns> methods, const TrimInput& input,
                  const TrimOptions& options)
{
    std::vector<MethodRow> rows;
    for (const MethodRuns& method : methods) {
        const TimeSpread spread = time_spread(method.times_ms);
        MethodRow row{std::string{method.name},
                      spread.median,
                      spread.lower_quartile,
                      spread.upper_quartile,
                      {},
                      {}};
        for (const CurveDifference& difference : method.differences) {
            row.distances_mm.push_back(difference.distance_mm);
            row.is_right.push_back(is_right(difference, options.tolerance));
        }
        rows.push_back(std::move(row));
    }
    MethodsChart texts;
    texts.title = input.name + ": trimming methods compared";
    texts.captions = {fmt::format("{} of each method on {}; exact curve: method envelope",
                                  counted(methods.front().times_ms.size(), "timed run"),
                                  counted(input.sections.size(), "drive plane")),
                      fmt::format("differences beyond the tolerance of {} mm are drawn",
                                  shown_limit(options.tolerance))};
    texts.tolerance_mm = options.tolerance;
    return methods_chart_svg(rows, texts);
}

// Whether two methods left the same curves in a plane, up to rounding.
bool are_same(const CurveDifference& one, const CurveDifference& other)
{
    return std::abs(one.distance_mm - other.distance_mm) <= step_back_on_parts_mm &&
           std::abs(one.below_mm - other.below_mm) <= step_back_on_parts_mm &&
           std::abs(one.lost_mm - other.lost_mm) <= step_back_on_parts_mm &&
           (one.place - other.place).norm() <= step_back_on_parts_mm;
}

// The methods that differ from the exact curve in a plane. Methods with the same curves
// share one entry, whose label names them all. The farthest come first.
std::vector<ComparedCurves> other_curves(std::span<const MethodRuns> methods,
                                         std::size_t plane, double tolerance)
{
    std::vector<const MethodRuns*> order;
    for (const MethodRuns& method : methods)
        if (method.differences[plane].distance_mm > tolerance)
            order.push_back(&method);
    const auto distance = [&](const MethodRuns* method) {
        return method->differences[plane].distance_mm;
    };
    std::ranges::stable_sort(order, std::greater{}, distance);
    std::vector<ComparedCurves> others;
    const CurveDifference* last = nullptr;
    for (const MethodRuns* method : order) {
        const CurveDifference& difference = method->differences[plane];
        const std::string name{method->name};
        if (last && are_same(*last, difference)) {
            std::string& label = others.back().label;
            label =
                (label.starts_with("method ") ? "methods " + label.substr(7) : label) +
                ", " + name;
            continue;
        }
        last = &difference;
        others.push_back({"method " + name, method->trimmed[plane].curves});
    }
    return others;
}

}  // namespace

void write_comparison(std::span<const MethodRuns> methods, const TrimInput& input,
                      const TrimOptions& options, OutputFolder& folder)
{
    folder.write("differences.csv", differences_csv(methods, input, options.tolerance));
    if (methods.front().times_ms.empty())
        return;
    folder.write("times.csv", times_csv(methods));
    folder.write("comparison.svg", chart(methods, input, options));
}

std::string compared_picture(std::span<const MethodRuns> methods, const TrimInput& input,
                             const TrimOptions& options, std::size_t plane)
{
    const auto exact = std::ranges::find(methods, exact_method, &MethodRuns::name);
    const auto farthest = std::ranges::max_element(
        methods, {},
        [&](const MethodRuns& method) { return method.differences[plane].distance_mm; });
    const CurveDifference& worst = farthest->differences[plane];
    FigureOptions figure;
    figure.title = fmt::format(
        "{}: plane {}, {}", input.name, plane,
        options.figure_worst ? "where the methods differ most" : "by all methods");
    if (input.part)
        figure.captions.push_back(fmt::format("t = {:.6g} mm, feed at {:g} deg from +x",
                                              input.part->planes.positions[plane],
                                              options.direction_deg));
    ComparedSections drawing{input.sections[plane].curves,
                             {"exact curve (envelope)", exact->trimmed[plane].curves},
                             other_curves(methods, plane, options.tolerance),
                             cutter_of(options),
                             {},
                             std::numeric_limits<double>::infinity(),
                             part_lines(input, plane)};
    if (drawing.others.empty()) {
        figure.captions.emplace_back("all methods leave the exact curve");
        return compared_sections_svg(drawing, std::move(figure));
    }
    figure.captions.push_back(fmt::format(
        "{}: up to {} mm from the exact curve, {} mm below it, {} mm of path lost",
        drawing.others.front().label, shown(worst.distance_mm), shown(worst.below_mm),
        shown(worst.lost_mm)));
    drawing.places.push_back(worst.place);
    const double around_cutter =
        drawing.cutter ? window_radii * drawing.cutter->radius() : 0;
    drawing.half_side = std::max(around_cutter, window_distances * worst.distance_mm);
    return compared_sections_svg(drawing, std::move(figure));
}

}  // namespace endmill
