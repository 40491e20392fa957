// SPDX-License-Identifier: GPL-3.0-or-later
#include "interference/table-1/measured_times.h"

#include <algorithm>

#include "endmill/core/text.h"
#include "interference/table-1/printed_times.h"
#include "support/cpu_time.h"
#include "support/named_cells.h"
#include "support/offset_sections.h"
#include "support/printed_search.h"
#include "support/timed_trimming.h"

namespace endmill {
namespace {

constexpr double ms = 1e3;

// A value for all planes and for half of them.
template <typename Value>
struct AllAndHalf {
    Value all;
    Value half;
};

// The sections of one offset with the time of slicing.
struct Sliced {
    AllAndHalf<std::vector<PlaneSection>> sections;
    AllAndHalf<double> time_s;
};

Sliced sliced_by_all_and_half(const SectionPlan& plan)
{
    const OffsetSections offset = offset_sections(plan);
    const DrivePlanes fewer = planes_over(plan, plan.planes / 2);
    const auto slicing_s = [&](const DrivePlanes& planes) {
        constexpr double budget_s = 0.2;
        return shortest_cpu_s(budget_s,
                              [&] { return slice(offset.offset.mesh, planes).size(); });
    };
    return {{offset.sections, slice(offset.offset.mesh, fewer)},
            {slicing_s(offset.planes), slicing_s(fewer)}};
}

// The methods of params.json, method 3 with the printed range of its search, and method 1
// with another step.
std::vector<TimedMethod> methods_of(Experiment& run)
{
    std::vector<TimedMethod> methods;
    for (const std::string& label : run.texts("methods"))
        methods.push_back(timed_method(label, literal_trimming(run.number("step_mm"))));
    methods.push_back({"3 to end", &printed_method_3(), printed_options});
    methods.push_back(
        timed_method("1", literal_trimming(run.number("calibrated_step_mm"))));
    methods.back().label = "1, calibrated";
    return methods;
}

std::vector<AllAndHalf<double>> trimming_times(const Sliced& sliced,
                                               const std::vector<TimedMethod>& methods)
{
    constexpr double budget_s = 0.01;
    const auto times = shortest_in_turns(2 * methods.size(), [&](std::size_t k) {
        const auto& [all, half] = sliced.sections;
        return trimming_s(k % 2 == 0 ? all : half, methods[k / 2], budget_s);
    });
    std::vector<AllAndHalf<double>> pairs;
    for (std::size_t k = 0; k < times.size(); k += 2)
        pairs.push_back({times[k], times[k + 1]});
    return pairs;
}

NamedCells time_cells(const AllAndHalf<double>& trim, const AllAndHalf<double>& slicing)
{
    const auto [all, half] = trim;
    const double ratio = all / half;
    const double all_sliced = all + slicing.all;
    const double half_sliced = half + slicing.half;
    return {{"trim_100_ms", ms * all},
            {"trim_50_ms", ms * half},
            {"ratio_100_to_50", ratio},
            {"proportional_to_planes", word(contains(proportional_ratio, ratio))},
            {"with_slicing_100_ms", ms * all_sliced},
            {"with_slicing_50_ms", ms * half_sliced},
            {"with_slicing_100_to_50", all_sliced / half_sliced}};
}

// The ratios to the times of method 2, and whether the printed seconds allow them.
// \param number of the method in the paper.
NamedCells ratio_cells(const AllAndHalf<double>& trim, const AllAndHalf<double>& by_lines,
                       std::size_t number)
{
    const double all = trim.all / by_lines.all;
    const double half = trim.half / by_lines.half;
    const auto is_printed = [&](const char* column, double ratio) {
        return word(contains(printed_ratio({number, column}, {2, column}), ratio));
    };
    return {{"over_method_2", all},
            {"over_method_2_at_50", half},
            {"within_print", is_printed(seconds_100, all)},
            {"within_print_at_50", is_printed(seconds_50, half)}};
}

// The number in the paper of the method with this label, such as "3 scan".
std::size_t number_in_paper(const std::string& label)
{
    return static_cast<std::size_t>(label.front() - '0');
}

}  // namespace

void add_measured(Experiment& run, CsvTable& result, double feed_deg)
{
    const Sliced sliced = sliced_by_all_and_half(
        {run.text("surface"), Cutter::ball(run.number("radius_mm")), feed_deg,
         static_cast<int>(run.number("grid_lines"))});
    const auto methods = methods_of(run);
    const auto times = trimming_times(sliced, methods);
    const auto by_lines = std::ranges::find(methods, "2", &TimedMethod::label);
    const auto& line_times = times[static_cast<std::size_t>(by_lines - methods.begin())];
    const std::string prefix = "at " + to_text(feed_deg) + " deg, ";
    std::string fastest;
    double least_s = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const std::string& label = methods[i].label;
        NamedCells cells =
            joined(time_cells(times[i], sliced.time_s),
                   ratio_cells(times[i], line_times, number_in_paper(label)));
        if (methods[i].method->name == "1")
            cells.emplace_back("step_mm", methods[i].options.scan_step);
        add_named(result, prefix + "method " + label, cells);
        const bool is_in_paper = label == "1" || label == "2" || label == "3 to end";
        if (is_in_paper && times[i].all < least_s) {
            least_s = times[i].all;
            fastest = method_name(number_in_paper(label));
        }
    }
    add_named(result, prefix + "fastest", {{"method", fastest}});
}

}  // namespace endmill
