// SPDX-License-Identifier: GPL-3.0-or-later
#include "interference/increment/scan_rows.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "endmill/core/text.h"
#include "endmill/trimming/detail/distance_trimming.h"
#include "endmill/trimming/detail/fold_scan.h"
#include "endmill/trimming/detail/line_trimming.h"
#include "endmill/trimming/detail/sequence_trimming.h"
#include "support/cpu_time.h"
#include "support/named_cells.h"

namespace endmill {
namespace {

using Crossings = std::vector<std::optional<ChainCrossing>>;

constexpr double threshold_in_steps = 4;  // in the columns ..._at_4
constexpr double budget_s = 0.03;         // time of one measurement

double search_s(const std::vector<FoldToSearch>& folds, CrossingSearch* search,
                const TrimmingOptions& options)
{
    return shortest_cpu_s(budget_s, [&] { return crossings(folds, search, options); });
}

TrimmingOptions scan(double step, double threshold)
{
    return {.detection = FoldDetection::Literal,
            .scan_step = step,
            .scan_threshold = threshold};
}

CsvCell count(std::ptrdiff_t value)
{
    return static_cast<std::int64_t>(value);
}

// Whether method 2 may be used by its own condition: the lines through the cusps, L1 and
// L3, meet the branches, and the segments that they meet lie on lines that cross the other
// branch.
// Source: [JangKimJeong, section IV.2].
bool meets_condition(const FoldToSearch& fold)
{
    const auto& [chain, branches] = fold;
    const auto on_a =
        first_meeting_of_a(chain, branches, 0, chain.at(branches.cusp_b).x());
    const auto on_b =
        first_meeting_of_b(chain, branches, 0, chain.at(branches.cusp_a).x());
    return on_a && on_b && first_crossed_of_b(chain, branches, on_a->segment) &&
           first_crossed_of_a(chain, branches, on_b->segment);
}

// The crossings that a method finds, compared with those of method 3.
NamedCells found_cells(const std::vector<FoldToSearch>& folds, const Crossings& found,
                       const Crossings& truth)
{
    std::ptrdiff_t hits = 0;
    std::ptrdiff_t missed = 0;
    std::ptrdiff_t in_condition = 0;
    std::ptrdiff_t missed_in_condition = 0;
    std::ptrdiff_t false_hits = 0;
    for (std::size_t i = 0; i < folds.size(); ++i) {
        const bool is_missed = truth[i] && !found[i];
        hits += found[i] ? 1 : 0;
        missed += is_missed ? 1 : 0;
        const bool is_in_condition = truth[i] && meets_condition(folds[i]);
        in_condition += is_in_condition ? 1 : 0;
        missed_in_condition += is_missed && is_in_condition ? 1 : 0;
        false_hits += found[i] && !truth[i] ? 1 : 0;
    }
    return {{"folds", count(std::ssize(folds))},
            {"hits_at_4", count(hits)},
            {"missed_at_4", count(missed)},
            {"false_hits_at_4", count(false_hits)},
            {"crossings_in_condition", count(in_condition)},
            {"missed_in_condition", count(missed_in_condition)}};
}

// Adds the rows of methods 2 and 3, which find the crossings exactly.
// \return the search time of method 2, in s.
double add_references(CsvTable& result, const std::string& name,
                      const std::vector<FoldToSearch>& folds, const Crossings& truth)
{
    const TrimmingOptions plain = scan(1, 1);
    const double by_lines_s = search_s(folds, search_by_lines, plain);
    const std::pair<const char*, CrossingSearch*> references[]{{"2", search_by_lines},
                                                               {"3", march_segments}};
    for (const auto& [method, search] : references) {
        NamedCells cells = found_cells(folds, crossings(folds, search, plain), truth);
        cells.emplace_back("search_over_method_2",
                           search_s(folds, search, plain) / by_lines_s);
        add_named(result, name + ", method " + method, cells);
    }
    return by_lines_s;
}

// The extremes over all steps of method 1.
struct Extremes {
    Interval missed{std::numeric_limits<double>::infinity(), 0};
    Interval missed_at_4 = missed;
    Interval lines = missed;
    Interval time = missed;
};

void extend(Interval& range, double value)
{
    range = {std::min(range.low, value), std::max(range.high, value)};
}

}  // namespace

void add_scans(CsvTable& result, const std::string& feed, const OffsetSections& offset,
               const std::vector<double>& steps_mm)
{
    const auto folds = first_literal_folds(offset.sections);
    const Crossings truth = crossings(folds, march_segments, scan(1, 1));
    const double by_lines_s = add_references(result, feed, folds, truth);
    Extremes all;
    for (const double step : steps_mm) {
        const TrimmingOptions wide = scan(step, threshold_in_steps * step);
        const ScanOutcome one = scan_outcome(folds, truth, scan(step, step));
        const ScanOutcome four = scan_outcome(folds, truth, wide);
        const double time = search_s(folds, search_by_distance, wide) / by_lines_s;
        add_named(result, feed + ", step " + to_text(step),
                  {{"folds", count(std::ssize(folds))},
                   {"hits", count(one.hits)},
                   {"missed", count(one.missed)},
                   {"lines_a_fold", one.lines},
                   {"error_mm", one.error_mm},
                   {"hits_at_4", count(four.hits)},
                   {"missed_at_4", count(four.missed)},
                   {"false_hits_at_4", count(four.false_hits)},
                   {"lines_a_fold_at_4", four.lines},
                   {"error_at_4_mm", four.error_mm},
                   {"search_over_method_2", time}});
        extend(all.missed, one.missed);
        extend(all.missed_at_4, four.missed);
        extend(all.lines, four.lines);
        extend(all.time, time);
    }
    add_named(result, feed + ", all steps",
              {{"fewest_missed", all.missed.low},
               {"most_missed", all.missed.high},
               {"most_missed_at_4", all.missed_at_4.high},
               {"lines_ratio", all.lines.high / all.lines.low},
               {"time_ratio", all.time.high / all.time.low}});
}

void add_planar_folds(CsvTable& result, const std::string& name,
                      const std::vector<OffsetProfile>& profiles, int points)
{
    std::vector<PlaneSection> sections(profiles.size());
    for (std::size_t k = 0; k < profiles.size(); ++k)
        sections[k].curves.push_back(offset_curve(profiles[k], points));
    const auto folds = first_literal_folds(sections);
    const Crossings truth = crossings(folds, march_segments, scan(1, 1));
    add_references(result, name, folds, truth);
}

}  // namespace endmill
