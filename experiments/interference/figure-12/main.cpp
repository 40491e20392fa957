// SPDX-License-Identifier: GPL-3.0-or-later
// Figure 12 of Jang, Kim and Jeong: a surface with its ball offset, and the folded share
// of the offset, which trimming removes.
//
//   interference-figure-12 OUTPUT_FOLDER
//
// Deterministic, under 10 s. Columns and verdicts: README.md beside this.

#include <cstdint>

#include <Eigen/Geometry>

#include "endmill/core/text.h"
#include "endmill/figures/axonometric_figure.h"
#include "endmill/surface/curvature.h"
#include "support/experiment.h"
#include "support/offset_sections.h"

using namespace endmill;

namespace {

constexpr LineStyle part_style{"#222222", 0.9, ""};
constexpr LineStyle offset_style{"#1d4f91", 0.9, ""};

using Lines = std::vector<std::vector<Vec3>>;

// Sections in space of every n-th plane, so that the lines are distinct.
Lines drawn_lines(const DrivePlanes& planes, std::span<const PlaneSection> sections,
                  std::size_t every)
{
    Lines lines;
    for (std::size_t k = 0; k < sections.size(); k += every)
        for (const SectionCurve& curve : sections[k].curves) {
            auto& line = lines.emplace_back();
            for (const SectionPoint& point : curve.points)
                line.push_back(
                    planes.frame.point(point.x(), planes.positions[k], point.y()));
        }
    return lines;
}

std::string drawing(const Lines& part, const Lines& offset, const std::string& caption)
{
    FigureOptions figure;
    figure.title = "As figure 12: surface and offset";
    figure.captions = {caption};
    figure.azimuth = Angle::degrees(70);
    figure.elevation = Angle::degrees(25);
    std::vector<Vec3> extent;
    for (const Lines* lines : {&part, &offset})
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

// Share of triangles that face down: an offset faces up except where it folds over.
std::int64_t turned_triangles(const TriangleMesh& mesh)
{
    std::int64_t count = 0;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const auto [a, b, c] = mesh.corners(k);
        count += (b - a).cross(c - a).z() < 0 ? 1 : 0;
    }
    return count;
}

// Share of contacts with exactly one concave radius of curvature below the ball's. There,
// and only there, the orientation of the offset is reversed.
std::int64_t tight_contacts(const OffsetMesh& offset, const Surface& part, double radius)
{
    std::int64_t count = 0;
    for (const OffsetContact& contact : offset.contacts) {
        const auto forms =
            fundamental_forms(part.jet(contact.at.u, contact.at.v), contact.normal);
        const PrincipalCurvatures curvatures = principal_curvatures(forms);
        count += curvatures.least < -1 / radius && curvatures.greatest > -1 / radius;
    }
    return count;
}

double percent(std::int64_t count, std::size_t of)
{
    return 100 * static_cast<double>(count) / static_cast<double>(of);
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "interference/figure-12", [](Experiment& run) {
        const std::string surface = run.text("surface");
        const double radius = run.number("radius_mm");
        const auto every = static_cast<std::size_t>(run.number("every_plane"));
        CsvTable result{{"row", "folded_percent", "too_concave_percent"}};
        const Surface part = dataset_surface(surface);
        const auto grids = run.numbers("grids");
        for (const double lines : grids) {
            const OffsetSections sliced =
                offset_sections({.surface = surface,
                                 .cutter = Cutter::ball(radius),
                                 .grid_lines = static_cast<int>(lines)});
            const OffsetMesh& offset = sliced.offset;
            result.add_row(
                {"grid " + to_text(lines),
                 percent(turned_triangles(offset.mesh), offset.mesh.triangles().size()),
                 percent(tight_contacts(offset, part, radius), offset.contacts.size())});
            if (lines != grids.back())
                continue;
            run.write(
                "figure-12.svg",
                drawing(drawn_lines(sliced.planes,
                                    slice(contact_mesh(offset), sliced.planes), every),
                        drawn_lines(sliced.planes, sliced.sections, every),
                        surface + ", ball of radius " + to_text(radius) + " mm, every " +
                            std::to_string(every) + "th of " +
                            std::to_string(sliced.sections.size()) + " planes"));
        }
        run.write_result(result);
    });
}
