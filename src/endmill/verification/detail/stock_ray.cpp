// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/stock_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

// Rays in a height field are followed cell by cell (`CellWalk`), as in a grid traversal:
// the next cell border along x or y is the nearer one. Inside a cell the field is a flat
// top, so a ray leaves the material through a top or through the side of a cell.
// Three answers are needed. Above the part the height of each cell counts as it is. Below
// the part the highest cell around gives what is missing for certain, and the lowest,
// minus a dip between the centres, gives what may be missing at most.

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Slope of the stock's surface, which heights do not give. With 45 degrees, thickness
// changes between neighbouring rays by as much as they are apart.
constexpr double assumed_slope = 1;

// Dip of a ball, whose radius is one pitch, between four centres, as a share of the
// pitch: 1 - sqrt(1/2).
constexpr double most_dip = 0.293;

// Tangent of the angle with this cosine.
double tangent_of(double cosine)
{
    const double c = std::abs(cosine);
    return c > 0 ? std::sqrt(std::max(0.0, (1 - c) * (1 + c))) / c : infinite;
}

// The cells along a ray, in one coordinate.
struct CellWalk {
    int cell;
    int step;       // -1, 0 or 1
    double next;    // t at which the ray leaves the cell
    double across;  // t for a whole cell

    CellWalk(double from, double rate, double low, double pitch)
    {
        const double at = (from - low) / pitch;
        cell = static_cast<int>(std::clamp(std::floor(at), -1.0, 2147483646.0));
        step = rate > 0 ? 1 : rate < 0 ? -1 : 0;
        across = step == 0 ? infinite : pitch / std::abs(rate);
        const double share = step > 0 ? 1 - (at - cell) : at - cell;
        next = step == 0 ? infinite : share * across;
    }
    void advance()
    {
        cell += step;
        next += across;
    }
};

// Returns how much material is missing at a place outside a block: the way against the
// normal to the block, or the reach of the block if the line misses it.
CutRay missing(const Block& block, const PartRay& ray)
{
    const Vec3 way = -ray.normal;
    double enter = 0;
    double leave = infinite;
    double rate = 1;  // component of the direction through the face that is entered
    for (int c = 0; c < 3; ++c) {
        const double low = block.low[c] - ray.point[c];
        const double high = block.high[c] - ray.point[c];
        if (way[c] == 0) {
            if (low > 0 || high < 0)
                leave = -infinite;
            continue;
        }
        const double first = (way[c] > 0 ? low : high) / way[c];
        if (first > enter) {
            enter = first;
            rate = way[c];
        }
        leave = std::min(leave, (way[c] > 0 ? high : low) / way[c]);
    }
    if (enter <= leave)
        return {-enter, tangent_of(rate), -1};
    const double floor = (block.low.z() - ray.point.z()) / way.z();
    const double most = (block.high - block.low).norm();
    return {-(floor > 0 ? std::min(floor, most) : most), 0, -1};
}

// Returns the highest height of a cell and its neighbours.
double highest_around(const HeightStock& stock, int column, int row)
{
    const StockGrid& grid = stock.grid();
    double highest = -infinite;
    for (int j = std::max(row - 1, 0); j <= std::min(row + 1, grid.rows - 1); ++j)
        for (int i = std::max(column - 1, 0); i <= std::min(column + 1, grid.columns - 1);
             ++i)
            highest = std::max(highest, stock.height(i, j));
    return highest;
}

// The cells within `around` cells of one, clipped to the grid.
struct CellsAround {
    CellsAround(const StockGrid& grid, int column, int row, int around)
        : first_column{std::max(column - around, 0)},
          last_column{std::min(column + around, grid.columns - 1)},
          first_row{std::max(row - around, 0)},
          last_row{std::min(row + around, grid.rows - 1)}
    {
    }

    int first_column;
    int last_column;
    int first_row;
    int last_row;
};

double lowest_of(const HeightStock& stock, const CellsAround& cells)
{
    double lowest = infinite;
    for (int row = cells.first_row; row <= cells.last_row; ++row)
        for (int column = cells.first_column; column <= cells.last_column; ++column)
            lowest = std::min(lowest, stock.height(column, row));
    return lowest;
}

// Returns how far a surface may dip below the lowest height if it bends as the heights
// do. A parabola through three heights in a row lies an eighth of their second difference
// below the two lower ones; this is added for x and y.
double dip_between(const HeightStock& stock, const CellsAround& cells)
{
    double along_x = 0;
    double along_y = 0;
    for (int row = cells.first_row; row <= cells.last_row; ++row)
        for (int column = cells.first_column; column <= cells.last_column; ++column) {
            const double twice = 2 * stock.height(column, row);
            if (column > cells.first_column && column < cells.last_column)
                along_x = std::max(along_x, stock.height(column - 1, row) +
                                                stock.height(column + 1, row) - twice);
            if (row > cells.first_row && row < cells.last_row)
                along_y = std::max(along_y, stock.height(column, row - 1) +
                                                stock.height(column, row + 1) - twice);
        }
    return std::min((along_x + along_y) / 8, most_dip * stock.grid().pitch);
}

// Whether the grid has this cell.
bool holds(const StockGrid& grid, int column, int row)
{
    return column >= 0 && column < grid.columns && row >= 0 && row < grid.rows;
}

