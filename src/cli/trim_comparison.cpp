// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trim_comparison.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "endmill/core/text.h"
#include "endmill/trimming/trimmed_planes.h"

namespace endmill {
namespace {

constexpr std::size_t most_planes_shown = 12;

// Whether the curve of a plane differs from the exact one by more than the tolerance.
bool differs(const CurveDifference& difference, double tolerance)
{
    return difference.distance_mm > tolerance || !is_right(difference, tolerance);
}

// Runs `method` once, in this process: times that include messages between ranks would not
// compare the methods. Returns the wall time in ms.
double run(const TrimmingMethod& method, const TrimInput& input,
           const TrimmingOptions& options, std::vector<Trimmed>& trimmed)
{
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    trimmed = trim_planes(input.sections, input.ranges(), method, options);
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// The methods to compare: all, or those of --compare-only and the exact one.
std::vector<TrimmingMethod> compared_methods(const TrimOptions& options)
{
    std::vector<TrimmingMethod> compared;
    for (const TrimmingMethod& method : trimming_methods())
        if (options.compare_only.empty() || method.name == exact_method ||
            std::ranges::find(options.compare_only, method.name) !=
                options.compare_only.end())
            compared.push_back(method);
    return compared;
}

// Runs the methods `known` --repeat times, each repetition beginning with another one.
void time_methods(const TrimInput& input, std::span<const TrimmingMethod> known,
                  const TrimOptions& options, std::vector<MethodRuns>& methods,
                  ProgressLine& progress)
{
    const TrimmingOptions trimming =
        trimming_options(options, section_height(input.sections));
    const int repetitions = options.repeat.value_or(0);
    const auto count = static_cast<std::size_t>(repetitions);
    for (std::size_t repetition = 0; repetition < count; ++repetition)
        for (std::size_t k = 0; k < known.size(); ++k) {
            const std::size_t number = (repetition + k) % known.size();
            MethodRuns& method = methods[number];
            const auto done = static_cast<double>(repetition * known.size() + k);
            progress.show(fmt::format("repetition {} of {}, method {}", repetition + 1,
                                      repetitions, method.name),
                          done / static_cast<double>(count * known.size()));
            method.times_ms.push_back(
                run(known[number], input, trimming, method.trimmed));
        }
}

// The plane in which the method is farthest from the exact curve.
std::size_t farthest_plane(const MethodRuns& method)
{
    const auto farthest =
        std::ranges::max_element(method.differences, {}, &CurveDifference::distance_mm);
    return static_cast<std::size_t>(farthest - method.differences.begin());
}

Json times_summary(const MethodRuns& method)
{
    const TimeSpread spread = time_spread(method.times_ms);
    return {{"median_ms", spread.median},
            {"lower_quartile_ms", spread.lower_quartile},
            {"upper_quartile_ms", spread.upper_quartile},
            {"least_ms", spread.least},
            {"greatest_ms", spread.greatest}};
}

Json differences_summary(const MethodRuns& method, double tolerance)
{
    Json planes = Json::array();
    Json wrong = Json::array();
    double below = 0;
    double lost = 0;
    for (std::size_t k = 0; k < method.differences.size(); ++k) {
        const CurveDifference& difference = method.differences[k];
        below = std::max(below, difference.below_mm);
        lost = std::max(lost, difference.lost_mm);
        if (differs(difference, tolerance))
            planes.push_back(k);
        if (!is_right(difference, tolerance))
            wrong.push_back(k);
    }
    const std::size_t worst = farthest_plane(method);
    const CurveDifference& farthest = method.differences[worst];
    const bool has_difference = farthest.distance_mm > step_back_on_parts_mm;
    return {{"planes", std::move(planes)},
            {"wrong_planes", std::move(wrong)},
            {"distance_mm", farthest.distance_mm},
            {"distance_plane", has_difference ? Json(worst) : Json(nullptr)},
            {"distance_s_mm", has_difference ? Json(farthest.place.x()) : Json(nullptr)},
            {"distance_z_mm", has_difference ? Json(farthest.place.y()) : Json(nullptr)},
            {"below_mm", below},
            {"lost_mm", lost}};
}

// A range of depths of interference, from the bound of the class before it.
struct DepthClass {
    const char* key;
    double below_mm;
};

// The first class has no interference beyond the rounding of coordinates.
constexpr std::array depth_classes{
    DepthClass{"none", step_back_on_parts_mm}, DepthClass{"below_10_um", 0.01},
    DepthClass{"below_100_um", 0.1}, DepthClass{"below_1_mm", 1},
    DepthClass{"from_1_mm", std::numeric_limits<double>::infinity()}};

// The number of the planes in `chosen` that each method trims wrongly.
Json wrong_counts(std::span<const MethodRuns> methods,
                  std::span<const std::size_t> chosen, double tolerance)
{
    Json counts = Json::object();
    for (const MethodRuns& method : methods)
        counts[std::string{method.name}] =
            std::ranges::count_if(chosen, [&](std::size_t plane) {
                return !is_right(method.differences[plane], tolerance);
            });
    return counts;
}

// For each class of depths the planes in it, and the wrong ones by method.
Json by_depth(std::span<const MethodRuns> methods, std::span<const double> depths,
              double tolerance)
{
    std::array<std::vector<std::size_t>, depth_classes.size()> planes;
    for (std::size_t k = 0; k < depths.size(); ++k) {
        const auto found = std::ranges::find_if(
            depth_classes, [&](double bound) { return depths[k] < bound; },
            &DepthClass::below_mm);
        planes[static_cast<std::size_t>(found - depth_classes.begin())].push_back(k);
    }
    Json summary;
    for (std::size_t i = 0; i < planes.size(); ++i)
        summary[depth_classes[i].key] = {
            {"planes", planes[i].size()},
            {"wrong", wrong_counts(methods, planes[i], tolerance)}};
    return summary;
}

// Numbers as ranges, such as "3-5, 91", up to a number of ranges.
std::string plane_ranges(const Json& planes)
{
    std::string text;
    std::size_t shown_ranges = 0;
    for (std::size_t i = 0; i < planes.size(); ++shown_ranges) {
        if (shown_ranges == most_planes_shown)
            return text + ", and more (differences.csv)";
        std::size_t last = i;
        while (last + 1 < planes.size() &&
               planes[last + 1].get<std::size_t>() == planes[last].get<std::size_t>() + 1)
            ++last;
        text += (text.empty() ? "" : ", ") + std::to_string(planes[i].get<std::size_t>());
        if (last > i)
            text += (last > i + 1 ? "-" : ", ") +
                    std::to_string(planes[last].get<std::size_t>());
        i = last + 1;
    }
    return text;
}

std::string times_text(const Json& comparison)
{
    constexpr const char* row = "{:<10}{:>11}{:>20}{:>14}\n";
    const Json& measured = comparison["measured"];
    double fastest = std::numeric_limits<double>::infinity();
    for (const auto& [name, times] : measured.items())
        fastest = std::min(fastest, times["median_ms"].get<double>());
    std::string text =
        fmt::format("times of trimming, measured in {} of each method, in turns\n",
                    counted(comparison["repetitions"].get<std::size_t>(), "run"));
    text += fmt::format(row, "method", "median ms", "quartiles ms", "over fastest");
    for (const auto& [name, times] : measured.items()) {
        const double median = times["median_ms"].get<double>();
        text +=
            fmt::format(row, name, shown_time(median),
                        shown_time(times["lower_quartile_ms"].get<double>()) + " to " +
                            shown_time(times["upper_quartile_ms"].get<double>()),
                        fastest > 0 ? fmt::format("{:.2f}", median / fastest) : "");
    }
    return text;
}

std::string differences_text(const Json& comparison, double tolerance)
{
    constexpr const char* row = "{:<10}{:>8}{:>7}{:>13}{:>10}{:>10}{:>10}\n";
    std::string text = fmt::format(
        "differences from the exact curves (method {}) beyond --tolerance {} mm\n",
        exact_method, shown_limit(tolerance));
    text += fmt::format(row, "method", "planes", "wrong", "distance mm", "in plane",
                        "below mm", "lost mm");
    std::string lists;
    std::string right;
    for (const auto& [name, s] : comparison["differences"].items()) {
        const Json& plane = s["distance_plane"];
        text += fmt::format(
            row, name, s["planes"].size(), s["wrong_planes"].size(),
            shown(s["distance_mm"].get<double>()),
            plane.is_null() ? "" : std::to_string(plane.get<std::size_t>()),
            shown(s["below_mm"].get<double>()), shown(s["lost_mm"].get<double>()));
        if (!s["wrong_planes"].empty())
            lists += fmt::format("method {}: wrong in {} {}\n", name,
                                 s["wrong_planes"].size() == 1 ? "plane" : "planes",
                                 plane_ranges(s["wrong_planes"]));
        else
            right += (right.empty() ? "" : ", ") + name;
    }
    return text + lists + "right in every plane: " + right + "\n" +
           "distance: largest distance of the two curves; below: depth below the exact "
           "curve;\nlost: length in s without a path; wrong: below or lost beyond the "
           "tolerance, or s steps back\n";
}

}  // namespace

TimeSpread time_spread(std::vector<double> times_ms)
{
    std::ranges::sort(times_ms);
    const auto at_share = [&](double share) {
        const double place = share * static_cast<double>(times_ms.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const std::size_t above = std::min(below + 1, times_ms.size() - 1);
        return std::lerp(times_ms[below], times_ms[above],
                         place - static_cast<double>(below));
    };
    return {at_share(0.5), at_share(0.25), at_share(0.75), times_ms.front(),
            times_ms.back()};
}

std::vector<MethodRuns> run_methods(const TrimInput& input, const TrimOptions& options)
{
    ProgressLine progress{"comparing the methods", options.common};
    const TrimmingOptions trimming =
        trimming_options(options, section_height(input.sections));
    std::vector<MethodRuns> methods;
    const std::vector<TrimmingMethod> known = compared_methods(options);
    for (const TrimmingMethod& method : known) {
        methods.push_back({method.name, {}, {}, {}});
        run(method, input, trimming, methods.back().trimmed);
    }
    time_methods(input, known, options, methods, progress);
    const auto exact = std::ranges::find(methods, exact_method, &MethodRuns::name);
    for (MethodRuns& method : methods) {
        progress.show(fmt::format("differences of method {}", method.name));
        method.differences =
            differences_from_exact(input.sections, exact->trimmed, method.trimmed);
    }
    return methods;
}

std::size_t worst_plane(std::span<const MethodRuns> methods)
{
    std::size_t worst = 0;
    double farthest = 0;
    for (const MethodRuns& method : methods) {
        const std::size_t plane = farthest_plane(method);
        const double distance = method.differences[plane].distance_mm;
        if (distance > farthest || (distance == farthest && plane < worst)) {
            worst = plane;
            farthest = distance;
        }
    }
    return worst;
}

Json comparison_summary(std::span<const MethodRuns> methods, const TrimInput& input,
                        const TrimOptions& options)
{
    Json summary{{"repetitions", options.repeat.value_or(0)},
                 {"exact_method", exact_method},
                 {"tolerance_mm", options.tolerance}};
    Json right = Json::array();
    for (const MethodRuns& method : methods) {
        const std::string name{method.name};
        if (!method.times_ms.empty())
            summary["measured"][name] = times_summary(method);
        Json differences = differences_summary(method, options.tolerance);
        if (differences["wrong_planes"].empty())
            right.push_back(name);
        summary["differences"][name] = std::move(differences);
    }
    summary["right_in_every_plane"] = std::move(right);
    summary["by_depth"] =
        by_depth(methods, interference_depths(input.sections), options.tolerance);
    return summary;
}

std::string comparison_text(const Json& comparison, const TrimOptions& options)
{
    return (comparison.contains("measured") ? times_text(comparison) + "\n" : "") +
           differences_text(comparison, options.tolerance) + "\n";
}

}  // namespace endmill
