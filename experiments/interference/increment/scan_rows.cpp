// SPDX-License-Identifier: GPL-3.0-or-later
#include "interference/increment/scan_rows.h"

#include <algorithm>
#include <cstdint>

#include "endmill/core/text.h"
#include "endmill/trimming/detail/distance_trimming.h"
#include "endmill/trimming/detail/fold_scan.h"
#include "endmill/trimming/detail/line_trimming.h"
#include "endmill/trimming/detail/sequence_trimming.h"
#include "support/cpu_time.h"
#include "support/named_cells.h"

namespace endmill {
namespace {

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

// The rows of methods 2 and 3, which find the crossings exactly.
void add_references(CsvTable& result, const std::string& feed,
                    const std::vector<FoldToSearch>& folds, double by_lines_s)
{
    const TrimmingOptions plain = scan(1, 1);
    const std::pair<const char*, CrossingSearch*> references[]{{"2", search_by_lines},
                                                               {"3", march_segments}};
    for (const auto& [name, search] : references) {
        const auto found = crossings(folds, search, plain);
        const auto hits = std::ranges::count_if(
            found, [](const auto& crossing) { return crossing.has_value(); });
        add_named(
            result, feed + ", method " + name,
            {{"folds", count(std::ssize(folds))},
             {"hits_at_4", count(hits)},
             {"missed_at_4", 0.0},
             {"search_over_method_2", search_s(folds, search, plain) / by_lines_s}});
    }
}

}  // namespace

void add_scans(CsvTable& result, const std::string& feed, const OffsetSections& offset,
               const std::vector<double>& steps_mm)
{
    const auto folds = first_literal_folds(offset.sections);
    const auto truth = crossings(folds, march_segments, scan(1, 1));
    const double by_lines_s = search_s(folds, search_by_lines, scan(1, 1));
    add_references(result, feed, folds, by_lines_s);
    for (const double step : steps_mm) {
        const TrimmingOptions wide = scan(step, threshold_in_steps * step);
        const ScanOutcome one = scan_outcome(folds, truth, scan(step, step));
        const ScanOutcome four = scan_outcome(folds, truth, wide);
        result.add_row({feed + ", step " + to_text(step), count(std::ssize(folds)),
                        count(one.hits), count(one.missed), one.lines, one.error_mm,
                        count(four.hits), count(four.missed), count(four.false_hits),
                        four.lines, four.error_mm,
                        search_s(folds, search_by_distance, wide) / by_lines_s});
    }
}

}  // namespace endmill
