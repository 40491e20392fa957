// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/tool_path_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/figures/detail/surface_cells.h"

// The surface is drawn by the painter's algorithm. Each patch is divided into cells
// between neighbouring iso-parametric lines; the cells are sorted by the depth of their
// centres and filled from back to front, each with its own outline and patch borders.

namespace endmill {
namespace {

constexpr LineStyle border_style{"#12365f", 2, ""};
constexpr LineStyle iso_line_style{"#5f8fc0", 0.7, ""};
constexpr LineStyle net_style{"#c2702a", 0.9, "4 3"};
constexpr double net_point_radius_px = 2.2;

using Polyline = std::vector<Vec3>;

// The rows and columns of the control net of each patch.
std::vector<Polyline> net_lines(const Surface& surface)
{
    std::vector<Polyline> lines;
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i) {
            const BezierPatch& patch = surface.patch(i, j);
            const int last_u = patch.degree(Parameter::U);
            const int last_v = patch.degree(Parameter::V);
            for (int k = 0; k <= last_v; ++k) {
                Polyline& row = lines.emplace_back();
                for (int m = 0; m <= last_u; ++m)
                    row.push_back(patch.control_point(m, k));
            }
            for (int k = 0; k <= last_u; ++k) {
                Polyline& column = lines.emplace_back();
                for (int m = 0; m <= last_v; ++m)
                    column.push_back(patch.control_point(k, m));
            }
        }
    return lines;
}

// Fills a cell and draws its sides that are patch borders.
void add_cell(AxonometricFigure& figure, const SurfaceCell& cell)
{
    figure.add_polygon(cell.outline, shade_of(cell, figure.view()), iso_line_style);
    for (std::size_t side = 0; side < 4; ++side) {
        if (!cell.is_border[side])
            continue;
        std::array<Vec3, SurfaceCell::steps_per_side + 1> line;
        for (std::size_t k = 0; k < line.size(); ++k)
            line[k] = cell.outline[(side * SurfaceCell::steps_per_side + k) %
                                   SurfaceCell::points];
        figure.add_curve(line, border_style);
    }
}

// The legend names only lines that are drawn.
void add_legend(AxonometricFigure& figure, const SurfaceDrawing& drawing)
{
    figure.add_legend("patch border", border_style);
    if (drawing.spaces_per_patch > 1)
        figure.add_legend("iso-parametric line", iso_line_style);
    if (drawing.control_net)
        figure.add_legend("control net", net_style);
}

}  // namespace

std::string surface_svg(const Surface& surface, const SurfaceDrawing& drawing)
{
    require(drawing.spaces_per_patch >= 1, "surface_svg: need spaces_per_patch >= 1");
    std::vector<SurfaceCell> cells = surface_cells(surface, drawing.spaces_per_patch);
    const auto net = drawing.control_net ? net_lines(surface) : std::vector<Polyline>{};
    std::vector<Vec3> extent;
    for (const SurfaceCell& cell : cells)
        extent.insert(extent.end(), cell.outline.begin(), cell.outline.end());
    for (const auto& line : net)
        extent.insert(extent.end(), line.begin(), line.end());

    AxonometricFigure figure{drawing.figure, extent};
    const Vec3 toward = figure.view().toward;
    std::ranges::stable_sort(
        cells, {}, [&](const SurfaceCell& cell) { return toward.dot(cell.middle()); });
    for (const SurfaceCell& cell : cells)
        add_cell(figure, cell);
    for (const auto& line : net) {
        figure.add_curve(line, net_style);
        for (const Vec3& point : line)
            figure.add_disc(point, net_point_radius_px, net_style.colour);
    }
    add_legend(figure, drawing);
    return figure.text();
}

}  // namespace endmill
