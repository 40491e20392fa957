// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/offset_mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "endmill/core/detail/disjoint_sets.h"
#include "endmill/core/detail/large_pages.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/cutter/cutter.h"
#include "endmill/offset/detail/boundary_strips.h"
#include "endmill/offset/detail/contact_strip.h"
#include "endmill/offset/detail/grid_sides.h"
#include "endmill/offset/detail/offset_grid.h"
#include "endmill/surface/detail/patch_rows.h"
#include "endmill/surface/detail/patch_sides.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

using Index = std::int32_t;

void check(std::span<const Surface> surfaces, const OffsetOptions& options)
{
    require(!surfaces.empty(), "offset_mesh: need a surface");
    require(options.grid_lines >= 2, "offset_mesh: need at least two grid lines");
    require(std::isfinite(options.arc_tolerance) && options.arc_tolerance > 0,
            "offset_mesh: need 0 < arc tolerance");
    double vertices = 0;
    for (const Surface& surface : surfaces)
        vertices += (options.grid_lines + 2.0 * surface.patches(Parameter::U)) *
                    (options.grid_lines + 2.0 * surface.patches(Parameter::V));
    if (vertices > static_cast<double>(options.most_vertices))
        throw LimitError{"the offset would have up to " +
                         std::to_string(static_cast<long long>(vertices)) +
                         " vertices; expected at most " +
                         std::to_string(options.most_vertices)};
}

// Computes the vertices of a grid, row by row. The columns that belong to one patch share
// the basis functions in u (PatchRows), which are evaluated once for all rows.
class GridRows {
public:
    GridRows(const OffsetGrid& grid, const Surface& surface)
        : grid_{grid},
          surface_{surface}
    {
        for (Index begin = 0, end = 0; begin < grid.columns(); begin = end) {
            const int patch = grid.u[begin].patch;
            while (end < grid.columns() && grid.u[end].patch == patch)
                ++end;
            stretches_.push_back({begin, end, rows_of(begin, end, grid.v.front().patch)});
        }
    }

    // Sets the points and contacts of the vertices of row j.
    void add_row(Index j, OffsetDraft& draft) const
    {
        const GridLine& v = grid_.v[j];
        for (const Stretch& stretch : stretches_) {
            const auto& patch = surface_.patch(grid_.u[stretch.begin].patch, v.patch);
            const double at = local(Parameter::V, v);
            const bool is_its = patch.degree(Parameter::U) == stretch.rows.degree();
            const TangentRow row =
                is_its ? stretch.rows.at(patch, at)
                       : rows_of(stretch.begin, stretch.end, v.patch).at(patch, at);
            for (Index i = stretch.begin; i < stretch.end; ++i)
                add_vertex(i, j, row.row(i - stretch.begin), draft);
        }
    }

private:
    // Consecutive columns within one patch.
    struct Stretch {
        Index begin;
        Index end;
        PatchRows rows;
    };

    double local(Parameter along, const GridLine& line) const
    {
        const auto breaks = surface_.breaks(along);
        return (line.parameter - breaks[line.patch]) /
               (breaks[line.patch + 1] - breaks[line.patch]);
    }

    PatchRows rows_of(Index begin, Index end, int row) const
    {
        std::vector<double> u;
        for (Index i = begin; i < end; ++i)
            u.push_back(local(Parameter::U, grid_.u[i]));
        return {surface_.patch(grid_.u[begin].patch, row).degree(Parameter::U), u};
    }

    template <typename Row>
    void add_vertex(Index i, Index j, const Row& row, OffsetDraft& draft) const
    {
        const SurfaceTangents tangents{
            {row[0], row[1], row[2]}, {row[3], row[4], row[5]}, {row[6], row[7], row[8]}};
        const Vec3 normal = normal_at(grid_, surface_, i, j, tangents);
        const Index vertex = grid_.vertex(i, j);
        draft.points[vertex] = tangents.point + control_offset(draft.cutter, normal);
        draft.contacts[vertex] = {{grid_.u[i].parameter, grid_.v[j].parameter},
                                  normal,
                                  grid_.surface,
                                  ContactKind::Face};
    }

    const OffsetGrid& grid_;
    const Surface& surface_;
    std::vector<Stretch> stretches_;
};

