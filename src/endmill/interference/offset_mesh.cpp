// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/offset_mesh.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/cutter/reference_point.h"
#include "endmill/interference/boundary_strips.h"
#include "endmill/interference/contact_strip.h"
#include "endmill/interference/offset_sheet.h"
#include "endmill/interference/sheet_sides.h"
#include "endmill/mesh/disjoint_sets.h"
#include "endmill/surface/patch_sides.h"
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

// Fills in the vertices of row j.
void add_row(const OffsetSheet& sheet, const Surface& surface, Index j,
             OffsetDraft& draft)
{
    for (Index i = 0; i < sheet.columns(); ++i) {
        const SurfaceTangents tangents = tangents_at(sheet, surface, i, j);
        const Vec3 normal = normal_at(sheet, surface, i, j, tangents);
        const Index vertex = sheet.vertex(i, j);
        draft.points[vertex] = tangents.point + control_offset(draft.cutter, normal);
        draft.contacts[vertex] = {{sheet.u[i].parameter, sheet.v[j].parameter},
                                  normal,
                                  sheet.surface,
                                  ContactKind::Face};
    }
}

// The rows of all sheets, one after the other.
std::vector<std::pair<std::size_t, Index>> all_rows(std::span<const OffsetSheet> sheets)
{
    std::vector<std::pair<std::size_t, Index>> rows;
    for (std::size_t number = 0; number < sheets.size(); ++number)
        for (Index j = 0; j < sheets[number].rows(); ++j)
            rows.emplace_back(number, j);
    return rows;
}

void add_vertices(std::span<const Surface> surfaces, std::span<const OffsetSheet> sheets,
                  OffsetDraft& draft)
{
    const OffsetSheet& last = sheets.back();
    const auto count =
        static_cast<std::size_t>(last.first) + last.u.size() * last.v.size();
    draft.points.resize(count);
    draft.contacts.resize(count);
    const auto rows = all_rows(sheets);
    parallel_for(rows.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const auto& [sheet, j] = rows[k];
            add_row(sheets[sheet], surfaces[sheets[sheet].surface], j, draft);
        }
    });
}

// The triangles of the cells above row j, from `place` on.
void set_cells(const OffsetSheet& sheet, Index j, std::span<Triangle> place)
{
    const bool is_mirrored = sheet.side < 0;
    for (Index i = 0; i + 1 < sheet.columns(); ++i) {
        const Index a = sheet.vertex(i, j);
        const Index c = sheet.vertex(i, j + 1);
        place[2 * i] = {a, a + 1, c + 1};
        place[2 * i + 1] = {a, c + 1, c};
        if (is_mirrored) {
            std::swap(place[2 * i][1], place[2 * i][2]);
            std::swap(place[2 * i + 1][1], place[2 * i + 1][2]);
        }
    }
}

std::vector<Triangle> cells_of(std::span<const OffsetSheet> sheets)
{
    const auto rows = all_rows(sheets);
    std::vector<std::size_t> first{0};
    for (const auto& [sheet, j] : rows) {
        const bool is_last = j + 1 == sheets[sheet].rows();
        first.push_back(first.back() + (is_last ? 0 : 2 * sheets[sheet].u.size() - 2));
    }
    std::vector<Triangle> triangles(first.back());
    parallel_for(rows.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            if (first[k + 1] > first[k])
                set_cells(sheets[rows[k].first], rows[k].second,
                          std::span{triangles}.subspan(first[k]));
    });
    return triangles;
}

// Makes one the vertices of smooth joints and of collapsed edges.
void join_vertices(std::span<SheetSide> sides, double same_point, OffsetDraft& draft)
{
    DisjointSets sets{draft.points.size()};
    bool is_any = false;
    const auto join = [&](Index one, Index two) {
        if ((draft.points[one] - draft.points[two]).norm() <= same_point)
            is_any = sets.join(one, two) || is_any;
    };
    for (const SheetSide& side : sides) {
        const std::size_t count = side.vertices.size();
        if (side.is_collapsed)
            for (std::size_t k = 1; k < count; ++k)
                join(side.vertices[k - 1], side.vertices[k]);
        else if (side.mate != SheetSide::none)
            for (std::size_t k = 0; k < count; ++k)
                join(side.vertices[k], sides[side.mate].vertices[count - 1 - k]);
    }
    if (!is_any)
        return;
    for (SheetSide& side : sides)
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

std::vector<std::vector<Index>> outlines_of(std::span<const SheetSide> sides)
{
    std::vector<std::vector<Index>> outlines;
    for (const SheetSide& side : sides)
        if (!side.is_collapsed)
            outlines.push_back(side.vertices);
    return outlines;
}

}  // namespace

OffsetMesh offset_mesh(std::span<const Surface> surfaces, const Cutter& cutter,
                       const OffsetOptions& options)
{
    check(surfaces, options);
    const auto tool_sides = tool_side_signs(surfaces, Vec3::UnitZ());
    require_reachable(surfaces, Vec3::UnitZ(), tool_sides);
    const auto sheets = offset_sheets(surfaces, tool_sides, options.grid_lines);
    OffsetDraft draft{
        with_allowance(cutter, options.allowance), options.arc_tolerance, {}, {}, {}};
    add_vertices(surfaces, sheets, draft);
    draft.triangles = cells_of(sheets);
    const double same_point = same_end_mm(surfaces);
    auto sides = sheet_sides(surfaces, sheets, same_point);
    join_vertices(sides, same_point, draft);
    const std::size_t sheet_triangles = draft.triangles.size();
    std::size_t own_triangles = sheet_triangles;
    if (options.boundary == BoundaryContact::Contact) {
        const auto seams = add_crease_strips(sides, draft);
        own_triangles = draft.triangles.size();
        add_border_strips(sides, seams, draft);
    }
    return {TriangleMesh{std::move(draft.points), std::move(draft.triangles)},
            std::move(draft.contacts),
            draft.cutter,
            sheet_triangles,
            own_triangles,
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
    const auto triangles = offset.mesh.triangles().first(offset.sheet_triangles);
    return {std::move(contacts), {triangles.begin(), triangles.end()}};
}

std::vector<std::optional<Interval>> path_ranges(const OffsetMesh& offset,
                                                 const DrivePlanes& planes,
                                                 std::span<const PlaneSection> sections)
{
    const DriveFrame& frame = planes.frame;
    std::vector<std::optional<Interval>> ranges;
    for (const PlaneSection& section : sections)
        ranges.push_back(section.own_range);
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
