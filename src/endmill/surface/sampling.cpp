// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/sampling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/mesh/detail/weld.h"
#include "endmill/surface/detail/collapsed_edge.h"
#include "endmill/surface/detail/patch_sides.h"
#include "endmill/surface/detail/sampling_levels.h"
#include "endmill/surface/extent.h"

namespace endmill {
namespace {

// Points of meeting sides closer than this share of the part's size become one.
constexpr double welded_point_share = 1e-9;
constexpr double rounding_share = 1e-11;  // of the largest coordinate
// Unit normals that differ by more than this are different normals.
constexpr double same_normal = 1e-6;

using Index = std::int32_t;

// A mesh under construction, with the normals at its points.
struct Draft {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    std::vector<Vec3> normals;  // zero where the surface has no normal

    Index add(const Surface& surface, int i, int j, const SurfacePoint& at, double side)
    {
        const SurfaceJet jet = surface.jet_in_patch(i, j, at.u, at.v);
        const auto inward = [&](Parameter along, double parameter) {
            return parameter < surface.range(along).high ? 1 : -1;
        };
        const auto normal =
            limit_normal(jet, {inward(Parameter::U, at.u), inward(Parameter::V, at.v)});
        points.push_back(jet.point);
        normals.push_back(normal ? Vec3{side * *normal} : Vec3::Zero());
        return static_cast<Index>(points.size() - 1);
    }

    void add_triangle(Index a, Index b, Index c, double side)
    {
        if (side > 0)
            triangles.push_back({a, b, c});
        else
            triangles.push_back({a, c, b});
    }
};

// Numbers of the points along one side of a patch, both ends included.
using SidePoints = std::vector<Index>;

// Adds the triangles of one surface to a draft:
// 1. the corners of all patches;
// 2. the points along all sides, each side once, so that neighbouring patches share them;
// 3. patch by patch, the inner points and the triangles. A cell next to a side that is
//    sampled more finely than the patch is divided into a fan around its middle.
class SurfaceSampler {
public:
    SurfaceSampler(const Surface& surface, double side, const SamplingLevels& levels,
                   Draft& draft)
        : surface_{surface},
          side_{side},
          levels_{levels},
          draft_{draft},
          columns_{surface.patches(Parameter::U)},
          rows_{surface.patches(Parameter::V)}
    {
    }

    void draw()
    {
        add_corners();
        for (int j = 0; j <= rows_; ++j)
            for (int i = 0; i < columns_; ++i)
                along_u_.push_back(side_points(Parameter::U, i, j));
        for (int j = 0; j < rows_; ++j)
            for (int i = 0; i <= columns_; ++i)
                along_v_.push_back(side_points(Parameter::V, i, j));
        for (int j = 0; j < rows_; ++j)
            for (int i = 0; i < columns_; ++i)
                draw_patch(i, j);
    }

private:
    double break_at(Parameter along, int number) const
    {
        return surface_.breaks(along)[number];
    }

    // The parameter at `part` of `parts` of patch `number`. At both ends it equals the
    // break exactly.
    double parameter(Parameter along, int number, int part, int parts) const
    {
        return std::lerp(break_at(along, number), break_at(along, number + 1),
                         part / double(parts));
    }

    Index add(int i, int j, const SurfacePoint& at)
    {
        return draft_.add(surface_, std::min(i, columns_ - 1), std::min(j, rows_ - 1), at,
                          side_);
    }

    void add_corners()
    {
        for (int j = 0; j <= rows_; ++j)
            for (int i = 0; i <= columns_; ++i)
                corners_.push_back(
                    add(i, j, {break_at(Parameter::U, i), break_at(Parameter::V, j)}));
    }

    Index corner(int i, int j) const { return corners_[j * (columns_ + 1) + i]; }

    // The points of the side along `along` that starts at corner (i, j).
    SidePoints side_points(Parameter along, int i, int j)
    {
        const bool is_u = along == Parameter::U;
        const int parts = 1 << levels_.side(along, i, j);
        SidePoints points{corner(i, j)};
        for (int k = 1; k < parts; ++k)
            points.push_back(
                add(i, j,
                    {is_u ? parameter(along, i, k, parts) : break_at(Parameter::U, i),
                     is_u ? break_at(Parameter::V, j) : parameter(along, j, k, parts)}));
        points.push_back(corner(i + (is_u ? 1 : 0), j + (is_u ? 0 : 1)));
        return points;
    }