// The rows of all grids, one after the other: the number of the grid and of its row.
std::vector<std::pair<std::size_t, Index>> all_rows(std::span<const OffsetGrid> grids)
{
    std::vector<std::pair<std::size_t, Index>> rows;
    for (std::size_t number = 0; number < grids.size(); ++number)
        for (Index j = 0; j < grids[number].rows(); ++j)
            rows.emplace_back(number, j);
    return rows;
}

// Reserves memory for all vertices and triangles. The strips along the border are
// estimated by half a turn of the normal over each border point. They need more only if
// corners, or the bottom of a flat or bull-nose cutter, make up most of the strips. The
// estimate is limited to four times the number of the grids' own vertices.
void make_room(std::span<const OffsetGrid> grids, std::span<const GridSide> sides,
               BoundaryContact boundary, OffsetDraft& draft)
{
    constexpr double most_to_grids = 4;
    double count = 0;
    for (const OffsetGrid& grid : grids)
        count += static_cast<double>(grid.u.size() * grid.v.size());
    if (boundary == BoundaryContact::Contact) {
        const double steps =
            std::numbers::pi / chord_angle(draft.cutter.radius(), draft.arc_tolerance);
        double strips = 0;
        for (const GridSide& side : sides)
            if (side.is_border())
                strips += steps * static_cast<double>(side.vertices.size());
        count += std::min(strips, most_to_grids * count);
    }
    const auto vertices = static_cast<std::size_t>(count);
    reserve_in_large_pages(draft.points, vertices);
    reserve_in_large_pages(draft.contacts, vertices);
    reserve_in_large_pages(draft.triangles, 2 * vertices);
}

void add_vertices(std::span<const Surface> surfaces, std::span<const OffsetGrid> grids,
                  OffsetDraft& draft)
{
    const OffsetGrid& last = grids.back();
    const auto count =
        static_cast<std::size_t>(last.first) + last.u.size() * last.v.size();
    draft.points.resize(count);
    draft.contacts.resize(count);
    std::vector<GridRows> vertices;
    for (const OffsetGrid& grid : grids)
        vertices.emplace_back(grid, surfaces[grid.surface]);
    const auto rows = all_rows(grids);
    parallel_for(rows.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            vertices[rows[k].first].add_row(rows[k].second, draft);
    });
}

// Sets the triangles of the cells above row j, beginning at `place`.
void set_cells(const OffsetGrid& grid, Index j, std::span<Triangle> place)
{
    const bool is_mirrored = grid.side < 0;
    for (Index i = 0; i + 1 < grid.columns(); ++i) {
        const Index a = grid.vertex(i, j);
        const Index c = grid.vertex(i, j + 1);
        place[2 * i] = {a, a + 1, c + 1};
        place[2 * i + 1] = {a, c + 1, c};
        if (is_mirrored) {
            std::swap(place[2 * i][1], place[2 * i][2]);
            std::swap(place[2 * i + 1][1], place[2 * i + 1][2]);
        }
    }
}

void add_cells(std::span<const OffsetGrid> grids, OffsetDraft& draft)
{
    const auto rows = all_rows(grids);
    std::vector<std::size_t> first{0};
    for (const auto& [grid, j] : rows) {
        const bool is_last = j + 1 == grids[grid].rows();
        first.push_back(first.back() + (is_last ? 0 : 2 * grids[grid].u.size() - 2));
    }
    draft.triangles.resize(first.back());
    parallel_for(rows.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            if (first[k + 1] > first[k])
                set_cells(grids[rows[k].first], rows[k].second,
                          std::span{draft.triangles}.subspan(first[k]));
    });
}

// Merges the vertices on smooth joints and on collapsed edges that lie within
// `same_point` mm of each other, and removes the triangles that become degenerate.
void join_vertices(std::span<GridSide> sides, double same_point, OffsetDraft& draft)
{
    DisjointSets sets{draft.points.size()};
    bool is_any = false;
    const auto join = [&](Index one, Index two) {
        if ((draft.points[one] - draft.points[two]).norm() <= same_point)
            is_any = sets.join(one, two) || is_any;
    };
    for (const GridSide& side : sides) {
        const std::size_t count = side.vertices.size();
        if (side.is_collapsed)
            for (std::size_t k = 1; k < count; ++k)
                join(side.vertices[k - 1], side.vertices[k]);
        else if (side.mate != GridSide::none)
            for (std::size_t k = 0; k < count; ++k)
                join(side.vertices[k], sides[side.mate].vertices[count - 1 - k]);
    }
    if (!is_any)
        return;
    for (GridSide& side : sides)
        for (Index& vertex : side.vertices)
            vertex = sets.least(vertex);
    for (Triangle& triangle : draft.triangles)
        for (Index& vertex : triangle)
            vertex = sets.least(vertex);
    std::erase_if(draft.triangles, [](const Triangle& triangle) {
        return triangle[0] == triangle[1] || triangle[1] == triangle[2] ||
               triangle[2] == triangle[0];
    });
}

