// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/wrong_curves.h"

#include <algorithm>
#include <numeric>

#include "endmill/core/error.h"
#include "endmill/core/orientation.h"
#include "endmill/core/parallel.h"
#include "endmill/trimming/trimming_methods.h"

namespace endmill {
namespace {

// Method 1 of [Jang], the only one with a scan step and a threshold.
constexpr std::string_view scanning_method = "1";

bool cross(const SectionPoint& a, const SectionPoint& b, const SectionPoint& c,
           const SectionPoint& d)
{
    return orientation(a, b, c) * orientation(a, b, d) < 0 &&
           orientation(c, d, a) * orientation(c, d, b) < 0;
}

// Sweep along s: the segments are sorted by their smaller s, and each is compared with
// those that begin before it ends.
bool crosses_itself(const std::vector<SectionPoint>& points)
{
    std::vector<std::size_t> order(points.size() - 1);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto low = [&](std::size_t i) {
        return std::min(points[i].x(), points[i + 1].x());
    };
    std::ranges::sort(order, {}, low);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t one = order[i];
        const double high = std::max(points[one].x(), points[one + 1].x());
        for (std::size_t j = i + 1; j < order.size() && low(order[j]) <= high; ++j) {
            const std::size_t other = order[j];
            if (cross(points[one], points[one + 1], points[other], points[other + 1]))
                return true;
        }
    }
    return false;
}

const TrimmingMethod& method_named(std::string_view name)
{
    const auto methods = trimming_methods();
    const auto found = std::ranges::find(methods, name, &TrimmingMethod::name);
    require(found != methods.end(), "there is no such trimming method");
    return *found;
}

bool is_wrong(const TrimmingTrial& trial, const TrimmingMethod& method,
              const TriedMethod& tried)
{
    TrimmingOptions options;
    options.detection = tried.detection;
    options.patterns = tried.patterns;
    options.scan_step = trial.scan_step_mm;
    options.scan_threshold = trial.scan_threshold_mm;
    TrimmingTolerance tolerance = trial.tolerance;
    if (method.name == scanning_method)
        tolerance.gouge_mm = trial.scan_gouge_mm;
    const std::span curves{&trial.curve, 1};
    return !is_right(trimming_quality(curves, method.trim(curves, options)), tolerance);
}

// Number of the trials for which `test` holds.
template <typename Test>
std::size_t count_of(std::span<const TrimmingTrial> trials, const Test& test)
{
    std::vector<char> holds(trials.size());
    parallel_for(trials.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            holds[i] = test(trials[i]) ? 1 : 0;
    });
    return static_cast<std::size_t>(std::ranges::count(holds, 1));
}

}  // namespace

std::vector<TriedMethod> tried_methods()
{
    std::vector<TriedMethod> tried;
    for (const FoldDetection detection : {FoldDetection::Literal, FoldDetection::Guarded})
        for (const TrimmingMethod& method : trimming_methods())
            if (method.has_detection) {
                const bool is_literal = detection == FoldDetection::Literal;
                tried.push_back(
                    {(is_literal ? "literal " : "guarded ") + std::string{method.name},
                     std::string{method.name}, detection});
            }
    for (const TrimmingMethod& method : trimming_methods())
        if (!method.has_detection)
            tried.push_back({std::string{method.name}, std::string{method.name},
                             FoldDetection::Guarded});
    return tried;
}

std::size_t wrong_curves(std::span<const TrimmingTrial> trials, const TriedMethod& method)
{
    const TrimmingMethod& trimming = method_named(method.method);
    return count_of(trials, [&](const TrimmingTrial& trial) {
        return is_wrong(trial, trimming, method);
    });
}

std::size_t crossing_curves(std::span<const TrimmingTrial> trials)
{
    return count_of(trials, [](const TrimmingTrial& trial) {
        return crosses_itself(trial.curve.points);
    });
}

}  // namespace endmill
