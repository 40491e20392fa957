// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/stock/dexel_stock.h"

// A ray along z lies in one square between the centres of four cells. A ray along x or y
// passes such squares one after the other; each square adds the stretch of the ray in it to
// a set if the ray is below the height that counts there.

namespace endmill {
namespace {

// Share of a cell within which a place counts as a centre.
constexpr double at_centre = 1e-9;

// The lowest and the highest height of some cells, mm.
struct Bounds {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

// The two neighbouring lines of cells between whose centres a place lies, clipped to the
// grid; they are equal on a centre.
struct Lines {
    int first;
    int last;

    // \param at place in cells from the grid's side.
    Lines(double at, int count)
    {
        const double from_centre = at - 0.5;
        const double nearest = std::round(from_centre);
        const bool is_centre = std::abs(from_centre - nearest) <= at_centre;
        const double low = is_centre ? nearest : std::floor(from_centre);
        const double high = is_centre ? nearest : low + 1;
        first = static_cast<int>(std::clamp(low, 0.0, count - 1.0));
        last = static_cast<int>(std::clamp(high, 0.0, count - 1.0));
    }
};

Bounds bounds_in(const HeightStock& heights, const Lines& columns, const Lines& rows)
{
    Bounds bounds;
    for (const int row : {rows.first, rows.last})
        for (const int column : {columns.first, columns.last}) {
            const double height = heights.height(column, row);
            bounds.low = std::min(bounds.low, height);
            bounds.high = std::max(bounds.high, height);
        }
    return bounds;
}

// Makes the dexels of one ray.
class RayOverHeights {
public:
    RayOverHeights(const HeightStock& heights, const DexelStock& stock)
        : heights_{heights},
          grid_{heights.grid()},
          stock_{stock}
    {
    }

    Dexel along_z(const Vec3& start) const
    {
        const Bounds bounds = bounds_in(heights_, lines_x(start.x()), lines_y(start.y()));
        const double bottom = stock_.block().low.z();
        Dexel dexel;
        add(dexel.upper, 0, units_up(bounds.high - bottom, 2));
        add(dexel.lower, 0, units_down(bounds.low - bottom, 2));
        return dexel;
    }

    // \param axis 0 or 1.
    Dexel along(int axis, const Vec3& start) const
    {
        const double low = stock_.block().low[axis];
        const double side = stock_.block().high[axis] - low;
        const double begin = axis == 0 ? grid_.low_x : grid_.low_y;
        const int count = axis == 0 ? grid_.columns : grid_.rows;
        const Lines across = axis == 0 ? lines_y(start.y()) : lines_x(start.x());
        Dexel dexel;
        double from = 0;
        for (int line = -1; line < count; ++line) {
            // From the centre of this line of cells to that of the next one.
            const double to =
                line + 1 < count
                    ? std::min(begin + (line + 1.5) * grid_.pitch - low, side)
                    : side;
            const Lines lines{line + 1.0, count};
            const Bounds bounds = axis == 0 ? bounds_in(heights_, lines, across)
                                            : bounds_in(heights_, across, lines);
            if (start.z() < bounds.high)
                add(dexel.upper, units_down(from, axis), units_up(to, axis));
            if (start.z() < bounds.low)
                add(dexel.lower, units_up(from, axis), units_down(to, axis));
            from = to;
        }
        return dexel;
    }

private:
    Lines lines_x(double x) const
    {
        return {(x - grid_.low_x) / grid_.pitch, grid_.columns};
    }
    Lines lines_y(double y) const
    {
        return {(y - grid_.low_y) / grid_.pitch, grid_.rows};
    }
    std::int32_t units_up(double length, int axis) const
    {
        return static_cast<std::int32_t>(std::min(
            std::ceil(length / stock_.unit()), static_cast<double>(stock_.units(axis))));
    }
    // A length of the whole side stays one.
    std::int32_t units_down(double length, int axis) const
    {
        const Block& block = stock_.block();
        return length >= block.high[axis] - block.low[axis]
                   ? stock_.units(axis)
                   : static_cast<std::int32_t>(std::floor(length / stock_.unit()));
    }

    // Adds an interval that begins at the end of the last one, or beyond. Neighbouring
    // squares share an end, which is rounded to two neighbouring units.
    static void add(std::vector<DexelInterval>& set, std::int32_t from, std::int32_t to)
    {
        if (from >= to)
            return;
        if (!set.empty() && from <= set.back().to + 1)
            set.back().to = std::max(set.back().to, to);
        else
            set.push_back({from, to});
    }

    const HeightStock& heights_;
    const StockGrid& grid_;
    const DexelStock& stock_;
};

}  // namespace

DexelStock dexels_of_heights(const HeightStock& heights, double pitch)
{
    const Block box = material_box(heights);
    if (!(box.low.z() < box.high.z()))
        throw GeometryError{"the stock of heights has no material"};
    DexelStock stock{box, pitch};
    const RayOverHeights ray{heights, stock};
    for (int axis = 0; axis < 3; ++axis) {
        DexelField& field = stock.field(axis);
        std::vector<Dexel> dexels;
        dexels.reserve(static_cast<std::size_t>(field.columns()) * field.rows());
        for (int row = 0; row < field.rows(); ++row)
            for (int column = 0; column < field.columns(); ++column) {
                const Vec3 start = field.start(column, row);
                dexels.push_back(axis == 2 ? ray.along_z(start) : ray.along(axis, start));
            }
        field.assign(dexels);
    }
    return stock;
}

}  // namespace endmill
