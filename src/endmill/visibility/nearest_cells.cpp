// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "endmill/core/error.h"

// How the nearest cells are found.
//
// 1. Cells are distributed to 64 classes by the dot product of their centre and the tool
//    axis.
// 2. The classes are visited from the nearest one outwards. Cells that reach no facet of
//    those still wanted are dropped, the others are sorted by their dot product.
// 3. Cells are taken in this order. A cell that reaches a wanted facet is listed, and its
//    facets are no longer wanted. Only a few cells are sorted, because most facets are
//    reached by the first classes.

namespace endmill {
namespace {

using Columns = std::span<const std::uint64_t>;

constexpr std::size_t classes = 64;  // of the dot product, from 1 down to -1

// Dot products that differ by less are equal. Their rounding is 1e-16, and dot products
// of different distances differ by 1e-6 or more.
constexpr double equal_dots = 1e-12;

struct NearCell {
    double dot;
    std::size_t cell;
};

std::size_t class_of(double dot)
{
    const double place = (1 - dot) * (classes / 2.0);
    return place <= 0 ? 0 : std::min(static_cast<std::size_t>(place), classes - 1);
}

// The cells in classes of their dot product with a direction.
class NearnessClasses {
public:
    NearnessClasses(std::span<const Vec3> centres, const Vec3& axis)
        : dots_(centres.size()),
          cells_(centres.size())
    {
        for (std::size_t i = 0; i < centres.size(); ++i) {
            dots_[i] = axis.dot(centres[i]);
            ++begins_[class_of(dots_[i]) + 1];
        }
        for (std::size_t i = 0; i < classes; ++i)
            begins_[i + 1] += begins_[i];
        std::array<std::size_t, classes + 1> next = begins_;
        for (std::size_t i = 0; i < centres.size(); ++i)
            cells_[next[class_of(dots_[i])]++] = i;
    }

    std::span<const std::size_t> cells_of(std::size_t number) const
    {
        return {cells_.data() + begins_[number], begins_[number + 1] - begins_[number]};
    }

    double dot(std::size_t cell) const { return dots_[cell]; }

private:
    std::vector<double> dots_;
    std::vector<std::size_t> cells_;  // sorted by class, then by number
    std::array<std::size_t, classes + 1> begins_{};
};

bool have_common_bit(Columns wanted, Columns column)
{
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        if ((wanted[i] & column[i]) != 0)
            return true;
    }
    return false;
}

// One beyond the last of the cells from `begin` on that are equally near, each as its
// predecessor.
std::size_t end_of_equals(const std::vector<NearCell>& near, std::size_t begin)
{
    std::size_t end = begin + 1;
    while (end < near.size() && near[end - 1].dot - near[end].dot <= equal_dots)
        ++end;
    return end;
}

// The facets whose nearest cell is not known yet, and the cells found.
class WantedFacets {
public:
    WantedFacets(const VisibilityMap& map, std::size_t pose)
        : map_{map},
          wanted_(map.words())
    {
        for (std::size_t i = 0; i < wanted_.size(); ++i)
            wanted_[i] = ~map.column(pose)[i];
        if (map.facets() % 64 != 0)
            wanted_.back() &= (std::uint64_t{1} << (map.facets() % 64)) - 1;
    }

    bool want(std::size_t cell) const
    {
        return have_common_bit(wanted_, map_.column(cell));
    }

    bool are_none() const
    {
        return std::all_of(wanted_.begin(), wanted_.end(),
                           [](std::uint64_t word) { return word == 0; });
    }

    // Takes equally near cells, the lowest first.
    void take(std::span<NearCell> equals)
    {
        std::sort(equals.begin(), equals.end(),
                  [](const NearCell& a, const NearCell& b) { return a.cell < b.cell; });
        for (const NearCell& near : equals) {
            if (!want(near.cell))
                continue;
            found_.push_back(near.cell);
            for (std::size_t i = 0; i < wanted_.size(); ++i)
                wanted_[i] &= ~map_.column(near.cell)[i];
        }
    }

    std::vector<std::size_t> found() && { return std::move(found_); }

private:
    const VisibilityMap& map_;
    std::vector<std::uint64_t> wanted_;
    std::vector<std::size_t> found_;
};

}  // namespace

std::vector<std::size_t> nearest_cells(const VisibilityMap& map,
                                       std::span<const Vec3> centres, std::size_t pose)
{
    require(centres.size() == map.cells() && pose < map.cells(),
            "nearest_cells: need a centre for each cell, and a pose that is a cell");
    const NearnessClasses cells{centres, centres[pose]};
    WantedFacets facets{map, pose};
    std::vector<NearCell>
        near;  // the cells of a class, and those left by the class before
    for (std::size_t number = 0; number < classes && !facets.are_none(); ++number) {
        for (const std::size_t cell : cells.cells_of(number)) {
            if (facets.want(cell))
                near.push_back({cells.dot(cell), cell});
        }
        std::sort(near.begin(), near.end(), [](const NearCell& a, const NearCell& b) {
            return a.dot != b.dot ? a.dot > b.dot : a.cell < b.cell;
        });
        // Cells at the far end of the class wait, because the next class may have equally
        // near cells.
        const double far_end = 1 - static_cast<double>(number + 1) / (classes / 2.0);
        std::size_t begin = 0;
        while (begin < near.size()) {
            const std::size_t end = end_of_equals(near, begin);
            if (number + 1 < classes && near[end - 1].dot - far_end <= equal_dots)
                break;
            facets.take(std::span{near}.subspan(begin, end - begin));
            begin = end;
        }
        near.erase(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    return std::move(facets).found();
}

}  // namespace endmill
