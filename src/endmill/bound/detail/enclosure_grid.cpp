// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/enclosure_grid.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Leaves along the side of a block.
constexpr int block = 8;

Vec3 middle_of(const IntervalVector& box)
{
    return {(box[0].low + box[0].high) / 2, (box[1].low + box[1].high) / 2,
            (box[2].low + box[2].high) / 2};
}

double radius_of(const IntervalVector& box)
{
    return std::hypot(box[0].length(), box[1].length(), box[2].length()) / 2;
}

// Lines with every step divided into `parts`, and `more` lines beyond both ends.
std::vector<double> divided(std::span<const double> lines, std::span<const int> parts,
                            int more)
{
    std::vector<double> result;
    const double first = (lines[1] - lines[0]) / parts.front();
    for (int k = more; k > 0; --k)
        result.push_back(lines.front() - k * first);
    for (std::size_t k = 0; k + 1 < lines.size(); ++k)
        for (int part = 0; part < parts[k]; ++part)
            result.push_back(
                std::lerp(lines[k], lines[k + 1], part / static_cast<double>(parts[k])));
    const double last = (lines.back() - lines[lines.size() - 2]) / parts.back();
    for (int k = 0; k <= more; ++k)
        result.push_back(lines.back() + k * last);
    return result;
}

// g in the cell as a bilinear function of the parameters, over a box.
IntervalSeries<1> density_series(const DensityGrid& grid, const DensityCell& cell,
                                 std::span<const double> density, const ParameterBox& box)
{
    const auto corners = grid.corners(cell.node);
    const double a = density[corners[0]];
    const double b = density[corners[1]];
    const double c = density[corners[2]];
    const double d = density[corners[3]];
    const auto share = [](const Interval& range, const Interval& of) -> Interval {
        return {std::max(0.0, (range.low - of.low) / of.length()),
                std::min(1.0, (range.high - of.low) / of.length())};
    };
    const Interval s = share(box.u, cell.u);
    const Interval t = share(box.v, cell.v);
    IntervalSeries<1> result;
    const auto at = [&](double x, double y) {
        return std::lerp(std::lerp(a, b, x), std::lerp(c, d, x), y);
    };
    const auto [low, high] = std::minmax(
        {at(s.low, t.low), at(s.high, t.low), at(s.low, t.high), at(s.high, t.high)});
    result(0, 0) = {low, high};
    result(1, 0) = 1 / cell.u.length() * (Interval{b - a, b - a} + (a - b - c + d) * t);
    result(0, 1) = 1 / cell.v.length() * (Interval{c - a, c - a} + (a - b - c + d) * s);
    return result;
}

// Whether two jets agree up to rounding.
bool agree(const SurfaceJet& a, const SurfaceJet& b)
{
    constexpr double accuracy = 1e-9;
    const auto near = [](const Vec3& x, const Vec3& y, double size) {
        return (x - y).norm() <= accuracy * size;
    };
    const double size =
        std::max({a.du.norm(), a.dv.norm(), a.duu.norm(), a.duv.norm(), a.dvv.norm()});
    return near(a.du, b.du, size) && near(a.dv, b.dv, size) && near(a.duu, b.duu, size) &&
           near(a.duv, b.duv, size) && near(a.dvv, b.dvv, size);
}

// The borders of patches along a parameter at which derivatives up to the second jump. They
// are compared at more places than the degree of their polynomials.
std::vector<double> jumps(const Surface& surface, Parameter along)
{
    const Parameter other = along == Parameter::U ? Parameter::V : Parameter::U;
    const std::span<const double> breaks = surface.breaks(along);
    const std::span<const double> others = surface.breaks(other);
    std::vector<double> result;
    for (int border = 1; border < surface.patches(along); ++border) {
        bool is_smooth = true;
        for (int patch = 0; patch < surface.patches(other); ++patch) {
            const auto jet = [&](int number, double at) {
                return along == Parameter::U
                           ? surface.jet_in_patch(number, patch, breaks[border], at)
                           : surface.jet_in_patch(patch, number, at, breaks[border]);
            };
            const int places = 4 * surface.patch(0, 0).degree(other) + 1;
            for (int k = 0; k <= places && is_smooth; ++k) {
                const double at = std::lerp(others[patch], others[patch + 1],
                                            k / static_cast<double>(places));
                is_smooth = agree(jet(border - 1, at), jet(border, at));
            }
        }
        if (!is_smooth)
            result.push_back(breaks[border]);
    }
    return result;
}

// The number of the step between lines that contains a number.
int step_of(std::span<const double> lines, double number)
{
    return static_cast<int>(std::ranges::upper_bound(lines, number) - lines.begin()) - 1;
}

}  // namespace

EnclosureGrid::EnclosureGrid(const BoundedPart& part, const BoundProblem& problem,
                             const DensityGrid& grid, std::span<const double> density,
                             double leaf, double beyond)
    : part_{part},
      problem_{problem},
      grid_{grid}
{
    for (std::size_t surface = 0; surface < part.surfaces.size(); ++surface) {
        add_sheet(surface, leaf, beyond);
        fill(sheets_.back(), surface, density);
        add_blocks(sheets_.back());
    }
}

