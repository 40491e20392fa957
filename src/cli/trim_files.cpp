// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trim_files.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <regex>
#include <system_error>

#include <fmt/format.h>

#include "cli/progress.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/drop_cutter/clearance.h"
#include "endmill/figures/section_svg.h"
#include "endmill/files/path_file.h"
#include "endmill/files/result_csv.h"
#include "endmill/planning/linking.h"
#include "endmill/trimming/trimmed_planes.h"
#include "endmill/trimming/trimming_quality.h"

namespace endmill {
namespace {

std::vector<std::vector<SectionCurve>> curves_of(const TrimInput& input)
{
    std::vector<std::vector<SectionCurve>> curves;
    for (const PlaneSection& section : input.sections)
        curves.push_back(section.curves);
    return curves;
}

// Extent of all curves in z.
double height_of(const TrimInput& input)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const PlaneSection& section : input.sections)
        for (const SectionCurve& curve : section.curves)
            for (const SectionPoint& point : curve.points) {
                low = std::min(low, point.y());
                high = std::max(high, point.y());
            }
    return high > low ? high - low : 0;
}

ToolPath linked(const TrimInput& input, const TrimOptions& options,
                std::span<const Trimmed> trimmed)
{
    std::vector<PlaneCurves> planes;
    for (std::size_t k = 0; k < trimmed.size(); ++k)
        planes.push_back({input.planes->positions[k], trimmed[k].curves});
    LinkOptions link;
    link.order = options.order;
    link.safe_height = safe_height(input, options);
    return link_sections(planes, input.planes->frame, *options.cutter, link);
}

// Converts curves that need no trimming.
std::vector<Trimmed> as_trimmed(std::span<const PlaneSection> sections)
{
    std::vector<Trimmed> planes(sections.size());
    for (std::size_t k = 0; k < sections.size(); ++k)
        for (std::size_t c = 0; c < sections[k].curves.size(); ++c) {
            TrimmedCurve& curve = planes[k].curves.emplace_back();
            const auto& points = sections[k].curves[c].points;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const SegmentNumber on{static_cast<std::int32_t>(c),
                                       static_cast<std::int32_t>(i)};
                curve.points.push_back({points[i], on, on, TrimmedKind::Vertex});
            }
        }
    return planes;
}

// Measures the distance of the sampled points from the smooth offset. With --refine it
// also moves the points onto the offset.
void measure_sampling(const TrimInput& input, const TrimOptions& options,
                      TrimResult& result)
{
    const SectionSource source{std::get<std::vector<Surface>>(*input.part), *input.offset,
                               *input.planes, input.sections};
    if (!options.refine) {
        result.sampling_error = sampling_error(source, result.trimmed);
        return;
    }
    RefinedPlanes refined = refine_planes(source, result.trimmed);
    result.sampling_error = refined.greatest_shift;
    result.unrefined = refined.unrefined;
    for (std::size_t k = 0; k < refined.curves.size(); ++k)
        result.trimmed[k].curves = std::move(refined.curves[k]);
}

// Smallest distance between cutter and part at all trimmed points.
std::optional<double> clearance(const TrimInput& input, const TrimOptions& options,
                                std::span<const Trimmed> trimmed)
{
    std::vector<Vec3> places;
    for (std::size_t k = 0; k < trimmed.size(); ++k)
        for (const TrimmedCurve& curve : trimmed[k].curves)
            for (const TrimmedPoint& point : curve.points)
                places.push_back(input.planes->frame.point(
                    point.at.x(), input.planes->positions[k], point.at.y()));
    const std::optional<LeastGap> least =
        input.drop_cutter ? least_gap(*input.drop_cutter, places)
                          : least_gap(std::get<std::vector<Surface>>(*input.part),
                                      *options.cutter, places);
    return least ? std::optional{least->gap} : std::nullopt;
}

// Sections of the part with one plane. Empty if only curves are given.
std::vector<std::vector<SectionPoint>> part_lines(const TrimInput& input,
                                                  std::size_t plane)
{
    std::vector<std::vector<SectionPoint>> lines;
    if (!input.part)
        return lines;
    const DrivePlanes drawn{input.planes->frame, {input.planes->positions[plane]}};
    const auto* const mesh = std::get_if<TriangleMesh>(&*input.part);
    const auto sections = slice(mesh ? *mesh : contact_mesh(*input.offset), drawn);
    for (const SectionCurve& curve : sections.front().curves)
        lines.push_back(curve.points);
    return lines;
}

std::string section_picture(const TrimResult& result, const TrimInput& input,
                            const TrimOptions& options, std::size_t plane)
{
    FigureOptions figure;
    figure.title = fmt::format("{}: plane {} before and after method {}", input.name,
                               plane, result.method);
    if (input.planes)
        figure.captions.push_back(fmt::format("t = {:.6g} mm, feed at {:g} deg from +x",
                                              input.planes->positions[plane],
                                              options.direction_deg));
    return section_svg(
        {input.sections[plane].curves, result.trimmed[plane].curves,
         input.part ? options.cutter : std::nullopt, part_lines(input, plane)},
        figure);
}

