// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to accessibility
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/accessibility/wide_floats.h"

namespace endmill {

/// Points that are dealt with at once, in a layout for registers.
struct alignas(32) PointBlock {
    static constexpr int size = 8;

    std::array<float, size> x;
    std::array<float, size> y;
    std::array<float, size> z;
    std::array<std::int32_t, size> number;  ///< as given; -1 where there is no point
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
    int rows() const { return rows_; }                  ///< along y
    float larger_side() const { return larger_side_; }  ///< of a cell

    int columns() const { return columns_; }  ///< along x

    /// Cells from the first one to a coordinate along `axis`, 0 for x, 1 for y, as a fraction;
    /// at least -1, at most their number. `Float` is a float or several.
    template <typename Float>
    [[gnu::always_inline]] Float steps_to(const Float& coordinate, int axis) const
    {
        const Float steps =
            (coordinate - Float(low_[axis])) * Float(cells_per_length_[axis]);
        return smaller(larger(steps, Float(-1.0F)),
                       Float(static_cast<float>(axis == 0 ? columns_ : rows_)));
    }

    /// The column (row) of cells at x (y), the nearest where there is none.
    int column_at(float x) const { return cell_at(steps_to(x, 0), columns_); }
    int row_at(float y) const
    {
        return cell_at(steps_to(y, 1), rows_);
    }  ///< see column_at

    /// Of the points in the cells of `row`, columns `first` to `last`: that they are those in
    /// the places begin … end in the blocks. None if `last` is -1 or `first` their number.
    /// \pre the row exists.
    std::pair<std::uint32_t, std::uint32_t> range(int row, int first, int last) const
    {
        const std::size_t cell = static_cast<std::size_t>(row) * columns_;
        return {begin_[cell + first], begin_[cell + last + 1]};
    }

    /// Whether `range` has no point.
    bool is_empty(int row, int first, int last) const
    {
        const auto [begin, end] = range(row, first, last);
        return begin == end;
    }

    /// Points 8 b to 8 b + 7 in block b.
    std::span<const PointBlock> blocks() const { return blocks_; }

    /// The number of the point in a place. \pre place < points().
    std::int32_t number_at(std::size_t place) const
    {
        return blocks_[place / PointBlock::size].number[place % PointBlock::size];
    }

private:
    static int cell_at(float steps, int count)
    {
        const int cell = static_cast<int>(steps);
        return cell < 0 ? 0 : cell < count ? cell : count - 1;
    }

    void choose_cells(std::span<const NumberedPoint> points);

    Eigen::Vector2f low_ = Eigen::Vector2f::Zero();
    float larger_side_ = 1;
    Eigen::Array2f cells_per_length_ = Eigen::Array2f::Ones();
    int columns_ = 0;
    int rows_ = 0;
    std::vector<std::uint32_t> begin_;  // of each cell, and the end
    std::vector<std::uint32_t> cell_of_;
    std::vector<PointBlock> blocks_;
};

}  // namespace endmill
