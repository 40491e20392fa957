// SPDX-License-Identifier: GPL-3.0-or-later
// Table 1 of Jang, Kim and Jeong: the times of the three methods at 50 and 100 planes,
// the conclusions that the printed times support, and our times on a part of this
// project.
//
//   interference-table-1 OUTPUT_FOLDER
//
// Under 10 s; measures time, so nothing else should run. Columns: README.md beside this.

#include <algorithm>

#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "support/cpu_time.h"
#include "support/experiment.h"
#include "support/offset_sections.h"
#include "support/timed_trimming.h"

using namespace endmill;

namespace {

constexpr double ms = 1e3;
constexpr double budget_s = 0.01;         // time of one measurement
constexpr double threshold_in_steps = 4;  // of method 1
constexpr double rounding_s = 0.5;        // of the printed seconds
// Range of t(100 planes) / t(50 planes) that counts as proportional.
constexpr double proportional_low = 1.7;
constexpr double proportional_high = 2.3;

// The sections of one offset by all planes and by half of them.
struct Sliced {
    std::vector<PlaneSection> all;
    std::vector<PlaneSection> half;
    double slicing_all_s;
    double slicing_half_s;
};

Sliced slice_both(const SectionPlan& plan)
{
    const OffsetSections offset = offset_sections(plan);
    const DrivePlanes fewer = planes_over(plan, plan.planes / 2);
    const auto slicing_s = [&](const DrivePlanes& planes) {
        constexpr double its_budget_s = 0.2;
        return shortest_cpu_s(its_budget_s,
                              [&] { return slice(offset.offset.mesh, planes).size(); });
    };
    return {offset.sections, slice(offset.offset.mesh, fewer), slicing_s(offset.planes),
            slicing_s(fewer)};
}

TrimmingOptions literal(double step)
{
    return {.detection = FoldDetection::Literal,
            .scan_step = step,
            .scan_threshold = threshold_in_steps * step};
}

bool is_proportional(double ratio)
{
    return proportional_low <= ratio && ratio <= proportional_high;
}

// Times to trim the sections by all planes, and by half of them.
struct TrimTime {
    double all_s = std::numeric_limits<double>::infinity();
    double half_s = std::numeric_limits<double>::infinity();
};

// The methods are measured alternately, so that other processes disturb all of them
// equally.
std::vector<TrimTime> shortest(const Sliced& sliced,
                               const std::vector<TimedMethod>& methods)
{
    constexpr int turns = 25;
    std::vector<TrimTime> times(methods.size());
    for (int turn = 0; turn < turns; ++turn)
        for (std::size_t i = 0; i < methods.size(); ++i) {
            auto& [all_s, half_s] = times[i];
            all_s = std::min(all_s, trimming_s(sliced.all, methods[i], budget_s));
            half_s = std::min(half_s, trimming_s(sliced.half, methods[i], budget_s));
        }
    return times;
}

CsvCell word(bool holds)
{
    return holds ? "yes" : "no";
}

// The times of a method, and the time of method 2 at all planes.
struct TimesOfMethod {
    TrimTime own;
    double by_lines_s;
};

void add_times(CsvTable& result, const std::string& row, const Sliced& sliced,
               const TimedMethod& timed, const TimesOfMethod& times)
{
    const auto [all, half] = times.own;
    const double all_sliced = all + sliced.slicing_all_s;
    const double half_sliced = half + sliced.slicing_half_s;
    const CsvCell step =
        timed.method->name == "1" ? CsvCell{timed.options.scan_step} : CsvCell{};
    result.add_row({row + timed.label,
                    ms * all,
                    ms * half,
                    all / half,
                    word(is_proportional(all / half)),
                    all / times.by_lines_s,
                    ms * all_sliced,
                    ms * half_sliced,
                    all_sliced / half_sliced,
                    step,
                    {},
                    {},
                    {}});
}

// The number of the fastest method among the printed ones.
std::string fastest(const std::vector<TimedMethod>& methods,
                    const std::vector<TrimTime>& times)
{
    double least = std::numeric_limits<double>::infinity();
    std::string number;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const std::string& label = methods[i].label;
        const bool is_printed = label == "1" || label == "2" || label == "3 scan";
        if (is_printed && times[i].all_s < least) {
            least = times[i].all_s;
            number = label.front();
        }
    }
    return number;
}

void add_measured(Experiment& run, CsvTable& result, double feed)
{
    const Sliced sliced =
        slice_both({run.text("surface"), Cutter::ball(run.number("radius_mm")), feed,
                    static_cast<int>(run.number("grid_lines"))});
    const double step = run.number("step_mm");
    std::vector<TimedMethod> methods;
    for (const std::string& label : run.texts("methods"))
        methods.push_back(timed_method(label, literal(step)));
    methods.push_back(timed_method("1", literal(run.number("calibrated_step_mm"))));
    methods.back().label = "1, calibrated";
    const auto times = shortest(sliced, methods);
    const auto by_lines = std::ranges::find(methods, "2", &TimedMethod::label);
    const double by_lines_s =
        times[static_cast<std::size_t>(by_lines - methods.begin())].all_s;
    const std::string prefix = "at " + to_text(feed) + " deg, ";
    for (std::size_t i = 0; i < methods.size(); ++i)
        add_times(result, prefix + "method ", sliced, methods[i], {times[i], by_lines_s});
    std::vector<CsvCell> last(result.columns().size());
    last.front() = prefix + "fastest";
    last.back() = fastest(methods, times);
    result.add_row(last);
}

// Range of a / b when both are rounded.
void add_printed(CsvTable& result, const std::string& row, double a, double b)
{
    std::vector<CsvCell> cells(result.columns().size());
    cells.front() = row;
    const auto set = [&](std::string_view column, double value) {
        const auto place = std::ranges::find(result.columns(), column);
        cells[static_cast<std::size_t>(place - result.columns().begin())] = value;
    };
    set("ratio_least", (a - rounding_s) / (b + rounding_s));
    set("ratio_greatest", (a + rounding_s) / (b - rounding_s));
    result.add_row(cells);
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/table-1", [](Experiment& run) {
        set_thread_count(1);
        CsvTable result{{"row", "trim_100_ms", "trim_50_ms", "ratio_100_to_50",
                         "proportional_to_planes", "over_method_2", "with_slicing_100_ms",
                         "with_slicing_50_ms", "with_slicing_100_to_50", "step_mm",
                         "ratio_least", "ratio_greatest", "method"}};
        for (const double feed : run.numbers("feeds_deg"))
            add_measured(run, result, feed);
        const auto all = run.numbers("printed_100_s");
        const auto half = run.numbers("printed_50_s");
        for (std::size_t k = 0; k < all.size(); ++k)
            add_printed(result, "print, method " + std::to_string(k + 1) + ", 100 to 50",
                        all[k], half.at(k));
        for (const auto& [planes, seconds] :
             {std::pair{"100", all}, std::pair{"50", half}})
            for (const std::size_t k : {0, 1})
                add_printed(result,
                            "print, " + std::string{planes} + " planes, method " +
                                std::to_string(k + 1) + " to " + std::to_string(k + 2),
                            seconds.at(k), seconds.at(k + 1));
        run.write_result(result);
    });
}
