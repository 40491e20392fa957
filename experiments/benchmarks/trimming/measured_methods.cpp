// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/trimming/measured_methods.h"

#include <algorithm>

#include "endmill/trimming/detail/distance_trimming.h"
#include "endmill/trimming/detail/fold_scan.h"
#include "support/cpu_time.h"
#include "support/timed_trimming.h"

namespace endmill {
namespace {

constexpr double ms = 1e3;
constexpr double allowed_share = 1.5;  // of the reference times
constexpr double march_bar = 1.15;     // of the time of method 2

// CPU times in s of slicing and of each method.
std::vector<double> times_of(const OffsetSections& offset, const MeasuredMethods& methods)
{
    constexpr double budget_s = 0.01;
    const TrimmingOptions options = literal_trimming(methods.step_mm);
    return shortest_in_turns(methods.kinds.size(), [&](std::size_t k) {
        const std::string& kind = methods.kinds[k];
        if (kind != "slicing")
            return trimming_s(offset.sections, timed_method(kind, options), budget_s);
        return shortest_cpu_s(
            budget_s, [&] { return slice(offset.offset.mesh, offset.planes).size(); });
    });
}

}  // namespace

void add_measured(CsvTable& result, const std::string& row, double measured,
                  const std::string& unit, const CsvCell& bar)
{
    CsvCell ratio;
    if (const double* const most = std::get_if<double>(&bar))
        ratio = measured / *most;
    result.add_row({row, measured, unit, bar, ratio});
}

void add_offset(CsvTable& result, const std::string& place, const SectionPlan& plan,
                const MeasuredMethods& methods)
{
    const auto& kinds = methods.kinds;
    const auto times = times_of(offset_sections(plan), methods);
    const auto time = [&](std::string_view kind) {
        const auto found = std::ranges::find(kinds, kind);
        return times.at(static_cast<std::size_t>(found - kinds.begin()));
    };
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const std::string what = kinds[k] == "slicing" ? ", " : ", method ";
        add_measured(result, place + what + kinds[k], ms * times[k], "ms",
                     allowed_share * methods.stated_ms.at(k));
    }
    add_measured(result, place + ", march to method 2", time("3 march") / time("2"),
                 "times", march_bar);
}

void add_search(CsvTable& result, const std::string& place, const SectionPlan& plan)
{
    constexpr double budget_s = 0.5;
    constexpr double coarse_share = 1.0 / 1000;  // of the radius
    const OffsetSections offset = offset_sections(plan);
    const auto folds = first_literal_folds(offset.sections);
    const auto time = [&](double step) {
        return shortest_cpu_s(budget_s, [&] {
            return crossings(folds, search_by_distance, literal_trimming(step));
        });
    };
    const double coarse = coarse_share * plan.cutter.radius();
    add_measured(result, place + ", search at half the step",
                 time(coarse / 2) / time(coarse), "times", "1.7 to 2.3");
}

}  // namespace endmill
