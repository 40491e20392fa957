// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/strategy/detail/covered_part.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/deviation/deviation.h"
#include "endmill/surface/tool_side.h"

namespace endmill {
namespace {

// Spacing of the net of a fine mesh, as a share of the width of a strip. Samples are as
// far apart where few are wanted; where more are wanted the net is refined.
constexpr double net_share = 0.25;

// Share of the scallop height by which the normals at an edge may change what is left.
constexpr double turn_share = 0.002;
// The same on a mesh without edges that would change more, such as one of a smooth surface.
// With its facets apart paths would be some per cent longer.
constexpr double smooth_mesh_share = 0.01;

// A height is raised for trials by this factor, up to a share of the radius.
constexpr double raising_factor = 2;
constexpr double greatest_raised_share = 0.2;

// The share of the height by which an edge across which the normal is continuous changes what
// is left, divided by the turn of the edge. Where the normal of a place turns by t, the place
// is raised h t beside its own normal. What is left between two passes has the slope tan a,
// cos a = 1 - h / R, so that this changes what is left by h t sin a. At an edge, t is half
// the turn of the edge.
double share_per_turn(const BallCutter& cutter, double height)
{
    return strip_width(cutter, height) / (2 * cutter.radius()) / 2;  // sin a / 2
}

MeshNetLimits net_limits(const BallCutter& cutter, double height)
{
    const double share = share_per_turn(cutter, height);
    return {net_share * strip_width(cutter, height),
            std::min(crease_angle, turn_share / share),
            std::min(crease_angle, smooth_mesh_share / share)};
}

}  // namespace

CoveredPart::Source CoveredPart::source_of(const Part& part, const BallCutter& cutter,
                                           const CoverLimits& limits)
{
    if (const auto* mesh = std::get_if<TriangleMesh>(&part)) {
        MeshNet net = mesh_net(*mesh, net_limits(cutter, limits.scallop_height));
        const MeshEdges edges = net.has_creases ? MeshEdges::Sharp : MeshEdges::Smooth;
        return CoveredMesh{std::move(net), std::make_shared<const BallOnMesh>(
                                               *mesh, cutter, limits.tolerance, edges)};
    }
    const auto& surfaces = std::get<std::vector<Surface>>(part);
    std::vector<double> sides = tool_side_signs(surfaces, Vec3::UnitZ());
    require_reachable(surfaces, Vec3::UnitZ(), sides);
    const ClearMoves clear{surfaces, sides, cutter, Vec3::UnitZ(), limits.tolerance};
    return CoveredSurfaces{&surfaces, std::move(sides), clear};
}

CoveredPart::CoveredPart(const Part& part, const BallCutter& cutter,
                         const CoverLimits& limits,
                         std::shared_ptr<const ProtectedPart> guard)
    : cutter_{cutter},
      tolerance_{limits.tolerance},
      accessible_distance_{reached_share * limits.scallop_height},
      guard_{std::move(guard)},
      source_{source_of(part, cutter, limits)}
{
}

PartSamples CoveredPart::samples(double spacing, std::size_t most_samples) const
{
    return samples(PartSampling{spacing, accessible_distance_, guard_}, most_samples);
}

PartSamples CoveredPart::samples(const PartSampling& sampling,
                                 std::size_t most_samples) const
{
    if (const auto* mesh = std::get_if<CoveredMesh>(&source_))
        return {mesh->net, mesh->ball, sampling, most_samples};
    const auto& [surfaces, sides, clear] = std::get<CoveredSurfaces>(source_);
    return {*surfaces, sides, sampling, most_samples};
}

double CoveredPart::aimed_height(double height) const
{
    const auto* mesh = std::get_if<CoveredMesh>(&source_);
    return mesh ? height * (1 - mesh->net.smoothed_turn * share_per_turn(cutter_, height))
                : height;
}

bool CoveredPart::is_clear(const Vec3& from, const Vec3& to, MoveTestState& state) const
{
    if (guard_ && !guard_->is_clear(from, to))
        return false;
    if (const auto* mesh = std::get_if<CoveredMesh>(&source_))
        return mesh->ball->is_clear(from, to);
    return std::get<CoveredSurfaces>(source_).clear.is_clear({from, to}, state.finer);
}

std::span<const Surface> CoveredPart::surfaces() const
{
    if (const auto* own = std::get_if<CoveredSurfaces>(&source_))
        return *own->surfaces;
    return {};
}

double CoveredPart::rough_area(std::size_t most_samples) const
{
    constexpr double no_spacing = 1e9;  // mm, a distance of samples that no part exceeds
    // A protected part may bar all samples of so coarse a net, such as the corners of a pocket
    // floor, and yet leave most of the part free.
    const PartSamples first =
        samples(PartSampling{no_spacing, accessible_distance_}, most_samples);
    double area = 0;
    for (const auto& [a, b, c] : first.triangles())
        area += (first.point(b) - first.point(a))
                    .cross(first.point(c) - first.point(a))
                    .norm() /
                2;
    return area;
}

void require_possible(const CoveredPart& part, double spacing, std::size_t most_samples)
{
    // An equilateral triangle has the greatest area for its longest side, and there are about
    // two triangles for each sample.
    const double area_of_sample = std::sqrt(3) / 2 * spacing * spacing;
    const double needed = part.rough_area(most_samples) / area_of_sample;
    if (needed > static_cast<double>(most_samples))
        throw_too_many_samples(needed, most_samples);
}

FewSamples few_samples(const CoveredPart& part, const FewSamplesLimits& limits,
                       double height, std::size_t most_samples)
{
    const BallCutter& cutter = part.cutter();
    for (; raising_factor * height < greatest_raised_share * cutter.radius();
         height *= raising_factor)
        try {
            return {part.samples(strip_width(cutter, height) / limits.across,
                                 std::min(limits.most_samples, most_samples)),
                    height};
        } catch (const LimitError&) {
            continue;
        }
    return {part.samples(strip_width(cutter, height) / limits.across, most_samples),
            height};
}

}  // namespace endmill
