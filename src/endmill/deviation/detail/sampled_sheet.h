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

/// The question for the nearest place, and what has been found so far.
struct NearestSearch {
    Vec3 place;                ///< mm
    double least_square;       ///< mm^2: what is not nearer is of no interest
    std::size_t number = 0;    ///< of the sheet that was looked at last but found better
    std::size_t triangle = 0;  ///< of that sheet
    std::optional<Vec3> point = {};

    /// Takes a place if it is nearer; of equal ones that of the first sheet, and triangle.
    void take(const Vec3& found, std::size_t sheet, std::size_t of_triangle)
    {
        const double square = (found - place).squaredNorm();
        if (square > least_square)
            return;
        if (square == least_square &&
            (!point || std::pair{number, triangle} <= std::pair{sheet, of_triangle}))
            return;
        least_square = square;
        number = sheet;
        triangle = of_triangle;
        point = found;
    }

    /// Whether what lies in the slab could be nearer, or as near.
    bool may_improve(const Slab& slab) const
    {
        return slab.squared_distance(place) * (1 - rounding) <= least_square;
    }

    /// Relative, of the square of a distance.
    static constexpr double rounding = 1e-13;
};

/// A piece of a surface by points in rows and columns, two triangles a cell, in a tree of
/// slabs. About 150 bytes a cell.
class SampledSheet {
public:
    /// \param points in mm, (columns + 1) (rows + 1) of them, row by row.
    /// \param columns of cells, and \param rows: powers of two.
    /// \throws DomainError for other numbers.
    SampledSheet(std::vector<Vec3> points, int columns, int rows);

    /// Looks whether a place of the triangles improves on what is found. \param number of
    /// this sheet.
    void look(NearestSearch& search, std::size_t number) const;

private:
    struct Range {
        int low_u;
        int low_v;
        int high_u;
        int high_v;

        int cells() const { return (high_u - low_u) * (high_v - low_v); }
        std::array<Range, 2> halves() const;
    };

    const Vec3& point(int u, int v) const;
    Slab around(const Range& range) const;
    void add(const Range& range);
    void look_into(NearestSearch& search, std::size_t number, const Range& range,
                   std::size_t node) const;
    void look_at_cell(NearestSearch& search, std::size_t number, const Range& cell) const;

    std::vector<Vec3> points_;
    int columns_;
    int rows_;
    double margin_ = 0;  // mm: more than rounding makes of a distance from a plane
    // Of a range, of its lower half and of all in that, and of its upper half.
    std::vector<Slab> slabs_;
};

}  // namespace endmill
