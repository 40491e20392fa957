// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/density_grid.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Lines of a patch on which its size is measured, and chords of each.
constexpr int measured_lines = 5;
constexpr int measured_chords = 16;

// The rule of Gauss with three points on the unit interval.
constexpr std::array<double, 3> gauss_places{0.1127016653792583, 0.5, 0.8872983346207417};
constexpr std::array<double, 3> gauss_weights{5.0 / 18, 8.0 / 18, 5.0 / 18};

// Mean length in mm of the lines of patch number `number` along a parameter, over the
// whole surface in the other one.
double mean_length(const Surface& surface, Parameter along, int number)
{
    const Parameter other = along == Parameter::U ? Parameter::V : Parameter::U;
    const std::span<const double> breaks = surface.breaks(along);
    double sum = 0;
    int lines = 0;
    for (int patch = 0; patch < surface.patches(other); ++patch) {
        const std::span<const double> across = surface.breaks(other).subspan(patch, 2);
        for (int line = 0; line < measured_lines; ++line, ++lines) {
            const double fixed =
                std::lerp(across[0], across[1], (line + 0.5) / measured_lines);
            Vec3 last;
            for (int k = 0; k <= measured_chords; ++k) {
                const double running = std::lerp(breaks[number], breaks[number + 1],
                                                 k / double{measured_chords});
                const auto tangents = along == Parameter::U
                                          ? surface.tangents(running, fixed)
                                          : surface.tangents(fixed, running);
                if (k > 0)
                    sum += (tangents.point - last).norm();
                last = tangents.point;
            }
        }
    }
    return sum / lines;
}

}  // namespace

DensityGrid::DensityGrid(const BoundedPart& part, double spacing) : part_{part}
{
    require(spacing > 0, "DensityGrid: the spacing must be positive");
    std::size_t nodes = 0;
    for (const Surface& surface : part.surfaces) {
        lines_.push_back({lines(surface, Parameter::U, spacing),
                          lines(surface, Parameter::V, spacing)});
        first_nodes_.push_back(static_cast<std::uint32_t>(nodes));
        const auto& [u, v] = lines_.back();
        nodes += u.places.size() * v.places.size();
        rows_.resize(nodes, static_cast<std::uint32_t>(u.places.size()));
    }
    weights_.resize(nodes);
    for (std::size_t surface = 0; surface < part.surfaces.size(); ++surface)
        add_cells(surface, first_nodes_[surface]);
}

DensityGrid::Lines DensityGrid::lines(const Surface& surface, Parameter along,
                                      double spacing) const
{
    Lines lines;
    const std::span<const double> breaks = surface.breaks(along);
    for (int patch = 0; patch < surface.patches(along); ++patch) {
        const int steps = std::max(
            1,
            static_cast<int>(std::lround(mean_length(surface, along, patch) / spacing)));
        lines.first.push_back(static_cast<int>(lines.places.size()));
        for (int k = 0; k < steps; ++k)
            lines.places.push_back(
                std::lerp(breaks[patch], breaks[patch + 1], k / double(steps)));
    }
    lines.first.push_back(static_cast<int>(lines.places.size()));
    lines.places.push_back(breaks.back());
    return lines;
}

void DensityGrid::measure(DensityCell& cell) const
{
    const auto point = [&](double u, double v) -> Vec3 {
        return part_.surfaces[cell.surface].tangents(u, v).point;
    };
    const Vec3 a = point(cell.u.low, cell.v.low);
    const Vec3 b = point(cell.u.high, cell.v.low);
    const Vec3 c = point(cell.u.low, cell.v.high);
    const Vec3 d = point(cell.u.high, cell.v.high);
    cell.length_u = std::max((b - a).norm(), (d - c).norm());
    cell.length_v = std::max((c - a).norm(), (d - b).norm());
}

// The integrals of the area element and of the four hat functions, by a rule of Gauss.
void DensityGrid::add_cells(std::size_t surface, std::uint32_t first_node)
{
    const auto& [u, v] = lines_[surface];
    const auto patch_of = [](const Lines& lines, std::size_t line) {
        return static_cast<int>(
                   std::ranges::upper_bound(lines.first, static_cast<int>(line)) -
                   lines.first.begin()) -
               1;
    };
    for (std::size_t row = 0; row + 1 < v.places.size(); ++row)
        for (std::size_t column = 0; column + 1 < u.places.size(); ++column) {
            DensityCell cell{
                surface,
                patch_of(u, column),
                patch_of(v, row),
                {u.places[column], u.places[column + 1]},
                {v.places[row], v.places[row + 1]},
                static_cast<std::uint32_t>(first_node + row * u.places.size() + column),
                0,
                0,
                0};
            measure(cell);
            const auto corner = corners(cell.node);
            for (std::size_t a = 0; a < 3; ++a)
                for (std::size_t b = 0; b < 3; ++b) {
                    const double s = gauss_places[a];
                    const double t = gauss_places[b];
                    const SurfaceTangents tangents = part_.surfaces[surface].tangents(
                        std::lerp(cell.u.low, cell.u.high, s),
                        std::lerp(cell.v.low, cell.v.high, t));
                    const double area = gauss_weights[a] * gauss_weights[b] *
                                        cell.u.length() * cell.v.length() *
                                        tangents.du.cross(tangents.dv).norm();
                    cell.area += area;
                    weights_[corner[0]] += (1 - s) * (1 - t) * area;
                    weights_[corner[1]] += s * (1 - t) * area;
                    weights_[corner[2]] += (1 - s) * t * area;
                    weights_[corner[3]] += s * t * area;
                }
            cells_.push_back(cell);
        }
}

GridPlace DensityGrid::place(std::size_t surface, const SurfacePoint& at) const
{
    struct Line {
        int number;
        float share;
    };
    const auto line = [&](Parameter along, double parameter) -> Line {
        const Lines& lines = lines_[surface][along == Parameter::U ? 0 : 1];
        const std::span<const double> breaks = part_.surfaces[surface].breaks(along);
        const int patch = part_.surfaces[surface].patch_number(along, parameter);
        const int steps = lines.first[patch + 1] - lines.first[patch];
        const double place =
            (parameter - breaks[patch]) / (breaks[patch + 1] - breaks[patch]) * steps;
        const int step = std::clamp(static_cast<int>(place), 0, steps - 1);
        return {lines.first[patch] + step,
                static_cast<float>(std::clamp(place - step, 0.0, 1.0))};
    };
    const Line u = line(Parameter::U, at.u);
    const Line v = line(Parameter::V, at.v);
    const std::uint32_t row = rows_[first_nodes_[surface]];
    return {first_nodes_[surface] + v.number * row + u.number, u.share, v.share};
}

}  // namespace endmill
