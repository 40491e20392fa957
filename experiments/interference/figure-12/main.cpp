// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 12 of Jang, Kim and Jeong: a surface with its ball offset, and the folded share
// of the offset, which trimming removes.
//
//   interference-figure-12 OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include "endmill/core/text.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/offset/detail/offset_folds.h"
#include "support/experiment.h"
#include "support/offset_sections.h"

using namespace endmill;

namespace {

constexpr LineStyle part_style{"#222222", 0.9, ""};
constexpr LineStyle offset_style{"#1d4f91", 0.9, ""};

std::string drawing(const PlaneLines& part, const PlaneLines& offset,
                    const std::string& caption)
{
    FigureOptions figure;
    figure.title = "As figure 12: surface and offset";
    figure.captions = {caption};
    figure.azimuth = Angle::degrees(70);
    figure.elevation = Angle::degrees(25);
    std::vector<Vec3> extent;
    for (const PlaneLines* lines : {&part, &offset})
        for (const auto& line : *lines)
            extent.insert(extent.end(), line.begin(), line.end());
    AxonometricFigure picture{figure, extent};
    for (const auto& line : part)
        picture.add_curve(line, part_style);
    for (const auto& line : offset)
        picture.add_curve(line, offset_style);
    picture.add_legend("surface", part_style);
    picture.add_legend("offset (centre of the ball), folds kept", offset_style);
    return picture.text();
}

double percent(std::size_t count, std::size_t of)
{
    return 100 * static_cast<double>(count) / static_cast<double>(of);
}

void draw(Experiment& run, const SectionPlan& plan, const OffsetSections& sliced)
{
    const auto every = static_cast<std::size_t>(run.number("every_plane"));
    const auto part = slice(contact_mesh(sliced.offset), sliced.planes);
    run.write("figure-12.svg",
              drawing(every_nth(untrimmed_lines(sliced.planes, part), every),
                      every_nth(untrimmed_lines(sliced.planes, sliced.sections), every),
                      plan.surface + ", ball of radius " + to_text(plan.cutter.radius()) +
                          " mm, every " + std::to_string(every) + "th of " +
                          std::to_string(sliced.sections.size()) + " planes"));
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-12", [](Experiment& run) {
        SectionPlan plan{.surface = run.text("surface"),
                         .cutter = Cutter::ball(run.number("radius_mm"))};
        const std::vector part{dataset_surface(plan.surface)};
        const auto grids = run.numbers("grids");
        CsvTable result{{"row", "folded_percent", "too_concave_percent"}};
        for (const double lines : grids) {
            plan.grid_lines = static_cast<int>(lines);
            const OffsetSections sliced = offset_sections(plan);
            const OffsetMesh& offset = sliced.offset;
            result.add_row(
                {"grid " + to_text(lines),
                 percent(folded_triangles(offset.mesh), offset.mesh.triangles().size()),
                 percent(too_concave_contacts(offset, part), offset.contacts.size())});
            if (lines == grids.back())
                draw(run, plan, sliced);
        }
        run.write_result(result);
    });
}
