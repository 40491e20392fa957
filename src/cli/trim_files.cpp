// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trim_files.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <regex>
#include <system_error>

#include <fmt/format.h>

#include "cli/path_facts.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "cli/trim_ranks.h"
#include "cli/trim_stages.h"
#include "endmill/drop_cutter/clearance.h"
#include "endmill/figures/section_svg.h"
#include "endmill/files/path_file.h"
#include "endmill/files/result_csv.h"
#include "endmill/planning/linking.h"
#include "endmill/trimming/trimmed_planes.h"
#include "endmill/trimming/trimming_quality.h"

namespace endmill {
namespace {

// The work after a stage of `method`, where it is known: on surfaces.
double work_after(TrimStage stage, const TrimInput& input, const TrimOptions& options,
                  std::string_view method = {})
{
    return input.offset_part() ? work_after(stage, options, method) : 0;
}

// Estimates how far the sampled points are from the smooth offset. With --refine it
// also moves the points onto the offset.
void measure_sampling(const OffsetPart& part, const TrimInput& input,
                      const TrimOptions& options, ProgressLine& progress,
                      TrimResult& result)
{
    const SectionSource source{part.surfaces, part.offset, input.part->planes,
                               input.sections, progress.shower()};
    if (!options.refine) {
        result.sampling_error = sampling_error(source, result.trimmed);
        return;
    }
    RefinedPlanes refined = refine_planes(source, result.trimmed);
    result.sampling_error = refined.greatest_shift;
    result.unrefined = refined.unrefined;
    result.trimmed = std::move(refined.planes);
}

// The place of a gap in words.
std::string place_text(const DrivePlanes& planes, std::span<const Trimmed> trimmed,
                       const LeastGap& least)
{
    std::size_t before = 0;  // points of the planes before
    std::size_t plane = 0;
    for (; plane < trimmed.size(); ++plane) {
        std::size_t points = 0;
        for (const TrimmedCurve& curve : trimmed[plane].curves)
            points += curve.points.size();
        if (least.place < before + points)
            break;
        before += points;
    }
    return fmt::format(
        "plane {} (t = {} mm) at x {} y {} z {}", plane,
        shown_coordinate(planes.positions[plane]), shown_coordinate(least.point.x()),
        shown_coordinate(least.point.y()), shown_coordinate(least.point.z()));
}

// Measures the clearance of the curves from the part. On a mesh, where the cutter rests, it
// is the allowance, less the height at which the mesh rises into the resting cutter.
void measure_clearance(const CutPart& part, const TrimOptions& options,
                       ProgressLine& progress, TrimResult& result)
{
    const std::vector<Vec3> places = section_points(part.planes, result.trimmed);
    const auto* const mesh = std::get_if<DroppedPart>(&part.shape);
    const std::optional<LeastGap> least =
        mesh ? greatest_rise(mesh->drop_cutter, places, progress.shower())
             : least_gap(std::get<OffsetPart>(part.shape).surfaces, *options.cutter,
                         places, {.progress = progress.shower()});
    if (!least)
        return;
    result.min_clearance =
        mesh ? options.allowance + std::min(0.0, least->gap) : least->gap;
    result.nearest = place_text(part.planes, result.trimmed, *least);
}

// Links the trimmed curves to a path without the points that its tolerance allows to drop.
// What a gouge at the points takes of the tolerance is not available for dropping.
void add_tool_path(const CutPart& part, const TrimOptions& options,
                   ProgressLine& progress, TrimResult& result)
{
    const double left = options.tolerance - max_gouge(result).value_or(0);
    result.thin_tolerance =
        left > 0 ? std::min(thin_tolerance(options), left) : thin_tolerance(options);
    const std::vector<Trimmed> thin =
        thinned_planes(result.trimmed, result.thin_tolerance, progress.shower());
    result.dropped_points = section_points(part.planes, result.trimmed).size() -
                            section_points(part.planes, thin).size();
    LinkOptions link;
    link.order = options.order;
    link.safe_height = safe_height(part, options);
    result.path = link_sections(thin, part.planes, *options.cutter, link);
    number_points(result.path);
}

// Measures the clearance of trimmed offsets from the profiles of a file.
void measure_clearance(const OffsetCurves& curves, const TrimOptions& options,
                       ProgressLine& progress, TrimResult& result)
{
    std::vector<SectionPoint> places;
    for (const TrimmedCurve& curve : result.trimmed.front().curves)
        for (const TrimmedPoint& point : curve.points)
            places.push_back(point.at);
    if (const auto least = profile_gap(curves.profiles, *options.offset, places,
                                       {.progress = progress.shower()}))
        result.min_clearance = least->gap;
}

}  // namespace

std::vector<std::vector<SectionPoint>> part_lines(const TrimInput& input,
                                                  std::size_t plane)
{
    std::vector<std::vector<SectionPoint>> lines;
    if (input.curves)
        for (const SectionCurve& profile : input.curves->profiles)
            lines.push_back(profile.points);
    if (!input.part)
        return lines;
    const DrivePlanes& planes = input.part->planes;
    const DrivePlanes drawn{planes.frame, {planes.positions[plane]}};
    const OffsetPart* const surfaces = input.offset_part();
    const auto sections = slice(
        surfaces ? contact_mesh(surfaces->offset) : *input.dropped_part()->mesh, drawn);
    for (const SectionCurve& curve : sections.front().curves)
        lines.push_back(curve.points);
    return lines;
}

namespace {

std::string section_picture(const TrimResult& result, const TrimInput& input,
                            const TrimOptions& options, std::size_t plane)
{
    FigureOptions figure;
    figure.title = fmt::format("{}: plane {} before and after method {}", input.name,
                               plane, result.method);
    if (input.part)
        figure.captions.push_back(fmt::format("t = {:.6g} mm, feed at {:g} deg from +x",
                                              input.part->planes.positions[plane],
                                              options.direction_deg));
    return section_svg({input.sections[plane].curves, result.trimmed[plane].curves,
                        cutter_of(options), part_lines(input, plane)},
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
                    input.part
                        ? input.part->planes.frame.point(
                              point.at.x(), input.part->planes.positions[k], point.at.y())
                        : Vec3{point.at.x(), 0, point.at.y()});
            curves.push_back(std::move(points));
        }
    FigureOptions figure;
    figure.title = input.name + ": the offset after method " + result.method;
    return curves_svg(curves, figure);
}

// The drive planes of a part; null for curves.
const DrivePlanes* planes_of(const TrimInput& input)
{
    return input.part ? &input.part->planes : nullptr;
}

}  // namespace