// The cells of the density are stored row by row.
void EnclosureGrid::add_sheet(std::size_t surface, double leaf, double beyond)
{
    std::vector<double> u;
    std::vector<double> v;
    std::vector<double> length_u;
    std::vector<double> length_v;
    for (const DensityCell& cell : grid_.cells()) {
        if (cell.surface != surface)
            continue;
        if (v.empty() || cell.v.low > v.back()) {
            v.push_back(cell.v.low);
            length_v.push_back(0);
        }
        const auto column =
            static_cast<std::size_t>(std::ranges::lower_bound(u, cell.u.low) - u.begin());
        if (column == u.size()) {
            u.push_back(cell.u.low);
            length_u.push_back(0);
        }
        length_u[column] = std::max(length_u[column], cell.length_u);
        length_v.back() = std::max(length_v.back(), cell.length_v);
    }
    u.push_back(part_.surfaces[surface].range(Parameter::U).high);
    v.push_back(part_.surfaces[surface].range(Parameter::V).high);
    const auto parts = [&](std::span<const double> lengths) {
        std::vector<int> result;
        for (const double length : lengths)
            result.push_back(std::max(1, static_cast<int>(std::lround(length / leaf))));
        return result;
    };
    const int more = static_cast<int>(std::ceil(beyond / leaf));
    Sheet sheet;
    sheet.u = divided(u, parts(length_u), more);
    sheet.v = divided(v, parts(length_v), more);
    sheet.jumps_u = jumps(part_.surfaces[surface], Parameter::U);
    sheet.jumps_v = jumps(part_.surfaces[surface], Parameter::V);
    sheets_.push_back(std::move(sheet));
}

void EnclosureGrid::fill(Sheet& sheet, std::size_t surface,
                         std::span<const double> density)
{
    const Surface& of = part_.surfaces[surface];
    const Interval range_u = of.range(Parameter::U);
    const Interval range_v = of.range(Parameter::V);
    const int columns = static_cast<int>(sheet.u.size()) - 1;
    const int rows = static_cast<int>(sheet.v.size()) - 1;
    std::vector<const DensityCell*> cell_of_node(grid_.nodes());
    for (const DensityCell& cell : grid_.cells())
        cell_of_node[cell.node] = &cell;
    sheet.leaves.resize(static_cast<std::size_t>(columns) * rows);
    sheet.middles.resize(sheet.leaves.size());
    sheet.radii.resize(sheet.leaves.size());
    parallel_for(sheet.leaves.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const ParameterBox box = this->box(surface, static_cast<int>(k) % columns,
                                               static_cast<int>(k) / columns);
            const SurfacePoint middle{(box.u.low + box.u.high) / 2,
                                      (box.v.low + box.v.high) / 2};
            const auto found =
                raised_enclosure(part_, contact_place(part_, surface, middle), box,
                                 problem_.scallop_height);
            SurfaceLeaf& leaf = sheet.leaves[k];
            leaf.is_inside = range_u.low <= middle.u && middle.u <= range_u.high &&
                             range_v.low <= middle.v && middle.v <= range_v.high;
            if (!found)
                throw GeometryError{
                    "certified_bound: the part has no normal, or its extension beyond "
                    "the "
                    "border has none, near " +
                    place_text(middle, of.tangents(middle.u, middle.v).point)};
            leaf.point = found->point;
            leaf.tangents = found->tangents;
            leaf.seconds = found->seconds;
            leaf.surface = found->surface;
            leaf.normal = found->normal;
            sheet.middles[k] = middle_of(leaf.point);
            sheet.radii[k] = radius_of(leaf.point);
            if (!leaf.is_inside)
                continue;
            leaf.node = grid_.place(surface, middle).node;
            IntervalSeries<1> area;
            area(0, 0) = found->area;
            area(1, 0) = found->area_slope[0];
            area(0, 1) = found->area_slope[1];
            const IntervalSeries<1> product =
                density_series(grid_, *cell_of_node[leaf.node], density, box) * area;
            leaf.density = product(0, 0);
            leaf.density_slope = {product(1, 0), product(0, 1)};
        }
    });
}

void EnclosureGrid::add_blocks(Sheet& sheet)
{
    const int columns = static_cast<int>(sheet.u.size()) - 1;
    const int rows = static_cast<int>(sheet.v.size()) - 1;
    sheet.blocks_u = (columns + block - 1) / block;
    sheet.blocks_v = (rows + block - 1) / block;
    for (int j = 0; j < sheet.blocks_v; ++j)
        for (int i = 0; i < sheet.blocks_u; ++i) {
            const auto visit = [&](const auto& with) {
                for (int b = j * block; b < std::min(rows, (j + 1) * block); ++b)
                    for (int a = i * block; a < std::min(columns, (i + 1) * block); ++a)
                        with(static_cast<std::size_t>(b) * columns + a);
            };
            Vec3 sum = Vec3::Zero();
            int count = 0;
            visit([&](std::size_t k) {
                sum += sheet.middles[k];
                ++count;
            });
            const Vec3 middle = sum / count;
            double radius = 0;
            visit([&](std::size_t k) {
                radius =
                    std::max(radius, (sheet.middles[k] - middle).norm() + sheet.radii[k]);
            });
            sheet.block_middles.push_back(middle);
            sheet.block_radii.push_back(radius);
        }
}