Block box_of(const StockGrid& grid, double top)
{
    return {{grid.low_x, grid.low_y, grid.bottom_z},
            {grid.low_x + grid.columns * grid.pitch, grid.low_y + grid.rows * grid.pitch,
             top}};
}

// Returns what is certainly missing below a ray's point that lies above its cell, or
// beside all cells.
CutRay missing(const HeightStock& stock, const PartRay& ray)
{
    const StockGrid& grid = stock.grid();
    const Vec3 way = -ray.normal;
    CellWalk x{ray.point.x(), way.x(), grid.low_x, grid.pitch};
    CellWalk y{ray.point.y(), way.y(), grid.low_y, grid.pitch};
    const CutRay beside = missing(box_of(grid, ray.point.z()), ray);
    if (!holds(grid, x.cell, y.cell))
        return beside;
    double t = 0;
    while (holds(grid, x.cell, y.cell)) {
        const double height = highest_around(stock, x.cell, y.cell);
        const double above = ray.point.z() + t * way.z() - height;
        const double end = std::min(x.next, y.next);
        if (height > grid.bottom_z) {
            if (above <= 0)
                return {-t, assumed_slope, -1};
            if (way.z() < 0 && t + above / -way.z() <= end)
                return {-t + above / way.z(), assumed_slope, -1};
        }
        if (!std::isfinite(end))
            break;
        t = std::max(t, end);
        (x.next <= y.next ? x : y).advance();
    }
    return missing(box_of(grid, grid.bottom_z), ray);
}

}  // namespace

CutRay ray_in_block(const Block& block, const PartRay& ray)
{
    double nearest = infinite;
    double cosine = 1;
    for (int c = 0; c < 3; ++c) {
        if (ray.point[c] < block.low[c] || ray.point[c] > block.high[c])
            return missing(block, ray);
        const double rate = ray.normal[c];
        const double way = (rate > 0 ? block.high[c] : block.low[c]) - ray.point[c];
        const double length = rate != 0 ? way / rate : infinite;
        if (length < nearest) {
            nearest = length;
            cosine = rate;
        }
    }
    return {nearest, tangent_of(cosine), -1};
}

CutRay ray_in_stock(const HeightStock& stock, const PartRay& ray)
{
    const StockGrid& grid = stock.grid();
    CellWalk x{ray.point.x(), ray.normal.x(), grid.low_x, grid.pitch};
    CellWalk y{ray.point.y(), ray.normal.y(), grid.low_y, grid.pitch};
    if (!holds(grid, x.cell, y.cell) ||
        stock.height(x.cell, y.cell) <= std::max(ray.point.z(), grid.bottom_z))
        return missing(stock, ray);
    double t = 0;
    while (holds(grid, x.cell, y.cell)) {
        const double height = stock.height(x.cell, y.cell);
        const double above = ray.point.z() + t * ray.normal.z() - height;
        if (above >= 0 || height <= grid.bottom_z)
            break;
        const double end = std::min(x.next, y.next);
        const double rise = (end - t) * ray.normal.z();
        if (!(above + rise < 0))  // it leaves through the top of this cell
            return {t - above / ray.normal.z(), assumed_slope, -1};
        if (!std::isfinite(end))
            break;
        t = std::max(t, end);
        (x.next <= y.next ? x : y).advance();
    }
    return {t, assumed_slope, -1};
}

double most_missing(const HeightStock& stock, const PartRay& ray, double reach)
{
    const StockGrid& grid = stock.grid();
    // The part may be higher by this much within the reach; the cells around cover the
    // same places.
    const double level = ray.normal.head<2>().norm();
    const double top = ray.point.z() + reach * level;
    const int around = 1 + static_cast<int>(std::min(reach / grid.pitch + 1, 1e6));
    CellWalk x{ray.point.x(), -ray.normal.x(), grid.low_x, grid.pitch};
    CellWalk y{ray.point.y(), -ray.normal.y(), grid.low_y, grid.pitch};
    // Lower bound of the surface around the cell. The dip is computed only where the
    // lowest height does not already suffice.
    const auto height = [&](double wanted) {
        const CellsAround cells{grid, x.cell, y.cell, around};
        const double lowest = lowest_of(stock, cells);
        return lowest - most_dip * grid.pitch >= wanted
                   ? wanted
                   : std::max(grid.bottom_z, lowest - dip_between(stock, cells));
    };
    if (!holds(grid, x.cell, y.cell))
        return std::max(0.0, -ray_in_stock(stock, ray).thickness);
    double t = 0;
    while (holds(grid, x.cell, y.cell)) {
        const double z = top - t * ray.normal.z();
        const double above = z - height(z);
        const double end = std::min(x.next, y.next);
        if (above <= 0)
            return t;
        if (ray.normal.z() > 0 && t + above / ray.normal.z() <= end)
            return t + above / ray.normal.z();
        if (!std::isfinite(end))
            break;
        t = std::max(t, end);
        (x.next <= y.next ? x : y).advance();
    }
    return std::max(t, (box_of(grid, grid.bottom_z).high - box_of(grid, top).low).norm());
}

}  // namespace endmill