TrimResult trim_by(const TrimmingMethod& method, const TrimInput& input,
                   const TrimOptions& options)
{
    using Clock = std::chrono::steady_clock;
    TrimResult result;
    result.method = std::string{method.name};
    const std::string name = "method " + result.method + ": ";
    const auto after = [&](TrimStage stage) {
        return work_after(stage, input, options, method.name);
    };
    ProgressLine progress{name + "trimming", options.common, after(TrimStage::Trimming)};
    result.options = trimming_options(options, section_height(input.sections));
    const OffsetPart* const surfaces = input.offset_part();
    const auto start = Clock::now();
    result.trimmed =
        input.dropped_part()
            ? untrimmed_planes(input.sections)
            : trimmed_sections(input, method, result.options, progress.shower());
    result.trim_ms =
        std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    progress.begin(name + "comparing with the envelope");
    if (method_name(options) == "all" && !input.dropped_part())
        result.comparison =
            compare_with_envelope(input.sections, result.trimmed, options.tolerance);
    progress.begin(name + (options.refine ? "refining" : "measuring the sampling error"),
                   after(TrimStage::Sampling));
    if (surfaces)
        measure_sampling(*surfaces, input, options, progress, result);
    progress.begin(name + "listing the loops", after(TrimStage::Loops));
    for (std::size_t k = 0; k < result.trimmed.size(); ++k) {
        result.loops.push_back(cut_out(
            input.sections[k].curves, result.trimmed[k],
            surfaces ? crease_test(surfaces->offset, input.sections[k]) : CreaseTest{}));
        progress.show(static_cast<double>(k + 1) /
                      static_cast<double>(result.trimmed.size()));
    }
    progress.begin(name + "measuring the clearance", after(TrimStage::Clearance));
    if (input.part) {
        measure_clearance(*input.part, options, progress, result);
        progress.begin(name + "linking the path", after(TrimStage::Linking));
        add_tool_path(*input.part, options, progress, result);
    }
    if (input.curves)
        measure_clearance(*input.curves, options, progress, result);
    return result;
}