std::vector<std::vector<Index>> outlines_of(std::span<const GridSide> sides)
{
    std::vector<std::vector<Index>> outlines;
    for (const GridSide& side : sides)
        if (!side.is_collapsed)
            outlines.push_back(side.vertices);
    return outlines;
}

}  // namespace

// 1. Each surface is divided into grids without creases (offset_grid.h), and the sides of
//    the grids are matched (grid_sides.h).
// 2. Vertices and cells of the grids are computed on all threads.
// 3. Vertices on smooth joints and on collapsed edges are merged.
// 4. With BoundaryContact::Contact the strips over creases and along the border are added
//    (boundary_strips.h), so that the mesh is closed but for a rim of level normals.
OffsetMesh offset_mesh(std::span<const Surface> surfaces, const Cutter& cutter,
                       const OffsetOptions& options)
{
    check(surfaces, options);
    const auto tool_sides = tool_side_signs(surfaces, Vec3::UnitZ());
    require_reachable(surfaces, Vec3::UnitZ(), tool_sides);
    const auto grids = offset_grids(surfaces, tool_sides, options.grid_lines);
    OffsetDraft draft{with_allowance(cutter, options.allowance), options.arc_tolerance,
                      options.most_vertices};
    const double same_point = same_end_mm(surfaces);
    auto sides = grid_sides(surfaces, grids, same_point);
    make_room(grids, sides, options.boundary, draft);
    add_vertices(surfaces, grids, draft);
    add_cells(grids, draft);
    join_vertices(sides, same_point, draft);
    const std::size_t surface_triangles = draft.triangles.size();
    std::size_t part_triangles = surface_triangles;
    if (options.boundary == BoundaryContact::Contact) {
        const auto seams = add_crease_strips(sides, draft);
        part_triangles = draft.triangles.size();
        add_border_strips(sides, seams, draft);
    }
    return {TriangleMesh{std::move(draft.points), std::move(draft.triangles)},
            std::move(draft.contacts),
            draft.cutter,
            surface_triangles,
            part_triangles,
            outlines_of(sides)};
}

Vec3 contact_point(const OffsetMesh& offset, std::int32_t vertex)
{
    return offset.mesh.points()[vertex] -
           control_offset(offset.cutter, offset.contacts[vertex].normal);
}

TriangleMesh contact_mesh(const OffsetMesh& offset)
{
    const std::size_t count = offset.mesh.points().size();
    std::vector<Vec3> contacts(count);
    for (std::size_t vertex = 0; vertex < count; ++vertex)
        contacts[vertex] = contact_point(offset, static_cast<std::int32_t>(vertex));
    const auto triangles = offset.mesh.triangles().first(offset.surface_triangles);
    return {std::move(contacts), {triangles.begin(), triangles.end()}};
}

std::vector<std::optional<Interval>> path_ranges(const OffsetMesh& offset,
                                                 const DrivePlanes& planes,
                                                 std::span<const PlaneSection> sections)
{
    const DriveFrame& frame = planes.frame;
    std::vector<std::optional<Interval>> ranges;
    for (const PlaneSection& section : sections)
        ranges.push_back(section.part_range);
    const auto extend = [&](std::size_t plane, double s) {
        auto& range = ranges[plane];
        range = range ? Interval{std::min(range->low, s), std::max(range->high, s)}
                      : Interval{s, s};
    };
    for (const auto& outline : offset.outlines)
        for (std::size_t k = 1; k < outline.size(); ++k) {
            Vec3 below = contact_point(offset, outline[k - 1]);
            Vec3 above = contact_point(offset, outline[k]);
            if (frame.across(below) > frame.across(above))
                std::swap(below, above);
            const double low = frame.across(below);
            const double high = frame.across(above);
            auto plane = std::ranges::lower_bound(planes.positions, low);
            for (; plane != planes.positions.end() && *plane < high; ++plane)
                extend(static_cast<std::size_t>(plane - planes.positions.begin()),
                       std::lerp(frame.along(below), frame.along(above),
                                 (*plane - low) / (high - low)));
        }
    return ranges;
}

}  // namespace endmill