    // The points of a patch of n by m cells: the points of its sides and its inner
    // points.
    struct PatchPoints {
        int n;
        int m;
        const SidePoints& low_v;
        const SidePoints& high_u;
        const SidePoints& high_v;
        const SidePoints& low_u;
        Index inner;  // number of the first inner point

        Index at(int k, int l) const
        {
            if (l == 0 || l == m)
                return on_side(l == 0 ? low_v : high_v, k, n);
            if (k == 0 || k == n)
                return on_side(k == 0 ? low_u : high_u, l, m);
            return inner + (l - 1) * (n - 1) + k - 1;
        }

        bool is_inside(int k, int l) const
        {
            return k > 0 && k + 1 < n && l > 0 && l + 1 < m;
        }

        static Index on_side(const SidePoints& side, int part, int parts)
        {
            return side[part * ((side.size() - 1) / parts)];
        }
    };

    void draw_patch(int i, int j)
    {
        const PatchLevels levels = levels_.patch(i, j);
        const int n = 1 << levels.u;
        const int m = 1 << levels.v;
        const PatchPoints points{n,
                                 m,
                                 along_u_[j * columns_ + i],
                                 along_v_[j * (columns_ + 1) + i + 1],
                                 along_u_[(j + 1) * columns_ + i],
                                 along_v_[j * (columns_ + 1) + i],
                                 static_cast<Index>(draft_.points.size())};
        for (int l = 1; l < m; ++l)
            for (int k = 1; k < n; ++k)
                add(i, j,
                    {parameter(Parameter::U, i, k, n), parameter(Parameter::V, j, l, m)});
        for (int l = 0; l < m; ++l)
            for (int k = 0; k < n; ++k)
                if (points.is_inside(k, l))
                    draw_quadrangle(points.at(k, l), points.at(k + 1, l),
                                    points.at(k + 1, l + 1), points.at(k, l + 1));
                else
                    draw_cell(outline(points, k, l),
                              {i,
                               j,
                               {parameter(Parameter::U, i, 2 * k + 1, 2 * n),
                                parameter(Parameter::V, j, 2 * l + 1, 2 * m)}});
    }

    // All points around cell (k, l), counter-clockwise in u and v.
    static std::vector<Index> outline(const PatchPoints& points, int k, int l)
    {
        const auto& [n, m, low_v, high_u, high_v, low_u, inner] = points;
        std::vector<Index> outline;
        const auto append = [&](const SidePoints& side, int part, int parts,
                                bool backwards) {
            const auto steps = static_cast<int>(side.size() - 1) / parts;
            for (int step = 0; step < steps; ++step)
                outline.push_back(
                    side[backwards ? (part + 1) * steps - step : part * steps + step]);
        };
        const SidePoints bottom{points.at(k, l), points.at(k + 1, l)};
        const SidePoints right{points.at(k + 1, l), points.at(k + 1, l + 1)};
        const SidePoints top{points.at(k, l + 1), points.at(k + 1, l + 1)};
        const SidePoints left{points.at(k, l), points.at(k, l + 1)};
        // A side of the patch may have more points here than the two corners of the cell.
        append(l == 0 ? low_v : bottom, l == 0 ? k : 0, l == 0 ? n : 1, false);
        append(k + 1 == n ? high_u : right, k + 1 == n ? l : 0, k + 1 == n ? m : 1,
               false);
        append(l + 1 == m ? high_v : top, l + 1 == m ? k : 0, l + 1 == m ? n : 1, true);
        append(k == 0 ? low_u : left, k == 0 ? l : 0, k == 0 ? m : 1, true);
        return outline;
    }

    // Divides a quadrangle along its shorter diagonal.
    void draw_quadrangle(Index a, Index b, Index c, Index d)
    {
        const auto& points = draft_.points;
        if ((points[a] - points[c]).squaredNorm() <=
            (points[b] - points[d]).squaredNorm()) {
            draft_.add_triangle(a, b, c, side_);
            draft_.add_triangle(a, c, d, side_);
        } else {
            draft_.add_triangle(a, b, d, side_);
            draft_.add_triangle(b, c, d, side_);
        }
    }

    struct CellMiddle {
        int i;
        int j;
        SurfacePoint at;
    };

