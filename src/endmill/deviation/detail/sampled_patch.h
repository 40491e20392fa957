// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/deviation/detail/tangent_disc.h"

namespace endmill {

/// A query for the nearest place, with the best place found so far.
struct NearestSearch {
    Vec3 place;                ///< mm
    double least_square;       ///< mm^2, squared distance that a place must not exceed
    std::size_t number = 0;    ///< number of the patch with the best place
    std::size_t triangle = 0;  ///< number of its triangle in that patch
    std::optional<Vec3> point = {};  ///< the best place, mm; none yet

    /// Takes a place if it is nearer. Of equally near places that of the first patch, and
    /// of its first triangle, counts.
    void take(const Vec3& found, std::size_t patch, std::size_t of_triangle)
    {
        const double square = (found - place).squaredNorm();
        if (square > least_square)
            return;
        if (square == least_square &&
            (!point || std::pair{number, triangle} <= std::pair{patch, of_triangle}))
            return;
        least_square = square;
        number = patch;
        triangle = of_triangle;
        point = found;
    }

    /// Whether a place in the disc may be nearer or as near.
    bool may_improve(const TangentDisc& disc) const
    {
        return disc.squared_distance(place) * (1 - square_rounding) <= least_square;
    }

    /// Relative rounding error of a squared distance.
    static constexpr double square_rounding = 1e-13;
};

/// A piece of a surface, sampled by a grid of points with two triangles per cell, in a
/// bounding volume hierarchy of tangent discs. It takes about 60 bytes per cell.
class SampledPatch {
public:
    /// \param points in mm, (columns + 1) (rows + 1) of them, row by row.
    /// \param columns number of cells in a row, a power of two.
    /// \param rows number of rows, a power of two.
    /// \throws DomainError for other numbers.
    SampledPatch(std::vector<Vec3> points, int columns, int rows);

    /// Updates the query with the nearest place of the triangles.
    /// \param number of this patch.
    void look(NearestSearch& search, std::size_t number) const;

private:
    struct Range {
        int low_u;
        int low_v;
        int high_u;
        int high_v;

        bool is_leaf() const;
        std::size_t leaves() const;
        std::array<Range, 2> halves() const;
    };

    const Vec3& point(int u, int v) const;
    TangentDisc around(const Range& range) const;
    void add(const Range& range);
    void look_into(NearestSearch& search, std::size_t number, const Range& range,
                   std::size_t node) const;
    void look_at_cells(NearestSearch& search, std::size_t number,
                       const Range& range) const;

    std::vector<Vec3> points_;
    int columns_;
    int rows_;
    double margin_ = 0;  // mm, exceeds the rounding error of a distance from a plane
    // Discs in depth-first order: of a range, then of its lower half with all below, then
    // of its upper half.
    std::vector<TangentDisc> discs_;
};

}  // namespace endmill
