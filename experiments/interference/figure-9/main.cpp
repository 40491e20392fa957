// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 9 of Jang, Kim and Jeong: range culling on a surface oblique to the drive
// planes.
//
//   interference-figure-9 OUTPUT_FOLDER
//
// Deterministic, under 1 s. Columns and verdicts: README.md beside this.

#include <cmath>
#include <cstdint>

#include "endmill/core/text.h"
#include "support/experiment.h"
#include "support/offset_sections.h"

using namespace endmill;

namespace {

constexpr std::int64_t triangles_a_cell = 2;

// The range of t of an object, in mm.
struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double t)
    {
        low = std::min(low, t);
        high = std::max(high, t);
    }
};

// Number of pairs of a plane and an extent that meet.
std::int64_t meetings(const std::vector<Extent>& extents, const DrivePlanes& planes)
{
    std::int64_t count = 0;
    for (const Extent& extent : extents)
        for (const double c : planes.positions)
            count += extent.low <= c && c < extent.high ? 1 : 0;
    return count;
}

// Extents of the cells of the grid; a cell has two consecutive triangles.
std::vector<Extent> cell_extents(const OffsetSections& offset)
{
    const TriangleMesh& mesh = offset.offset.mesh;
    std::vector<Extent> extents(mesh.triangles().size() / triangles_a_cell);
    for (std::size_t i = 0; i < mesh.triangles().size(); ++i)
        for (const Vec3& corner : mesh.corners(i))
            extents[i / triangles_a_cell].add(offset.planes.frame.across(corner));
    return extents;
}

// Extents of the strips between neighbouring lines u = const of a surface over [0, 1].
std::vector<Extent> strip_extents(const OffsetSections& offset, int grid_lines)
{
    const TriangleMesh& mesh = offset.offset.mesh;
    const auto strips = static_cast<std::size_t>(grid_lines) - 1;
    std::vector<Extent> extents(strips);
    for (std::size_t vertex = 0; vertex < mesh.points().size(); ++vertex) {
        const double u = offset.offset.contacts[vertex].at.u;
        const auto line =
            static_cast<std::size_t>(std::lround(u * static_cast<double>(strips)));
        const double t = offset.planes.frame.across(mesh.points()[vertex]);
        if (line > 0)
            extents[line - 1].add(t);
        if (line < strips)
            extents[line].add(t);
    }
    return extents;
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-9", [](Experiment& run) {
        CsvTable result{{"row", "strips", "strips_met", "saved_percent", "triangles",
                         "triangles_visited", "triangles_crossed", "saves"}};
        const int grid = static_cast<int>(run.number("grid_lines"));
        for (const double feed : run.numbers("feeds_deg")) {
            const OffsetSections offset = offset_sections(
                {run.text("surface"), Cutter::ball(run.number("radius_mm")), feed, grid});
            const auto strips = strip_extents(offset, grid);
            const auto cells = cell_extents(offset);
            const std::size_t planes = offset.planes.positions.size();
            const std::int64_t met = meetings(strips, offset.planes);
            std::size_t crossed = 0;
            for (const PlaneSection& section : offset.sections)
                crossed += section.crossed_triangles;
            const double all = static_cast<double>(strips.size() * planes);
            const double saved = 100 * (1 - static_cast<double>(met) / all);
            result.add_row(
                {"at " + to_text(feed) + " deg",
                 static_cast<std::int64_t>(strips.size() * planes), met, saved,
                 triangles_a_cell * static_cast<std::int64_t>(cells.size() * planes),
                 triangles_a_cell * meetings(cells, offset.planes),
                 static_cast<std::int64_t>(crossed), saved > 0 ? "yes" : "no"});
        }
        run.write_result(result);
    });
}
