// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/sampling_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/detail/bend_bounds.h"
#include "endmill/surface/detail/patch_sides.h"

namespace endmill {
namespace {

// Level that would divide a patch into a million cells along one parameter.
constexpr int most_level = 20;

using PieceBounds = std::vector<BendBounds>;

// The bound over a block of `columns` by `rows` pieces that starts at piece (i, j).
BendBounds joined(const PieceBounds& pieces, int i, int j, int columns, int rows)
{
    BendBounds bounds{0, 0, 0};
    for (int row = j; row < j + rows; ++row)
        for (int column = i; column < i + columns; ++column) {
            const BendBounds& piece = pieces[row * bounded_pieces + column];
            bounds.uu = std::max(bounds.uu, piece.uu);
            bounds.uv = std::max(bounds.uv, piece.uv);
            bounds.vv = std::max(bounds.vv, piece.vv);
        }
    return bounds;
}

// The greatest error of a cell, from the bounds on the pieces that it covers, or on the
// piece that covers it.
double chord_error(const PieceBounds& pieces, const PatchLevels& levels)
{
    const int columns = std::max(1, bounded_pieces >> levels.u);
    const int rows = std::max(1, bounded_pieces >> levels.v);
    double error = 0;
    for (int j = 0; j < bounded_pieces; j += rows)
        for (int i = 0; i < bounded_pieces; i += columns)
            error = std::max(error, joined(pieces, i, j, columns, rows)
                                        .chord_error(std::ldexp(1.0, -levels.u),
                                                     std::ldexp(1.0, -levels.v)));
    return error;
}

// The levels with the fewest cells; of several such levels those that differ least.
std::optional<PatchLevels> fewest_cells(const PieceBounds& pieces, double tolerance)
{
    std::optional<PatchLevels> best;
    for (int u = 0; u <= most_level; ++u)
        for (int v = 0; v <= most_level; ++v) {
            const bool is_better = !best || u + v < best->u + best->v ||
                                   (u + v == best->u + best->v &&
                                    std::abs(u - v) < std::abs(best->u - best->v));
            if (is_better && chord_error(pieces, {u, v}) <= tolerance)
                best = PatchLevels{u, v};
        }
    return best;
}

}  // namespace

SamplingLevels::SamplingLevels(const Surface& surface, double chord_tolerance)
    : columns_{surface.patches(Parameter::U)},
      rows_{surface.patches(Parameter::V)},
      along_u_(static_cast<std::size_t>(columns_) * (rows_ + 1), 0),
      along_v_(static_cast<std::size_t>(columns_ + 1) * rows_, 0)
{
    for (int j = 0; j < rows_; ++j)
        for (int i = 0; i < columns_; ++i) {
            const PieceBounds pieces = bend_bounds(surface.patch(i, j));
            const auto levels = fewest_cells(pieces, chord_tolerance);
            if (!levels)
                throw LimitError{"a chord tolerance of " + to_text(chord_tolerance) +
                                 " mm needs more than 2^20 cells along a patch; expected "
                                 "a larger one"};
            patches_.push_back(*levels);
            chord_error_mm_ = std::max(chord_error_mm_, chord_error(pieces, *levels));
            raise_side(Parameter::U, i, j, levels->u);
            raise_side(Parameter::U, i, j + 1, levels->u);
            raise_side(Parameter::V, i, j, levels->v);
            raise_side(Parameter::V, i + 1, j, levels->v);
        }
}

int& SamplingLevels::side_level(Parameter along, int i, int j)
{
    return along == Parameter::U ? along_u_[j * columns_ + i]
                                 : along_v_[j * (columns_ + 1) + i];
}

int SamplingLevels::side(Parameter along, int i, int j) const
{
    return along == Parameter::U ? along_u_[j * columns_ + i]
                                 : along_v_[j * (columns_ + 1) + i];
}

void SamplingLevels::raise_side(Parameter along, int i, int j, int level)
{
    int& own = side_level(along, i, j);
    own = std::max(own, level);
}

double SamplingLevels::triangles() const
{
    double count = 0;
    for (const PatchLevels& levels : patches_)
        count += 2 * std::ldexp(1.0, levels.u + levels.v);
    for (const auto* sides : {&along_u_, &along_v_})
        for (const int level : *sides)
            // An upper bound, reached where the patch is coarser than its side.
            count += 2 * std::ldexp(1.0, level);
    return count;
}

bool match_meeting_sides(std::span<const Surface> surfaces,
                         std::span<SamplingLevels> levels)
{
    const std::vector<PatchSide> sides = patch_sides(surfaces);
    const auto pairs = meeting_sides(sides, same_end_mm(surfaces));
    const auto corner = [](const PatchSide& side) {
        const Parameter across = side.along == Parameter::U ? Parameter::V : Parameter::U;
        const int line = side.end == 0 ? 0 : side.surface->patches(across);
        return side.along == Parameter::U ? std::array{side.patch, line}
                                          : std::array{line, side.patch};
    };
    // Where more than two sides meet, a level may have to spread from one to the next.
    for (bool raised = true; raised;) {
        raised = false;
        for (const auto& [one, other] : pairs) {
            const PatchSide& a = sides[one];
            const PatchSide& b = sides[other];
            const auto [ai, aj] = corner(a);
            const auto [bi, bj] = corner(b);
            const int level_a = levels[a.number].side(a.along, ai, aj);
            const int level_b = levels[b.number].side(b.along, bi, bj);
            levels[a.number].raise_side(a.along, ai, aj, level_b);
            levels[b.number].raise_side(b.along, bi, bj, level_a);
            raised = raised || level_a != level_b;
        }
    }
    return !pairs.empty();
}

namespace {

// Numbers of the breaks at which the surface is divided, both ends included.
std::vector<int> cuts(const Surface& surface, Parameter along)
{
    const int columns = surface.patches(Parameter::U);
    const int rows = surface.patches(Parameter::V);
    const auto breaks = border_breaks(surface);  // those across u come first
    const bool is_u = along == Parameter::U;
    const int per_line = is_u ? rows : columns;
    const int first = is_u ? 0 : (columns - 1) * rows;
    std::vector<int> numbers{0};
    for (int k = 1; k < surface.patches(along); ++k) {
        const auto on_line =
            std::span{breaks}.subspan(first + (k - 1) * per_line, per_line);
        if (std::ranges::any_of(on_line, [](const BorderBreak& border) {
                return border.continuity == Continuity::None;
            }))
            numbers.push_back(k);
    }
    numbers.push_back(surface.patches(along));
    return numbers;
}

}  // namespace

std::vector<Surface> parted_at_gaps(const Surface& surface)
{
    const std::vector<int> cuts_u = cuts(surface, Parameter::U);
    const std::vector<int> cuts_v = cuts(surface, Parameter::V);
    const auto breaks = [&](Parameter along, int first, int last) {
        const auto all = surface.breaks(along);
        return std::vector<double>{all.begin() + first, all.begin() + last + 1};
    };
    std::vector<Surface> parts;
    for (std::size_t b = 0; b + 1 < cuts_v.size(); ++b)
        for (std::size_t a = 0; a + 1 < cuts_u.size(); ++a) {
            std::vector<BezierPatch> patches;
            for (int j = cuts_v[b]; j < cuts_v[b + 1]; ++j)
                for (int i = cuts_u[a]; i < cuts_u[a + 1]; ++i)
                    patches.push_back(surface.patch(i, j));
            parts.emplace_back(breaks(Parameter::U, cuts_u[a], cuts_u[a + 1]),
                               breaks(Parameter::V, cuts_v[b], cuts_v[b + 1]),
                               std::move(patches), surface.tool_side());
        }
    return parts;
}

double grid_cell_error(const Surface& surface, const SurfacePoint& low,
                       const SurfacePoint& high)
{
    constexpr int places = 4;
    const auto point = [&](double s, double t) {
        return surface.tangents(std::lerp(low.u, high.u, s), std::lerp(low.v, high.v, t))
            .point;
    };
    const Vec3 a = point(0, 0);
    const Vec3 b = point(1, 0);
    const Vec3 c = point(1, 1);
    const Vec3 d = point(0, 1);
    double error = 0;
    for (int l = 0; l < places; ++l)
        for (int k = 0; k < places; ++k) {
            const double s = (k + 0.5) / places;
            const double t = (l + 0.5) / places;
            const Vec3 flat = s >= t ? Vec3{a + (s - t) * (b - a) + t * (c - a)}
                                     : Vec3{a + s * (c - a) + (t - s) * (d - a)};
            error = std::max(error, (point(s, t) - flat).norm());
        }
    return error;
}

}  // namespace endmill
