// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace endmill {

/// A box around projected facets.
struct ProjectedBox {
    Eigen::Vector3f low;
    Eigen::Vector3f high;
};

/// The largest z of the boxes over each cell of a grid in x and y.
class BoxHeights {
public:
    /// Removes all boxes and divides the region of `boxes` into about twice as many cells.
    void reset(std::span<const ProjectedBox> boxes);

    /// Adds a box. \pre it lies in the region.
    void add(const ProjectedBox& box);

    /// Tests whether no added box that overlaps `box` in x and y reaches its lowest z. It may
    /// also be false for a box that is clear.
    bool are_clear_of(const ProjectedBox& box) const;

private:
    // Wide boxes are added to a grid of wider cells, so that no box has many cells.
    struct Grid {
        int columns = 0;
        int rows = 0;
        Eigen::Array2f cells_per_length = {0, 0};
        std::vector<float> highest;  // of each cell
    };
    // Columns and rows from `first` to `last`.
    struct Cells {
        std::array<int, 2> first;
        std::array<int, 2> last;

        int count() const { return (last[0] - first[0] + 1) * (last[1] - first[1] + 1); }
    };

    Cells cells_of(const Grid& grid, const ProjectedBox& box) const;

    Eigen::Array2f low_ = {0, 0};
    std::array<Grid, 2> grids_;  // fine and coarse
};

}  // namespace endmill
