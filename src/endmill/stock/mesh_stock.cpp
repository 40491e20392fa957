// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/mesh_stock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/mesh/mesh_checks.h"

namespace endmill {
namespace {

struct CellRange {
    int first;
    int last;  // included
};

// Returns the cells of a line of `count` from `begin` whose centres may lie in [low,
// high], with one more cell on each side for rounding.
CellRange cells_between(double low, double high, double begin, double pitch, int count)
{
    const double first = std::floor((low - begin) / pitch - 0.5) - 1;
    const double last = std::ceil((high - begin) / pitch - 0.5) + 1;
    return {static_cast<int>(std::clamp(first, 0.0, count - 1.0)),
            static_cast<int>(std::clamp(last, 0.0, count - 1.0))};
}

// Returns twice the signed area of the triangle (x, y), a, b, seen from above. Exchanging
// a and b changes the sign and nothing else. Two triangles with a common edge therefore
// agree on the side of a point, and at least one of them contains a point near the edge.
double side_of(double x, double y, const Vec3& a, const Vec3& b)
{
    return (a.x() - x) * (b.y() - y) - (b.x() - x) * (a.y() - y);
}

// Raises the cells under a triangle to the triangle. Each cell centre in the triangle's
// box is tested by the signs of three edge functions; the same three numbers are the
// barycentric weights of the height.
void raise_under(HeightStock& stock, const std::array<Vec3, 3>& corners)
{
    const auto& [a, b, c] = corners;
    const auto [low_x, high_x] = std::minmax({a.x(), b.x(), c.x()});
    const auto [low_y, high_y] = std::minmax({a.y(), b.y(), c.y()});
    const auto [low_z, high_z] = std::minmax({a.z(), b.z(), c.z()});
    const StockGrid& grid = stock.grid();
    const CellRange columns =
        cells_between(low_x, high_x, grid.low_x, grid.pitch, grid.columns);
    const CellRange rows =
        cells_between(low_y, high_y, grid.low_y, grid.pitch, grid.rows);
    for (int row = rows.first; row <= rows.last; ++row)
        for (int column = columns.first; column <= columns.last; ++column) {
            const double x = grid.x(column);
            const double y = grid.y(row);
            const double at_a = side_of(x, y, b, c);
            const double at_b = side_of(x, y, c, a);
            const double at_c = side_of(x, y, a, b);
            const bool is_inside = (at_a >= 0 && at_b >= 0 && at_c >= 0) ||
                                   (at_a <= 0 && at_b <= 0 && at_c <= 0);
            const double sum = at_a + at_b + at_c;
            if (!is_inside || sum == 0)  // outside, or an upright triangle
                continue;
            const double z = (at_a * a.z() + at_b * b.z() + at_c * c.z()) / sum;
            if (z > stock.height(column, row))
                stock.set_height(column, row, std::clamp(z, low_z, high_z));
        }
}

// Collects the points and triangles of the mesh of a stock. Every full square between
// four cell centres adds two triangles on the top, two at the bottom, and a wall of two
// triangles along each side whose neighbour is not full.
class StockSurface {
public:
    explicit StockSurface(const HeightStock& stock)
        : stock_{stock},
          grid_{stock.grid()},
          numbers_(static_cast<std::size_t>(grid_.columns) * grid_.rows, none)
    {
    }

    TriangleMesh mesh()
    {
        for (int row = 0; row + 1 < grid_.rows; ++row)
            for (int column = 0; column + 1 < grid_.columns; ++column)
                if (is_full(column, row))
                    add_square(column, row);
        return {std::move(points_), std::move(triangles_)};
    }

private:
    static constexpr std::int32_t none = -1;
    static constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();

    bool has_material(int column, int row) const
    {
        return stock_.height(column, row) > grid_.bottom_z;
    }

    // Whether the square from the centre of this cell to the centres of the next column
    // and row is full: all four cells have material.
    bool is_full(int column, int row) const
    {
        return column >= 0 && row >= 0 && column + 1 < grid_.columns &&
               row + 1 < grid_.rows && has_material(column, row) &&
               has_material(column + 1, row) && has_material(column, row + 1) &&
               has_material(column + 1, row + 1);
    }

    // Returns the number of the point on the top. The point below it on the bottom has
    // the next number.
    std::int32_t top(int column, int row)
    {
        std::int32_t& number =
            numbers_[static_cast<std::size_t>(row) * grid_.columns + column];
        if (number == none) {
            if (points_.size() + 2 > most)
                throw LimitError{"the mesh of the stock has more than 2^31 - 1 points"};
            number = static_cast<std::int32_t>(points_.size());
            const double x = grid_.x(column);
            const double y = grid_.y(row);
            points_.emplace_back(x, y, stock_.height(column, row));
            points_.emplace_back(x, y, grid_.bottom_z);
        }
        return number;
    }

    void add_square(int column, int row)
    {
        if (triangles_.size() + 12 > most)
            throw LimitError{"the mesh of the stock has more than 2^31 - 1 triangles"};
        const std::int32_t a = top(column, row);
        const std::int32_t b = top(column + 1, row);
        const std::int32_t c = top(column + 1, row + 1);
        const std::int32_t d = top(column, row + 1);
        triangles_.insert(triangles_.end(), {{a, b, c}, {a, c, d}});
        triangles_.insert(triangles_.end(),
                          {{a + 1, c + 1, b + 1}, {a + 1, d + 1, c + 1}});
        if (!is_full(column, row - 1))
            add_wall(a, b);
        if (!is_full(column + 1, row))
            add_wall(b, c);
        if (!is_full(column, row + 1))
            add_wall(c, d);
        if (!is_full(column - 1, row))
            add_wall(d, a);
    }

    // Adds the wall below an edge of the top. Seen from outside, the edge runs from left
    // to right.
    void add_wall(std::int32_t from, std::int32_t to)
    {
        triangles_.insert(triangles_.end(),
                          {{from, from + 1, to + 1}, {from, to + 1, to}});
    }

    const HeightStock& stock_;
    const StockGrid& grid_;
    std::vector<std::int32_t> numbers_;
    std::vector<Vec3> points_;
    std::vector<Triangle> triangles_;
};

}  // namespace

Block mesh_box(const TriangleMesh& mesh)
{
    if (mesh.triangles().empty())
        throw GeometryError{"the mesh has no triangle"};
    Block box{mesh.corners(0)[0], mesh.corners(0)[0]};
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        for (const Vec3& corner : mesh.corners(k)) {
            box.low = box.low.cwiseMin(corner);
            box.high = box.high.cwiseMax(corner);
        }
    return box;
}

HeightStock mesh_stock(const TriangleMesh& mesh, double pitch)
{
    const Block box = mesh_box(mesh);
    if (!mesh_report(mesh).closed)
        throw GeometryError{"the mesh is open; a stock must be a closed mesh"};
    const StockGrid grid = grid_over(box, pitch);
    HeightStock stock{grid, grid.bottom_z};
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k)
        raise_under(stock, mesh.corners(k));
    return stock;
}

TriangleMesh stock_mesh(const HeightStock& stock)
{
    return StockSurface{stock}.mesh();
}

}  // namespace endmill
