// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "endmill/core/detail/lanes.h"

namespace endmill {

/// One number for each of the things that are processed together.
using LaneFloats = std::array<float, float_lanes>;

/// Eight projected points: [axis].
struct alignas(32) PlaceLanes {
    std::array<LaneFloats, 3> at{};

    /// The point in a lane.
    Eigen::Vector3f place(int lane) const
    {
        return {at[0][lane], at[1][lane], at[2][lane]};
    }
};

/// Eight points that are processed together, in a layout for SIMD registers.
struct alignas(32) PointBlock {
    static constexpr int size = 8;

    std::array<float, size> x;
    std::array<float, size> y;
    std::array<float, size> z;
    /// -1, with infinite x, where there is no point.
    std::array<std::int32_t, size> number;
};

/// A point with the number of its facet.
struct NumberedPoint {
    Eigen::Vector3f place;  ///< projected coordinates
    std::int32_t number;
};

/// A uniform grid of cells in x and y with points sorted into it. There are about as many
/// cells as points. Memory is reused for the next points.
class PointCells {
public:
    /// Replaces the points. \param least_cells number of cells if the points are few.
    /// \pre all coordinates are finite.
    void sort(std::span<const NumberedPoint> points, std::size_t least_cells = 1);

    /// Number of points.
    std::size_t points() const { return begin_.empty() ? 0 : begin_.back(); }
    int rows() const { return rows_; }        ///< number of cells along y
    int columns() const { return columns_; }  ///< number of cells along x

    /// The column of cells that contains x, or the nearest one.
    int column_at(float x) const { return cell_at(x, 0, columns_); }

    /// The row of cells that contains y, or the nearest one.
    int row_at(float y) const { return cell_at(y, 1, rows_); }

    /// The places of the points in the columns `first` to `last` of a row: the first
    /// place, and one beyond the last. \pre row and columns exist.
    std::pair<std::uint32_t, std::uint32_t> range(int row, int first, int last) const
    {
        const std::size_t cell = static_cast<std::size_t>(row) * columns_;
        return {begin_[cell + first], begin_[cell + last + 1]};
    }

    /// Tests whether a cell of a row, from column `first` to `last`, has a point whose z
    /// is at most `highest`.
    bool any_below(int row, int first, int last, float highest) const
    {
        const float* const lowest = &lowest_[static_cast<std::size_t>(row) * columns_];
        bool any = false;
        for (int column = first; column <= last; ++column)
            any = any || lowest[column] <= highest;
        return any;
    }

    /// The points: block b has the places 8 b to 8 b + 7.
    std::span<const PointBlock> blocks() const { return blocks_; }

    /// The number of the point at a place. \pre place < points().
    std::int32_t number_at(std::size_t place) const
    {
        return blocks_[place / PointBlock::size].number[place % PointBlock::size];
    }

    /// The point at a place. \pre place < points().
    NumberedPoint point_at(std::size_t place) const
    {
        const PointBlock& block = blocks_[place / PointBlock::size];
        const std::size_t lane = place % PointBlock::size;
        return {{block.x[lane], block.y[lane], block.z[lane]}, block.number[lane]};
    }

private:
    int cell_at(float coordinate, int axis, int count) const
    {
        const float steps = (coordinate - low_[axis]) * cells_per_length_[axis];
        return static_cast<int>(smaller(larger(steps, 0), static_cast<float>(count - 1)));
    }

    void choose_cells(std::span<const NumberedPoint> points, std::size_t least_cells);

    Eigen::Vector2f low_ = Eigen::Vector2f::Zero();
    Eigen::Array2f cells_per_length_ = Eigen::Array2f::Ones();
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint32_t> begin_;    // first place of each cell, and the end
    std::vector<float> lowest_;           // least z of the points of each cell
    std::vector<std::uint32_t> cell_of_;  // for each point of `sort`
    std::vector<PointBlock> blocks_;
};

}  // namespace endmill
