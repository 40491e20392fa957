// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/stock_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Of a height map nothing is known between its cells; half a right angle is a guess that
// makes neighbouring rays differ by as much as they are apart.
constexpr double assumed_slope = 1;

double tangent_of(double cosine)
{
    const double c = std::abs(cosine);
    return c > 0 ? std::sqrt(std::max(0.0, (1 - c) * (1 + c))) / c : infinite;
}

// Walks over the cells below a ray.
struct CellWalk {
    int cell;
    int step;       // -1, 0 or 1
    double next;    // t at which the ray leaves the cell
    double across;  // t that a whole cell takes

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

}  // namespace

MownRay ray_in_block(const Block& block, const PartRay& ray)
{
    MownRay left{infinite, 0, -1};
    for (int c = 0; c < 3; ++c) {
        if (ray.point[c] < block.low[c] || ray.point[c] > block.high[c])
            return {0, 0, -1};
        const double rate = ray.normal[c];
        const double way = (rate > 0 ? block.high[c] : block.low[c]) - ray.point[c];
        if (rate != 0 && way / rate < left.left)
            left = {way / rate, tangent_of(rate), -1};
    }
    return left;
}

MownRay ray_in_stock(const HeightStock& stock, const PartRay& ray)
{
    const StockGrid& grid = stock.grid();
    CellWalk x{ray.point.x(), ray.normal.x(), grid.low_x, grid.pitch};
    CellWalk y{ray.point.y(), ray.normal.y(), grid.low_y, grid.pitch};
    double t = 0;
    while (x.cell >= 0 && x.cell < grid.columns && y.cell >= 0 && y.cell < grid.rows) {
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

}  // namespace endmill
