// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/continuity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/surface/detail/patch_sides.h"

namespace endmill {
namespace {

constexpr int samples_per_side = 17;
constexpr int search_samples = 32;  // of a side, to find the nearest point
constexpr int refinements = 60;     // of golden section search, down to rounding

// A side with its points at equal steps of the parameter.
struct SampledSide {
    const PatchSide* side = nullptr;
    std::array<Vec3, search_samples + 1> points = {};

    explicit SampledSide(const PatchSide& of) : side{&of}
    {
        for (int k = 0; k <= search_samples; ++k)
            points[k] = of.tangents(k / double(search_samples)).point;
    }
};

// The step along a side from the share `t` of it towards the foot of `point`, by Gauss
// and Newton; 0 where the side stands still.
double newton_step(const PatchSide& side, double t, const Vec3& point)
{
    const SurfaceTangents at = side.tangents(t);
    const Vec3 along =
        at.du * (side.to.u - side.from.u) + at.dv * (side.to.v - side.from.v);
    const double speed2 = along.squaredNorm();
    return speed2 > 0 ? (point - at.point).dot(along) / speed2 : 0;
}

// The least distance from `point` between two shares of a side, by golden section.
double golden_section(const PatchSide& side, Interval bracket, const Vec3& point)
{
    const auto distance = [&](double t) {
        return (side.tangents(t).point - point).squaredNorm();
    };
    constexpr double golden = std::numbers::phi - 1;
    auto [low, high] = bracket;
    for (int k = 0; k < refinements; ++k) {
        const double width = golden * (high - low);
        if (distance(high - width) < distance(low + width))
            high = low + width;
        else
            low = high - width;
    }
    return std::midpoint(low, high);
}

// Parameter of the point of a side that is nearest to `point`: the best sample, refined
// by Newton steps. If they do not converge at once, golden section finds the parameter to
// half the digits, because the distance is flat at its minimum, and a Newton step the
// rest.
double nearest_parameter(const SampledSide& sampled, const Vec3& point)
{
    constexpr int most_steps = 8;
    constexpr double last_step = 1e-9;  // the next one would be about its square
    const PatchSide& side = *sampled.side;
    int nearest = 0;
    double least = (sampled.points[0] - point).squaredNorm();
    for (int k = 1; k <= search_samples; ++k)
        if (const double d = (sampled.points[k] - point).squaredNorm(); d < least) {
            least = d;
            nearest = k;
        }
    const Interval bracket{
        std::max(nearest - 1, 0) / double(search_samples),
        std::min(nearest + 1, search_samples) / double(search_samples)};
    double t = nearest / double(search_samples);
    for (int k = 0; k < most_steps; ++k) {
        const double next =
            std::clamp(t + newton_step(side, t, point), bracket.low, bracket.high);
        const bool is_stuck =
            (next == bracket.low && next > 0) || (next == bracket.high && next < 1);
        if (std::abs(next - t) <= last_step && !is_stuck)
            return next;
        t = next;
    }
    t = golden_section(side, bracket, point);
    return std::clamp(t + newton_step(side, t, point), 0.0, 1.0);
}

// Unit direction into the surface, in its tangent plane and perpendicular to the side;
// zero where the surface has no normal.
Vec3 inward(const PatchSide& side, const SurfaceTangents& at)
{
    if (is_singular(at))
        return Vec3::Zero();
    const bool is_u = side.along == Parameter::U;
    const Vec3 along = (is_u ? at.du : at.dv).normalized();
    const Vec3 across = (side.end == 0 ? 1 : -1) * (is_u ? at.dv : at.du);
    return (across - across.dot(along) * along).normalized();
}

// Angle by which the part turns across the border: 0 if it continues smoothly, 180
// degrees if it folds back onto itself.
double turn(const PatchSide& one, const SurfaceTangents& here, const PatchSide& other,
            const SurfaceTangents& there)
{
    const Vec3 onwards = -inward(one, here);
    const Vec3 beyond = inward(other, there);
    return std::atan2(onwards.cross(beyond).norm(), onwards.dot(beyond));
}

// The worst of the samples along two sides that meet.
BorderBreak break_between(const PatchSide& one, const SampledSide& sampled, double size)
{
    const PatchSide& other = *sampled.side;
    BorderBreak worst{one.from, {}, Angle::radians(-1), 0, Continuity::G1, one.number};
    for (int sample = 0; sample < samples_per_side; ++sample) {
        const double t = sample / double(samples_per_side - 1);
        const SurfaceTangents here = one.tangents(t);
        const SurfaceTangents there =
            other.tangents(nearest_parameter(sampled, here.point));
        worst.gap_mm = std::max(worst.gap_mm, (here.point - there.point).norm());
        const Angle angle = Angle::radians(turn(one, here, other, there));
        if (angle.radians() > worst.normals.radians()) {
            worst.at = one.at(t);
            worst.point = here.point;
            worst.normals = angle;
        }
    }
    worst.continuity = continuity_of(worst.gap_mm, worst.normals, size);
    return worst;
}

using SidePair = std::pair<std::size_t, std::size_t>;

// The break between the sides of each pair. The pairs are examined in the order of their
// second sides, so that the samples of a side serve all its pairs.
std::vector<BorderBreak> breaks_of(std::span<const SidePair> pairs,
                                   std::span<const PatchSide> sides, double size)
{
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t k) {
        return std::pair{pairs[k].second, k};
    });
    std::vector<BorderBreak> breaks(pairs.size());
    parallel_for(order.size(), [&](std::size_t begin, std::size_t end) {
        std::optional<SampledSide> sampled;
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [one, other] = pairs[order[i]];
            if (!sampled || sampled->side != &sides[other])
                sampled.emplace(sides[other]);
            breaks[order[i]] = break_between(sides[one], *sampled, size);
        }
    });
    return breaks;
}

}  // namespace

SurfaceContinuity continuity(std::span<const Surface> surfaces)
{
    require(!surfaces.empty(), "continuity: need a surface");
    SurfaceContinuity whole = continuity(surfaces.front());
    double size = surfaces.front().diagonal();
    for (std::size_t number = 1; number < surfaces.size(); ++number) {
        BorderBreak own = continuity(surfaces[number]).worst;
        own.surface = number;
        if (is_worse(own, whole.worst))
            whole.worst = own;
        size = std::max(size, surfaces[number].diagonal());
    }
    const std::vector<PatchSide> sides = patch_sides(surfaces);
    const std::vector<SidePair> pairs = meeting_sides(sides, same_end_mm(surfaces));
    for (const BorderBreak& border : breaks_of(pairs, sides, size))
        if (is_worse(border, whole.worst))
            whole.worst = border;
    whole.continuity = whole.worst.continuity;
    return whole;
}

}  // namespace endmill