    // A cell with more than four points becomes a fan around its middle.
    void draw_cell(const std::vector<Index>& outline, const CellMiddle& middle)
    {
        if (outline.size() == 4) {
            draw_quadrangle(outline[0], outline[1], outline[2], outline[3]);
            return;
        }
        const Index centre = add(middle.i, middle.j, middle.at);
        for (std::size_t k = 0; k < outline.size(); ++k)
            draft_.add_triangle(centre, outline[k], outline[(k + 1) % outline.size()],
                                side_);
    }

    const Surface& surface_;
    double side_;
    const SamplingLevels& levels_;
    Draft& draft_;
    int columns_;
    int rows_;
    std::vector<Index> corners_;
    // Sides that start at corner (i, j), at [j * columns + i].
    std::vector<SidePoints> along_u_;
    std::vector<SidePoints> along_v_;  // the same, at [j * (columns + 1) + i]
};

// Whether an edge of a patch is a single point.
bool has_pole(const Surface& surface)
{
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i)
            for (const Parameter along : {Parameter::U, Parameter::V})
                if (is_collapsed(surface.patch(i, j), along, 0) ||
                    is_collapsed(surface.patch(i, j), along, 1))
                    return true;
    return false;
}

// Merges points closer than `tolerance` and removes the triangles that lose a corner.
// Where the normals of merged points disagree, the result has none.
Draft welded(const Draft& draft, double tolerance, double& max_chord_error_mm)
{
    const WeldedMesh after = weld(TriangleMesh{draft.points, draft.triangles}, tolerance);
    max_chord_error_mm += after.largest_move;
    const auto points = after.mesh.points();
    std::vector<std::optional<Vec3>> normals(points.size());
    Draft result{{points.begin(), points.end()}, {}, {}};
    for (std::size_t t = 0; t < draft.triangles.size(); ++t) {
        const Triangle& corners = after.mesh.triangles()[t];
        for (int k = 0; k < 3; ++k) {
            const Vec3& own = draft.normals[draft.triangles[t][k]];
            auto& normal = normals[corners[k]];
            if (!normal)
                normal = own;
            else if ((*normal - own).norm() > same_normal)
                normal = Vec3::Zero();
        }
        if (corners[0] != corners[1] && corners[1] != corners[2] &&
            corners[2] != corners[0])
            result.triangles.push_back(corners);
    }
    for (const auto& normal : normals)
        result.normals.push_back(normal.value_or(Vec3::Zero()));
    return result;
}

// Gives a point without a normal the mean of the normals of its triangles, weighted by
// area.
void complete_normals(Draft& draft)
{
    std::vector<Vec3> sums;
    for (const Triangle& t : draft.triangles)
        for (const Index corner : t) {
            if (!draft.normals[corner].isZero())
                continue;
            if (sums.empty())
                sums.assign(draft.points.size(), Vec3::Zero());
            const Vec3& a = draft.points[t[0]];
            sums[corner] += (draft.points[t[1]] - a).cross(draft.points[t[2]] - a);
        }
    for (std::size_t k = 0; k < sums.size(); ++k)
        if (draft.normals[k].isZero())
            draft.normals[k] = sums[k].stableNormalized();
}

// Throws LimitError if there would be too many triangles.
void require_room(double triangles, std::size_t most)
{
    most = std::min(most, most_possible_triangles);
    if (triangles > static_cast<double>(most))
        throw LimitError{"the mesh would have about " + to_text(triangles) +
                         " triangles; expected at most " + std::to_string(most) +
                         ": a larger tolerance or a coarser grid makes fewer"};
}

SampledSurface finished(Draft draft, double max_chord_error_mm)
{
    if (draft.triangles.empty())
        throw GeometryError{"the surface has no area: it is a point or a line"};
    complete_normals(draft);
    return {TriangleMesh{std::move(draft.points), std::move(draft.triangles)},
            std::move(draft.normals), max_chord_error_mm};
}

// Distance below which points become one: a share of the size, and above the rounding of
// coordinates far from the origin.
double same_point_mm(std::span<const Surface> surfaces, const Draft& draft)
{
    double size = 0;
    for (const Surface& surface : surfaces)
        size = std::max(size, surface.diagonal());
    double farthest = 0;
    for (const Vec3& point : draft.points)
        farthest = std::max(farthest, point.lpNorm<Eigen::Infinity>());
    return std::max(welded_point_share * size, rounding_share * farthest);
}

}  // namespace