std::optional<LeafRange> EnclosureGrid::range(std::size_t surface,
                                              const ParameterBox& box) const
{
    const Sheet& sheet = sheets_[surface];
    if (!(box.u.low >= sheet.u.front() && box.u.high <= sheet.u.back() &&
          box.v.low >= sheet.v.front() && box.v.high <= sheet.v.back()))
        return std::nullopt;
    const int columns = static_cast<int>(sheet.u.size()) - 1;
    const int rows = static_cast<int>(sheet.v.size()) - 1;
    return LeafRange{std::min(step_of(sheet.u, box.u.low), columns - 1),
                     std::min(step_of(sheet.u, box.u.high), columns - 1),
                     std::min(step_of(sheet.v, box.v.low), rows - 1),
                     std::min(step_of(sheet.v, box.v.high), rows - 1)};
}

EnclosureGrid::Near EnclosureGrid::near(std::size_t surface, const ToolReach& tool,
                                        double radius) const
{
    Near found;
    for (std::size_t number = 0; number < sheets_.size(); ++number) {
        const Sheet& sheet = sheets_[number];
        const int columns = static_cast<int>(sheet.u.size()) - 1;
        const int rows = static_cast<int>(sheet.v.size()) - 1;
        for (std::size_t b = 0; b < sheet.block_middles.size(); ++b) {
            if (tool.excess(sheet.block_middles[b]) > radius + sheet.block_radii[b])
                continue;
            const int low_u = static_cast<int>(b) % sheet.blocks_u * block;
            const int low_v = static_cast<int>(b) / sheet.blocks_u * block;
            for (int j = low_v; j < std::min(rows, low_v + block); ++j)
                for (int i = low_u; i < std::min(columns, low_u + block); ++i) {
                    const std::size_t k = static_cast<std::size_t>(j) * columns + i;
                    if (tool.excess(sheet.middles[k]) > radius + sheet.radii[k])
                        continue;
                    if (number != surface) {
                        if (sheet.leaves[k].is_inside)
                            found.cells_of_others.push_back(sheet.leaves[k].node);
                        continue;
                    }
                    found.columns.push_back(i);
                    found.rows.push_back(j);
                    if (!found.own)
                        found.own = LeafRange{i, i, j, j};
                    LeafRange& own = *found.own;
                    own = {std::min(own.low_u, i), std::max(own.high_u, i),
                           std::min(own.low_v, j), std::max(own.high_v, j)};
                }
        }
    }
    return found;
}

bool EnclosureGrid::has_jump(std::size_t surface, const ParameterBox& box) const
{
    const auto meets = [](std::span<const double> jumps, const Interval& range) {
        return std::ranges::any_of(jumps, [&](double at) { return contains(range, at); });
    };
    return meets(sheets_[surface].jumps_u, box.u) ||
           meets(sheets_[surface].jumps_v, box.v);
}

// On a box of widths a and b the integral of a function is at least its value in the
// middle, less an eighth of the widths of its derivatives times a and b, times the area.
double EnclosureGrid::least_integral(std::span<const double> density) const
{
    double sum = 0;
    for (const DensityCell& cell : grid_.cells()) {
        const auto place =
            ContactPlace{cell.surface, cell.i, cell.j, {cell.u.low, cell.v.low}};
        constexpr int parts = 2;
        const double a = cell.u.length() / parts;
        const double b = cell.v.length() / parts;
        for (int j = 0; j < parts; ++j)
            for (int i = 0; i < parts; ++i) {
                const ParameterBox box{{cell.u.low + i * a, cell.u.low + (i + 1) * a},
                                       {cell.v.low + j * b, cell.v.low + (j + 1) * b}};
                const SurfacePoint middle{(box.u.low + box.u.high) / 2,
                                          (box.v.low + box.v.high) / 2};
                const auto found = raised_enclosure(part_, place, box, 0);
                if (!found)
                    continue;
                IntervalSeries<1> area;
                area(0, 0) = found->area;
                area(1, 0) = found->area_slope[0];
                area(0, 1) = found->area_slope[1];
                const IntervalSeries<1> product =
                    density_series(grid_, cell, density, box) * area;
                const SurfaceTangents at =
                    part_.surfaces[cell.surface].tangents(middle.u, middle.v);
                const double value =
                    grid_.value(density, grid_.place(cell.surface, middle)) *
                    at.du.cross(at.dv).norm();
                sum += a * b *
                       std::max(0.0, value - (product(1, 0).length() * a +
                                              product(0, 1).length() * b) /
                                                 8);
            }
    }
    return sum;
}

}  // namespace endmill
