// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/core/detail/lanes.h"

namespace endmill {

/// Points that are dealt with at once, in a layout for registers.
struct alignas(32) PointBlock {
    static constexpr int size = 8;

    std::array<float, size> x;
    std::array<float, size> y;
    std::array<float, size> z;
    std::array<std::int32_t, size>
        number;  ///< as given; -1 where there is no point, x infinite
};

/// A point to be sorted in.
struct NumberedPoint {
    Eigen::Vector3f place;
    std::int32_t number;
};

/// Points sorted into about as many cells of x and y as there are points. What it
/// keeps is used again for the next points.
class PointCells {
public:
    /// \pre places are finite.
    void sort(std::span<const NumberedPoint> points);

    std::size_t points() const { return begin_.empty() ? 0 : begin_.back(); }  ///< count
    int rows() const { return rows_; }        ///< along y
    int columns() const { return columns_; }  ///< along x

    /// The column (row) of cells at x (y), the nearest where there is none.
    int column_at(float x) const { return cell_at(x, 0, columns_); }
    int row_at(float y) const { return cell_at(y, 1, rows_); }  ///< see column_at

    /// The places of the points in some cells of a row, columns `first` to `last`: the first one,
    /// and that behind the last. \pre row and columns exist.
    std::pair<std::uint32_t, std::uint32_t> range(int row, int first, int last) const
    {
        const std::size_t cell = static_cast<std::size_t>(row) * columns_;
        return {begin_[cell + first], begin_[cell + last + 1]};
    }

    /// Points 8 b to 8 b + 7 in block b.
    std::span<const PointBlock> blocks() const { return blocks_; }

    /// The number of the point in a place. \pre place < points().
    std::int32_t number_at(std::size_t place) const
    {
        return blocks_[place / PointBlock::size].number[place % PointBlock::size];
    }

private:
    int cell_at(float coordinate, int axis, int count) const
    {
        const float steps = (coordinate - low_[axis]) * cells_per_length_[axis];
        return static_cast<int>(smaller(larger(steps, 0), static_cast<float>(count - 1)));
    }

    void choose_cells(std::span<const NumberedPoint> points);

    Eigen::Vector2f low_ = Eigen::Vector2f::Zero();
    Eigen::Array2f cells_per_length_ = Eigen::Array2f::Ones();
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint32_t> begin_;  // of each cell, and the end
    std::vector<std::uint32_t> cell_of_;
    std::vector<PointBlock> blocks_;
};

}  // namespace endmill
