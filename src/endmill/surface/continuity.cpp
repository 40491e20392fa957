// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/continuity.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

constexpr int samples_per_border = 17;
// Largest gap of a G0 border, as a share of the surface's diagonal. Common control points
// agree up to rounding.
constexpr double g0_gap = 1e-9;

// The angle between the normals in rad; 0 where one of them does not exist.
double normal_angle(const SurfaceTangents& one, const SurfaceTangents& other)
{
    const Vec3 n = one.du.cross(one.dv);
    const Vec3 m = other.du.cross(other.dv);
    if (is_singular(one, n) || is_singular(other, m))
        return 0;
    const Vec3 unit_n = n.normalized();
    const Vec3 unit_m = m.normalized();
    return std::atan2(unit_n.cross(unit_m).norm(), unit_n.dot(unit_m));
}

// Two neighbouring patches, the second one above the first in the parameter `across`.
struct PatchPair {
    int i, j;  // column and row of the first
    int k, l;  // column and row of the second
    Parameter across;
    SurfacePoint from, to;  // ends of their border
};

// The worst of the samples along the border of two patches.
BorderBreak worst_break(const Surface& surface, const PatchPair& pair)
{
    const BezierPatch& first = surface.patch(pair.i, pair.j);
    const BezierPatch& second = surface.patch(pair.k, pair.l);
    BorderBreak worst{pair.from, {}, Angle::radians(-1), 0, Continuity::G1};
    for (int sample = 0; sample < samples_per_border; ++sample) {
        const double t = sample / double(samples_per_border - 1);
        const double u = std::lerp(pair.from.u, pair.to.u, t);
        const double v = std::lerp(pair.from.v, pair.to.v, t);
        const bool is_across_u = pair.across == Parameter::U;
        const SurfaceTangents one =
            first.tangents(is_across_u ? 1 : t, is_across_u ? t : 1);
        const SurfaceTangents other =
            second.tangents(is_across_u ? 0 : t, is_across_u ? t : 0);
        worst.gap_mm = std::max(worst.gap_mm, (one.point - other.point).norm());
        const Angle angle = Angle::radians(normal_angle(one, other));
        if (angle.radians() > worst.normals.radians()) {
            worst.at = {u, v};
            worst.point = one.point;
            worst.normals = angle;
        }
    }
    worst.continuity = continuity_of(worst.gap_mm, worst.normals, surface.diagonal());
    return worst;
}

}  // namespace

Continuity continuity_of(double gap_mm, Angle normals, double size)
{
    if (gap_mm > g0_gap * size)
        return Continuity::None;
    return normals.radians() > smooth_angle ? Continuity::G0 : Continuity::G1;
}

bool is_worse(const BorderBreak& one, const BorderBreak& other)
{
    if (one.continuity != other.continuity)
        return one.continuity < other.continuity;
    if (one.continuity == Continuity::None && one.gap_mm != other.gap_mm)
        return one.gap_mm > other.gap_mm;
    return one.normals.radians() > other.normals.radians();
}

std::string_view continuity_name(Continuity continuity)
{
    switch (continuity) {
        case Continuity::None:
            return "none";
        case Continuity::G0:
            return "G0";
        case Continuity::G1:
            return "G1";
    }
    return {};
}

std::vector<BorderBreak> border_breaks(const Surface& surface)
{
    const auto u = surface.breaks(Parameter::U);
    const auto v = surface.breaks(Parameter::V);
    const int columns = surface.patches(Parameter::U);
    const int rows = surface.patches(Parameter::V);
    std::vector<PatchPair> pairs;
    for (int i = 1; i < columns; ++i)
        for (int j = 0; j < rows; ++j)
            pairs.push_back(
                {i - 1, j, i, j, Parameter::U, {u[i], v[j]}, {u[i], v[j + 1]}});
    for (int j = 1; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            pairs.push_back(
                {i, j - 1, i, j, Parameter::V, {u[i], v[j]}, {u[i + 1], v[j]}});
    std::vector<BorderBreak> breaks(pairs.size());
    parallel_for(pairs.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            breaks[k] = worst_break(surface, pairs[k]);
    });
    return breaks;
}

SurfaceContinuity continuity(const Surface& surface)
{
    const SurfacePoint corner{surface.range(Parameter::U).low,
                              surface.range(Parameter::V).low};
    SurfaceContinuity whole{Continuity::G1,
                            {corner, surface.tangents(corner.u, corner.v).point,
                             Angle::radians(0), 0, Continuity::G1}};
    for (const BorderBreak& border : border_breaks(surface)) {
        if (is_worse(border, whole.worst))
            whole.worst = border;
        whole.continuity = whole.worst.continuity;
    }
    return whole;
}

}  // namespace endmill
