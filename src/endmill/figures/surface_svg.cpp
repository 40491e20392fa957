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

// The surface is drawn by the painter's algorithm. Each patch is divided into cells
// between neighbouring iso-parametric lines; the cells are sorted by the depth of their
// centres and filled from back to front, each with its own outline and patch borders.

namespace endmill {
namespace {

constexpr LineStyle border_style{"#12365f", 2, ""};
constexpr LineStyle iso_line_style{"#5f8fc0", 0.7, ""};
constexpr LineStyle net_style{"#c2702a", 0.9, "4 3"};
constexpr double net_point_radius_px = 2.2;

// Chords of a side of a cell; they are off the curve by less than the width of the line.
constexpr int steps_per_side = 8;

// A piece of the surface between neighbouring iso-parametric lines.
struct Cell {
    static constexpr std::size_t points = 4 * steps_per_side;
    std::array<Vec3, points>
        outline;  // counter-clockwise in (u, v) from the corner (u low, v low)
    std::array<bool, 4> is_border;  // for the sides v low, u high, v high, u low

    // The mean of the four corners, by which cells are sorted.
    Vec3 middle() const
    {
        return (outline[0] + outline[points / 4] + outline[points / 2] +
                outline[3 * points / 4]) /
               4;
    }
};

// The point that divides an interval in the ratio number : count - number.
double part_of(const Interval& interval, int number, int count)
{
    const double t = static_cast<double>(number) / count;
    return (1 - t) * interval.low + t * interval.high;
}

// The parameter interval of column or row `number`, counted through all patches.
Interval sub_interval(std::span<const double> breaks, int number, int spaces)
{
    const auto patch = static_cast<std::size_t>(number / spaces);
    const Interval whole{breaks[patch], breaks[patch + 1]};
    return {part_of(whole, number % spaces, spaces),
            part_of(whole, number % spaces + 1, spaces)};
}

// The cell in a column and row. Points are evaluated in the cell's own patch, since
// neighbouring patches need not join smoothly.
Cell cell(const Surface& surface, int column, int row, int spaces)
{
    const Interval u = sub_interval(surface.breaks(Parameter::U), column, spaces);
    const Interval v = sub_interval(surface.breaks(Parameter::V), row, spaces);
    const int i = column / spaces;
    const int j = row / spaces;
    Cell cell;
    for (int k = 0; k < steps_per_side; ++k) {
        const double rising_u = part_of(u, k, steps_per_side);
        const double rising_v = part_of(v, k, steps_per_side);
        const double falling_u = part_of(u, steps_per_side - k, steps_per_side);
        const double falling_v = part_of(v, steps_per_side - k, steps_per_side);
        cell.outline[k] = surface.jet_in_patch(i, j, rising_u, v.low).point;
        cell.outline[k + steps_per_side] =
            surface.jet_in_patch(i, j, u.high, rising_v).point;
        cell.outline[k + 2 * steps_per_side] =
            surface.jet_in_patch(i, j, falling_u, v.high).point;
        cell.outline[k + 3 * steps_per_side] =
            surface.jet_in_patch(i, j, u.low, falling_v).point;
    }
    cell.is_border = {row % spaces == 0, (column + 1) % spaces == 0,
                      (row + 1) % spaces == 0, column % spaces == 0};
    return cell;
}

// All cells of the surface.
std::vector<Cell> cells_of(const Surface& surface, int spaces)
{
    std::vector<Cell> cells;
    for (int row = 0; row < spaces * surface.patches(Parameter::V); ++row)
        for (int column = 0; column < spaces * surface.patches(Parameter::U); ++column)
            cells.push_back(cell(surface, column, row, spaces));
    return cells;
}

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

// The colour of a cell: light grey blue, darker the more the cell is inclined to the
// light.
std::string shade(const Cell& cell, const AxonometricView& view)
{
    constexpr std::array<int, 3> darkest{166, 186, 212};
    constexpr std::array<int, 3> lightest{240, 246, 252};
    const Vec3 light = (view.toward + 0.5 * view.up - 0.6 * view.right).normalized();
    const std::size_t quarter = Cell::points / 4;
    const Vec3 normal = (cell.outline[2 * quarter] - cell.outline[0])
                            .cross(cell.outline[3 * quarter] - cell.outline[quarter]);
    const double size = normal.norm();
    const double facing = size > 0 ? std::abs(normal.dot(light)) / size : 1;
    constexpr std::string_view digits = "0123456789abcdef";
    std::string colour = "#";
    for (std::size_t c = 0; c < 3; ++c) {
        const auto value =
            static_cast<unsigned>(darkest[c] + (lightest[c] - darkest[c]) * facing);
        colour += digits[value / 16];
        colour += digits[value % 16];
    }
    return colour;
}

// Fills a cell and draws its sides that are patch borders.
void add_cell(AxonometricFigure& figure, const Cell& cell)
{
    figure.add_polygon(cell.outline, shade(cell, figure.view()), iso_line_style);
    for (std::size_t side = 0; side < 4; ++side) {
        if (!cell.is_border[side])
            continue;
        std::array<Vec3, steps_per_side + 1> line;
        for (std::size_t k = 0; k < line.size(); ++k)
            line[k] = cell.outline[(side * steps_per_side + k) % Cell::points];
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
    std::vector<Cell> cells = cells_of(surface, drawing.spaces_per_patch);
    const auto net = drawing.control_net ? net_lines(surface) : std::vector<Polyline>{};
    std::vector<Vec3> extent;
    for (const Cell& cell : cells)
        extent.insert(extent.end(), cell.outline.begin(), cell.outline.end());
    for (const auto& line : net)
        extent.insert(extent.end(), line.begin(), line.end());

    AxonometricFigure figure{drawing.figure, extent};
    const Vec3 toward = figure.view().toward;
    std::ranges::stable_sort(cells, {},
                             [&](const Cell& cell) { return toward.dot(cell.middle()); });
    for (const Cell& cell : cells)
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
