// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 9 of Jang, Kim and Jeong: range culling on a surface oblique to the drive
// planes; and the pairs that a search for twists compares on the surface and in sections.
//
//   interference-figure-9 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "endmill/core/text.h"
#include "endmill/offset/detail/range_culling.h"
#include "endmill/trimming/trimmed_planes.h"
#include "support/experiment.h"
#include "support/named_cells.h"
#include "support/offset_sections.h"

using namespace endmill;

namespace {

CsvCell count(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

double percent_saved(double part, double whole)
{
    return 100 * (1 - part / whole);
}

// Strips met by the first and the last tenth of the planes over those met by as many
// planes in the middle.
double ends_over_middle(std::span<const Interval> strips, std::span<const double> planes)
{
    const std::size_t tenth = planes.size() / 10;
    const std::size_t ends = culled_pairs(strips, planes.first(tenth)) +
                             culled_pairs(strips, planes.last(tenth));
    const auto middle = planes.subspan(planes.size() / 2 - tenth, 2 * tenth);
    return static_cast<double>(ends) / static_cast<double>(culled_pairs(strips, middle));
}

// The share of scan lines of constant z that are saved if each plane is scanned between
// z_min and z_max of its own section, and not between those of the whole offset.
double scan_range_saved_percent(const OffsetSections& sliced)
{
    Interval whole{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
    double scanned = 0;
    for (const PlaneSection& section : sliced.sections)
        scanned += section_height({&section, 1});
    for (const Vec3& point : sliced.offset.mesh.points())
        whole = {std::min(whole.low, point.z()), std::max(whole.high, point.z())};
    return percent_saved(scanned,
                         whole.length() * static_cast<double>(sliced.sections.size()));
}

// Pairs of triangles of the offset, and pairs of segments in all sections: what a search
// for crossings without culling compares.
struct ComparedPairs {
    double on_surface;
    double in_sections;
};

ComparedPairs compared_pairs(const OffsetSections& sliced)
{
    const auto pairs = [](std::size_t count) {
        return 0.5 * static_cast<double>(count) * (static_cast<double>(count) - 1);
    };
    ComparedPairs result{pairs(sliced.offset.mesh.triangles().size()), 0};
    for (const PlaneSection& section : sliced.sections)
        result.in_sections += pairs(section.crossed_triangles);
    return result;
}

// What culling and slicing save for one feed.
struct Savings {
    double strips_percent;
    double scan_range_percent;
};

Savings add_feed(CsvTable& result, const SectionPlan& plan)
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
    const Savings saved{percent_saved(static_cast<double>(met), static_cast<double>(all)),
                        scan_range_saved_percent(sliced)};
    const ComparedPairs pairs = compared_pairs(sliced);
    add_named(result, "at " + to_text(plan.direction_deg) + " deg",
              {{"strips", count(all)},
               {"strips_met", count(met)},
               {"saved_percent", saved.strips_percent},
               {"ends_over_middle", ends_over_middle(strips, positions)},
               {"scan_range_saved_percent", saved.scan_range_percent},
               {"triangles", count(2 * cells.size() * positions.size())},
               {"triangles_visited", count(2 * culled_pairs(cells, positions))},
               {"triangles_crossed", count(crossed)},
               {"pairs_on_surface", pairs.on_surface},
               {"pairs_in_sections", pairs.in_sections},
               {"surface_over_sections", pairs.on_surface / pairs.in_sections}});
    return saved;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-9", [](Experiment& run) {
        CsvTable result{{"row", "strips", "strips_met", "saved_percent",
                         "ends_over_middle", "scan_range_saved_percent", "triangles",
                         "triangles_visited", "triangles_crossed", "pairs_on_surface",
                         "pairs_in_sections", "surface_over_sections",
                         "strips_saved_ratio", "scan_range_saved_ratio"}};
        const auto saved = [&](const char* feed) {
            return add_feed(
                result, {run.text("surface"), Cutter::ball(run.number("radius_mm")),
                         run.number(feed), static_cast<int>(run.number("grid_lines"))});
        };
        const Savings parallel = saved("parallel_feed_deg");
        const Savings oblique = saved("oblique_feed_deg");
        add_named(
            result, "oblique over parallel",
            {{"strips_saved_ratio", oblique.strips_percent / parallel.strips_percent},
             {"scan_range_saved_ratio",
              oblique.scan_range_percent / parallel.scan_range_percent}});
        run.write_result(result);
    });
}