namespace {

// Writes a table of `rows` rows in pieces, and shows the share that is written.
void write_in_pieces(OutputFolder& folder, const std::string& name,
                     ProgressLine& progress, std::size_t rows,
                     const std::function<void(const OutputFolder::Sink&)>& produce)
{
    double written = 0;
    folder.write_pieces(name, [&](const OutputFolder::Sink& sink) {
        produce([&](std::string_view piece) {
            sink(piece);
            written += static_cast<double>(std::ranges::count(piece, '\n'));
            progress.show(written / static_cast<double>(rows + 1));  // with the header
        });
    });
}

std::size_t trimmed_points(const TrimResult& result)
{
    std::size_t points = 0;
    for (const Trimmed& plane : result.trimmed)
        for (const TrimmedCurve& curve : plane.curves)
            points += curve.points.size();
    return points;
}

std::size_t points_before(const TrimInput& input)
{
    std::size_t points = 0;
    for (const PlaneSection& plane : input.sections)
        for (const SectionCurve& curve : plane.curves)
            points += curve.points.size();
    return points;
}

}  // namespace

Json write_trimmed(const TrimResult& result, const TrimInput& input,
                   const TrimOptions& options, OutputFolder& folder,
                   const std::string& prefix)
{
    const auto after = [&](TrimStage stage) {
        return work_after(stage, input, options, result.method);
    };
    ProgressLine progress{"writing the trimmed curves", options.common,
                          after(TrimStage::WritingCurves)};
    write_in_pieces(folder, prefix + "trimmed.csv", progress, trimmed_points(result),
                    [&](const OutputFolder::Sink& sink) {
                        write_trimmed_csv(result.trimmed, planes_of(input), sink);
                    });
    folder.write(prefix + "loops.csv",
                 loops_csv(result.loops, options.explain ? LoopColumns::CauseAndRule
                                                         : LoopColumns::Cause));
    ContentSha256 path_sum;
    if (input.part) {
        progress.begin("writing the path", after(TrimStage::WritingPath));
        write_in_pieces(folder, prefix + "toolpath.csv", progress,
                        result.path.points.size(), [&](const OutputFolder::Sink& sink) {
                            write_tool_path_csv(result.path, [&](std::string_view piece) {
                                path_sum.add(piece);
                                sink(piece);
                            });
                        });
    }
    if (options.figure) {
        const auto plane = static_cast<std::size_t>(*options.figure);
        folder.write(prefix + fmt::format("section-{}.svg", plane),
                     section_picture(result, input, options, plane));
        folder.write(prefix + "trimmed.svg", trimmed_picture(result, input));
    }
    Json summary = trim_summary(input, options, result);
    if (input.part) {
        name_part(summary, options.part, folder.path() / prefix);
        identify_path(summary, result.path.points.size(), path_sum.word());
    }
    folder.write(prefix + "summary.json", summary.dump(2) + "\n");
    return summary;
}

namespace {

// Names of the pictures of planes of an earlier run in a folder, of any plane.
std::vector<std::string> section_pictures(const std::filesystem::path& folder)
{
    static const std::regex picture{R"((section|methods)-\d+\.svg)"};
    std::vector<std::string> names;
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator{folder, failed})
        if (std::string name = entry.path().filename().string();
            std::regex_match(name, picture))
            names.push_back(std::move(name));
    return names;
}

}  // namespace

void write_sections(const TrimInput& input, const TrimOptions& options,
                    OutputFolder& folder)
{
    ProgressLine progress{"writing the sections", options.common,
                          work_after(TrimStage::WritingSections, input, options)};
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
    for (const char* name : {"times.csv", "differences.csv", "comparison.svg"})
        folder.remove_unless_written(name);
    write_in_pieces(folder, "sections.csv", progress, points_before(input),
                    [&](const OutputFolder::Sink& sink) {
                        write_sections_csv(input.sections, planes_of(input), sink);
                    });
}

}  // namespace endmill
