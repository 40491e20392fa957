// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/box_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

constexpr double cells_per_box = 2;
// Cells of the fine grid along the side of a coarse cell.
constexpr int coarsening = 16;
// A box with more cells of the fine grid goes to the coarse one.
constexpr int most_fine_cells = 64;
constexpr double most_cells_along = 1024;
// Least side of the region, so that its inverse is finite.
constexpr float least_side = 1e-30F;

}  // namespace

void BoxHeights::reset(std::span<const ProjectedBox> boxes)
{
    Eigen::Array2f low = Eigen::Array2f::Constant(std::numeric_limits<float>::max());
    Eigen::Array2f high = -low;
    for (const ProjectedBox& box : boxes) {
        low = low.min(box.low.head<2>().array());
        high = high.max(box.high.head<2>().array());
    }
    low_ = low;
    const Eigen::Array2d extent = (high - low).max(least_side).cast<double>();
    const double cells = cells_per_box * static_cast<double>(boxes.size()) + 1;
    const double most = std::min(cells, most_cells_along);
    const double side = std::sqrt(extent.x() * extent.y() / cells);
    for (std::size_t level = 0; level < grids_.size(); ++level) {
        Grid& grid = grids_[level];
        const double coarse = level == 0 ? 1 : coarsening;
        const Eigen::Array2d counts =
            (extent / (side * coarse)).min(most / coarse).max(1).floor();
        grid.columns = static_cast<int>(counts.x());
        grid.rows = static_cast<int>(counts.y());
        grid.cells_per_length = (counts / extent).cast<float>();
        grid.highest.assign(static_cast<std::size_t>(grid.columns) * grid.rows,
                            -std::numeric_limits<float>::infinity());
    }
}

BoxHeights::Cells BoxHeights::cells_of(const Grid& grid, const ProjectedBox& box) const
{
    const Eigen::Array2f most{static_cast<float>(grid.columns - 1),
                              static_cast<float>(grid.rows - 1)};
    const auto at = [&](const Eigen::Vector3f& corner) -> Eigen::Array2f {
        return ((corner.head<2>().array() - low_) * grid.cells_per_length)
            .max(0)
            .min(most);
    };
    const Eigen::Array2f first = at(box.low);
    const Eigen::Array2f last = at(box.high);
    return {{static_cast<int>(first.x()), static_cast<int>(first.y())},
            {static_cast<int>(last.x()), static_cast<int>(last.y())}};
}

void BoxHeights::add(const ProjectedBox& box)
{
    Cells cells = cells_of(grids_[0], box);
    const bool is_wide = cells.count() > most_fine_cells;
    Grid& grid = grids_[is_wide ? 1 : 0];
    if (is_wide)
        cells = cells_of(grid, box);
    for (int row = cells.first[1]; row <= cells.last[1]; ++row)
        for (int column = cells.first[0]; column <= cells.last[0]; ++column) {
            float& highest =
                grid.highest[static_cast<std::size_t>(row) * grid.columns + column];
            highest = std::max(highest, box.high.z());
        }
}

bool BoxHeights::are_clear_of(const ProjectedBox& box) const
{
    for (const Grid& grid : grids_) {
        const Cells cells = cells_of(grid, box);
        if (cells.count() > most_fine_cells)
            return false;
        for (int row = cells.first[1]; row <= cells.last[1]; ++row)
            for (int column = cells.first[0]; column <= cells.last[0]; ++column)
                if (grid.highest[static_cast<std::size_t>(row) * grid.columns + column] >=
                    box.low.z())
                    return false;
    }
    return true;
}

}  // namespace endmill
