// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/point_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

// Mean number of points in a cell. More points mean fewer rows of cells for each facet,
// but more points that are tested without need.
constexpr double points_per_cell = 0.7;
// Height of a cell divided by its width. With high cells a facet meets fewer rows, and
// the points of a row are contiguous in memory.
constexpr double aspect = 8;
// Largest number of cells along an axis. It limits the memory for points along a line.
constexpr double most_cells_along = 1 << 15;
// Least side of a cell, for points that all have the same x or y. Its inverse is a finite
// float.
constexpr double least_side = 1e-30;

}  // namespace

void PointCells::choose_cells(std::span<const NumberedPoint> points,
                              std::size_t least_cells)
{
    Eigen::Array2f low = points.front().place.head<2>();
    Eigen::Array2f high = low;
    for (const NumberedPoint& point : points) {
        low = low.min(point.place.head<2>().array());
        high = high.max(point.place.head<2>().array());
    }
    low_ = low;
    const Eigen::Array2d extent = (high - low).cast<double>();
    const double cells = std::max(static_cast<double>(least_cells),
                                  static_cast<double>(points.size()) / points_per_cell);
    const double middle = std::sqrt(extent.x() * extent.y() / cells);
    const double least = extent.maxCoeff() / std::min(cells, most_cells_along);
    const Eigen::Array2d sides =
        (middle * Eigen::Array2d{1 / std::sqrt(aspect), std::sqrt(aspect)})
            .max(std::max(least, least_side));
    cells_per_length_ = sides.inverse().cast<float>();
    columns_ = static_cast<int>(extent.x() / sides.x()) + 1;
    rows_ = static_cast<int>(extent.y() / sides.y()) + 1;
}

void PointCells::sort(std::span<const NumberedPoint> points, std::size_t least_cells)
{
    blocks_.clear();
    begin_.clear();
    columns_ = 0;
    rows_ = 0;
    if (points.empty())
        return;
    choose_cells(points, least_cells);
    begin_.resize(static_cast<std::size_t>(columns_) * rows_ + 1);
    lowest_.assign(static_cast<std::size_t>(columns_) * rows_,
                   std::numeric_limits<float>::infinity());
    cell_of_.resize(points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Eigen::Vector3f& place = points[k].place;
        const int cell = row_at(place.y()) * columns_ + column_at(place.x());
        cell_of_[k] = static_cast<std::uint32_t>(cell);
        ++begin_[cell];
        lowest_[cell] = smaller(lowest_[cell], place.z());
    }
    std::uint32_t sum = 0;
    // The end of each cell; it becomes the first place by filling.
    for (std::uint32_t& begin : begin_) {
        sum += begin;
        begin = sum;
    }
    blocks_.resize((points.size() + PointBlock::size - 1) / PointBlock::size);
    blocks_.back().number.fill(-1);
    blocks_.back().x.fill(std::numeric_limits<float>::infinity());
    for (std::size_t k = points.size(); k-- > 0;) {
        const std::uint32_t place = --begin_[cell_of_[k]];
        PointBlock& block = blocks_[place / PointBlock::size];
        const std::size_t lane = place % PointBlock::size;
        block.x[lane] = points[k].place.x();
        block.y[lane] = points[k].place.y();
        block.z[lane] = points[k].place.z();
        block.number[lane] = points[k].number;
    }
}

}  // namespace endmill
