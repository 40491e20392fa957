// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/timed_trimming.h"

#include <algorithm>

#include "endmill/core/error.h"
#include "support/cpu_time.h"

namespace endmill {
namespace {

constexpr std::string_view sequence_method = "3";  // uses TrimmingOptions::search

constexpr double threshold_in_steps = 4;  // of method 1

}  // namespace

const TrimmingMethod& trimming_method(std::string_view name)
{
    const auto methods = trimming_methods();
    const auto found = std::ranges::find(methods, name, &TrimmingMethod::name);
    require(found != methods.end(), "there is no such trimming method");
    return *found;
}

TrimmingOptions literal_trimming(double step)
{
    return {.detection = FoldDetection::Literal,
            .scan_step = step,
            .scan_threshold = threshold_in_steps * step};
}

std::vector<TimedMethod> timed_methods(const TrimmingOptions& options)
{
    std::vector<TimedMethod> timed;
    for (const TrimmingMethod& method : trimming_methods()) {
        const std::string name{method.name};
        if (method.name != sequence_method) {
            timed.push_back({name, &method, options});
            continue;
        }
        for (const auto& [word, search] : {std::pair{" scan", BranchSearch::Scan},
                                           std::pair{" march", BranchSearch::March}}) {
            TrimmingOptions its = options;
            its.search = search;
            timed.push_back({name + word, &method, its});
        }
    }
    return timed;
}

TimedMethod timed_method(const std::string& label, const TrimmingOptions& options)
{
    const auto methods = timed_methods(options);
    const auto found = std::ranges::find(methods, label, &TimedMethod::label);
    require(found != methods.end(), "there is no such trimming method");
    return *found;
}

double trimming_s(const std::vector<PlaneSection>& sections, const TimedMethod& timed,
                  double budget_s)
{
    return shortest_cpu_s(budget_s, [&] {
        std::size_t left = 0;
        for (const PlaneSection& section : sections)
            left += timed.method->trim(section.curves, timed.options).curves.size();
        return left;
    });
}

}  // namespace endmill