double default_chord_tolerance(std::span<const Surface> surfaces)
{
    constexpr double share = 1e-3;
    // So that a side of 10 mm less its rounding counts as 10 mm.
    constexpr double side_rounding = 1e-9;
    double longest = 0;
    for (int c = 0; c < 3; ++c)
        longest = std::max(longest, extent(surfaces, Vec3::Unit(c)).length());
    const double tolerance = share * longest * (1 + side_rounding);
    const double digit = std::pow(10, std::floor(std::log10(tolerance)));
    return std::floor(tolerance / digit) * digit;
}

SampledSurface sampled(std::span<const Surface> surfaces, std::span<const double> sides,
                       double chord_tolerance, std::size_t most_triangles)
{
    require(std::isfinite(chord_tolerance) && chord_tolerance > 0,
            "sampled: need 0 < chord tolerance");
    require(surfaces.size() == sides.size(), "sampled: need a side for each surface");
    std::vector<Surface> pieces;
    std::vector<double> piece_sides;
    for (std::size_t number = 0; number < surfaces.size(); ++number)
        for (Surface& piece : parted_at_gaps(surfaces[number])) {
            pieces.push_back(std::move(piece));
            piece_sides.push_back(sides[number]);
        }
    std::vector<SamplingLevels> levels;
    levels.reserve(pieces.size());
    for (const Surface& piece : pieces)
        levels.emplace_back(piece, chord_tolerance);
    const bool meet = match_meeting_sides(pieces, levels);
    double triangles = 0;
    double error = 0;
    for (const SamplingLevels& own : levels) {
        triangles += own.triangles();
        error = std::max(error, own.chord_error_mm());
    }
    require_room(triangles, most_triangles);
    Draft draft;
    for (std::size_t number = 0; number < pieces.size(); ++number)
        SurfaceSampler{pieces[number], piece_sides[number], levels[number], draft}.draw();
    if (meet || std::ranges::any_of(pieces, has_pole))
        draft = welded(draft, same_point_mm(pieces, draft), error);
    return finished(std::move(draft), error);
}

SampledSurface sampled_on_grid(std::span<const Surface> surfaces,
                               std::span<const double> sides, int lines,
                               std::size_t most_triangles)
{
    require(lines >= 2, "sampled_on_grid: need at least two lines");
    require(surfaces.size() == sides.size(),
            "sampled_on_grid: need a side for each surface");
    const double cells = double(lines - 1) * (lines - 1);
    require_room(2 * cells * static_cast<double>(surfaces.size()), most_triangles);
    Draft draft;
    double error = 0;
    bool poles = false;
    for (std::size_t number = 0; number < surfaces.size(); ++number) {
        const Surface& surface = surfaces[number];
        poles = poles || has_pole(surface);
        const auto start = static_cast<Index>(draft.points.size());
        const auto parameter = [&](Parameter along, double line) {
            const auto [low, high] = surface.range(along);
            return std::lerp(low, high, line / (lines - 1));
        };
        const auto patch = [&](Parameter along, double value) {
            return surface.patch_number(along, value);
        };
        for (int l = 0; l < lines; ++l)
            for (int k = 0; k < lines; ++k) {
                const double u = parameter(Parameter::U, k);
                const double v = parameter(Parameter::V, l);
                draft.add(surface, patch(Parameter::U, u), patch(Parameter::V, v), {u, v},
                          sides[number]);
            }
        for (int l = 0; l + 1 < lines; ++l)
            for (int k = 0; k + 1 < lines; ++k) {
                const Index a = start + l * lines + k;
                draft.add_triangle(a, a + 1, a + lines + 1, sides[number]);
                draft.add_triangle(a, a + lines + 1, a + lines, sides[number]);
                error = std::max(
                    error,
                    grid_cell_error(
                        surface, {parameter(Parameter::U, k), parameter(Parameter::V, l)},
                        {parameter(Parameter::U, k + 1),
                         parameter(Parameter::V, l + 1)}));
            }
    }
    if (poles)
        draft = welded(draft, same_point_mm(surfaces, draft), error);
    return finished(std::move(draft), error);
}

}  // namespace endmill
