// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 9 of Jang, Kim and Jeong: range culling on a surface oblique to the drive
// planes.
//
//   interference-figure-9 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <cstdint>

#include "endmill/core/text.h"
#include "endmill/offset/detail/range_culling.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/offset_sections.h"

using namespace endmill;

namespace {

void add_feed(CsvTable& result, const SectionPlan& plan)
{
    const OffsetSections sliced = offset_sections(plan);
    const auto& [frame, positions] = sliced.planes;
    const auto strips = strip_ranges(sliced.offset, frame, plan.grid_lines);
    const auto cells = cell_ranges(sliced.offset, frame);
    const std::size_t met = culled_pairs(strips, positions);
    std::size_t crossed = 0;
    for (const PlaneSection& section : sliced.sections)
        crossed += section.crossed_triangles;
    const std::size_t all = strips.size() * positions.size();
    const double saved = 100 * (1 - static_cast<double>(met) / static_cast<double>(all));
    const auto count = [](std::size_t number) {
        return CsvCell{static_cast<std::int64_t>(number)};
    };
    result.add_row({"at " + to_text(plan.direction_deg) + " deg", count(all), count(met),
                    saved, count(2 * cells.size() * positions.size()),
                    count(2 * culled_pairs(cells, positions)), count(crossed),
                    word(saved > 0)});
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-9", [](Experiment& run) {
        CsvTable result{{"row", "strips", "strips_met", "saved_percent", "triangles",
                         "triangles_visited", "triangles_crossed", "saves"}};
        const int grid = static_cast<int>(run.number("grid_lines"));
        for (const double feed : run.numbers("feeds_deg"))
            add_feed(result, {run.text("surface"), Cutter::ball(run.number("radius_mm")),
                              feed, grid});
        run.write_result(result);
    });
}