// Picture of all trimmed curves in space. Curves of a file are drawn in the plane y = 0.
std::string trimmed_picture(const TrimResult& result, const TrimInput& input)
{
    std::vector<std::vector<Vec3>> curves;
    for (std::size_t k = 0; k < result.trimmed.size(); ++k)
        for (const TrimmedCurve& curve : result.trimmed[k].curves) {
            std::vector<Vec3> points;
            for (const TrimmedPoint& point : curve.points)
                points.push_back(
                    input.planes
                        ? input.planes->frame.point(
                              point.at.x(), input.planes->positions[k], point.at.y())
                        : Vec3{point.at.x(), 0, point.at.y()});
            curves.push_back(std::move(points));
        }
    FigureOptions figure;
    figure.title = input.name + ": the offset after method " + result.method;
    return curves_svg(curves, figure);
}

// A smaller step back is rounding, for coordinates of some 100 mm.
constexpr double step_back_mm = 1e-10;

Comparison comparison(const TrimInput& input, const TrimOptions& options,
                      std::span<const Trimmed> trimmed)
{
    std::vector<TrimmingQuality> qualities(trimmed.size());
    parallel_for(trimmed.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            qualities[k] = trimming_quality(input.sections[k].curves, trimmed[k]);
    });
    Comparison result;
    for (const TrimmingQuality& quality : qualities) {
        if (quality.step_back_mm > step_back_mm || quality.gouge_mm > options.tolerance)
            ++result.wrong;
        result.deepest_below_mm = std::max(result.deepest_below_mm, quality.gouge_mm);
    }
    return result;
}

}  // namespace

TrimResult trim_by(const TrimmingMethod& method, const TrimInput& input,
                   const TrimOptions& options)
{
    using Clock = std::chrono::steady_clock;
    TrimResult result;
    result.method = std::string{method.name};
    const std::string name = "method " + result.method + ": ";
    ProgressLine progress{name + "trimming", options.common};
    result.options = trimming_options(options, height_of(input));
    const auto start = Clock::now();
    result.trimmed = input.drop_cutter ? as_trimmed(input.sections)
                                       : trim_planes(input.sections, input.ranges, method,
                                                     result.options);
    result.trim_ms =
        std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    progress.begin(name + "comparing with the envelope");
    if (method_name(options) == "all" && !input.drop_cutter)
        result.comparison = comparison(input, options, result.trimmed);
    progress.begin(name + (options.refine ? "refining" : "measuring the sampling error"));
    if (input.offset)
        measure_sampling(input, options, result);
    for (std::size_t k = 0; k < result.trimmed.size(); ++k)
        result.loops.push_back(
            cut_out(input.sections[k].curves, result.trimmed[k], crease_test(input, k)));
    progress.begin(name + "measuring the clearance");
    if (input.planes) {
        result.path = linked(input, options, result.trimmed);
        result.min_clearance = clearance(input, options, result.trimmed);
    }
    return result;
}

Json write_trimmed(const TrimResult& result, const TrimInput& input,
                   const TrimOptions& options, OutputFolder& folder,
                   const std::string& prefix)
{
    const DrivePlanes* placed = input.planes ? &*input.planes : nullptr;
    folder.write(prefix + "trimmed.csv", trimmed_csv(result.trimmed, placed));
    folder.write(prefix + "loops.csv",
                 loops_csv(result.loops, options.explain ? LoopColumns::CauseAndRule
                                                         : LoopColumns::Cause));
    if (input.part)
        folder.write(prefix + "toolpath.csv", tool_path_csv(result.path));
    if (options.figure) {
        const auto plane = static_cast<std::size_t>(*options.figure);
        folder.write(prefix + fmt::format("section-{}.svg", plane),
                     section_picture(result, input, options, plane));
        folder.write(prefix + "trimmed.svg", trimmed_picture(result, input));
    }
    Json summary = trim_summary(input, options, result);
    if (input.part)
        name_part(summary, options.part, folder.path() / prefix);
    folder.write(prefix + "summary.json", summary.dump(2) + "\n");
    return summary;
}

namespace {

// Names of the section pictures of an earlier run in a folder, of any plane.
std::vector<std::string> section_pictures(const std::filesystem::path& folder)
{
    static const std::regex picture{R"(section-\d+\.svg)"};
    std::vector<std::string> names;
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator{folder, failed})
        if (std::string name = entry.path().filename().string();
            std::regex_match(name, picture))
            names.push_back(std::move(name));
    return names;
}

}  // namespace

void write_sections(const TrimInput& input, OutputFolder& folder)
{
    std::vector<std::string> prefixes{""};
    for (const TrimmingMethod& method : trimming_methods())
        prefixes.push_back(std::string{method.name} + "/");
    for (const std::string& prefix : prefixes) {
        for (const std::string& name : section_pictures(folder.path() / prefix))
            folder.remove_unless_written(prefix + name);
        for (const char* name :
             {"trimmed.csv", "loops.csv", "toolpath.csv", "trimmed.svg", "summary.json"})
            folder.remove_unless_written(prefix + name);
    }
    folder.write("sections.csv",
                 sections_csv(curves_of(input), input.planes ? &*input.planes : nullptr));
}

}  // namespace endmill
