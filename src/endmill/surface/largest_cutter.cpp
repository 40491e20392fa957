// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/largest_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "endmill/core/parallel.h"
#include "endmill/surface/box_search.h"
#include "endmill/surface/curvature.h"
#include "endmill/surface/point_tree.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int samples_per_side = 33;  // of a patch, for curvature
constexpr int candidates_to_refine = 5;
constexpr double most_pair_samples = 260'000;
// Nearer pairs, in widths of a patch, are left to curvature: they would only find it
// again with rounding, or a crease, which admits no ball at all and is told by
// `continuity`.
constexpr double least_pair_distance = 0.125;
// A ball this many diagonals large is a plane to the surface.
constexpr double flat_diagonals = 1e6;

struct Candidate {
    double value;  // smaller is better
    int i, j;      // the patch
    SurfacePoint at;
};

// Keeps the best few candidates, in order.
class BestCandidates {
public:
    void offer(const Candidate& candidate)
    {
        const auto place =
            std::ranges::upper_bound(best_, candidate.value, {}, &Candidate::value);
        best_.insert(place, candidate);
        if (best_.size() > candidates_to_refine)
            best_.pop_back();
    }

    const std::vector<Candidate>& all() const { return best_; }

private:
    std::vector<Candidate> best_;
};

// A principal curvature to minimise; infinite where there is no normal.
using PrincipalValue = double (*)(const PrincipalCurvatures&);

double principal_value(const SurfaceJet& jet, double side, PrincipalValue value)
{
    if (is_singular({jet.point, jet.du, jet.dv}))
        return infinity;
    return value(principal_curvatures(fundamental_forms(jet, side)));
}

struct PatchBox {
    Interval u;
    Interval v;
};

PatchBox patch_box(const Surface& surface, int i, int j)
{
    const auto u = surface.breaks(Parameter::U);
    const auto v = surface.breaks(Parameter::V);
    return {{u[i], u[i + 1]}, {v[j], v[j + 1]}};
}

BestCandidates best_samples(const Surface& surface, double side, PrincipalValue value)
{
    const int columns = surface.patches(Parameter::U);
    const int rows = surface.patches(Parameter::V);
    std::vector<BestCandidates> by_patch(static_cast<std::size_t>(columns) * rows);
    parallel_for(by_patch.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t number = begin; number < end; ++number) {
            const int i = static_cast<int>(number) % columns;
            const int j = static_cast<int>(number) / columns;
            const auto [u_range, v_range] = patch_box(surface, i, j);
            for (int row = 0; row < samples_per_side; ++row)
                for (int column = 0; column < samples_per_side; ++column) {
                    const double u = std::lerp(u_range.low, u_range.high,
                                               column / (samples_per_side - 1.0));
                    const double v = std::lerp(v_range.low, v_range.high,
                                               row / (samples_per_side - 1.0));
                    const double found =
                        principal_value(surface.jet_in_patch(i, j, u, v), side, value);
                    by_patch[number].offer({found, i, j, {u, v}});
                }
        }
    });
    BestCandidates best;
    for (const BestCandidates& patch : by_patch)
        for (const Candidate& candidate : patch.all())
            best.offer(candidate);
    return best;
}

Candidate least_principal_value(const Surface& surface, double side, PrincipalValue value)
{
    const BestCandidates samples = best_samples(surface, side, value);
    Candidate least = samples.all().front();
    for (const Candidate& start : samples.all()) {
        const auto [u, v] = patch_box(surface, start.i, start.j);
        const auto at_place = [&](const Eigen::VectorXd& x) {
            return principal_value(surface.jet_in_patch(start.i, start.j, x[0], x[1]),
                                   side, value);
        };
        const BoxMinimum found = minimize_in_box(
            at_place, {Eigen::Vector2d{u.low, v.low}, Eigen::Vector2d{u.high, v.high}},
            Eigen::Vector2d{start.at.u, start.at.v},
            std::min(u.length(), v.length()) / (samples_per_side - 1));
        if (found.value < least.value)
            least = {found.value, start.i, start.j, {found.at[0], found.at[1]}};
    }
    return least;
}

struct SurfaceSample {
    SurfacePoint at;
    Vec3 point;
    Vec3 normal;  // on the tool's side
};

// Samples of all patches, borders once; places without a normal are passed over.
std::vector<SurfaceSample> surface_samples(const Surface& surface, double side)
{
    const double patches =
        double(surface.patches(Parameter::U)) * surface.patches(Parameter::V);
    const int per_side =
        std::clamp(static_cast<int>(std::sqrt(most_pair_samples / patches)), 4, 48);
    const auto parameters = [&](Parameter along) {
        const auto breaks = surface.breaks(along);
        std::vector<double> values{breaks.front()};
        for (std::size_t k = 1; k < breaks.size(); ++k)
            for (int step = 1; step <= per_side; ++step)
                values.push_back(
                    std::lerp(breaks[k - 1], breaks[k], step / double(per_side)));
        return values;
    };
    std::vector<SurfaceSample> samples;
    const std::vector<double> along_u = parameters(Parameter::U);
    for (const double v : parameters(Parameter::V))
        for (const double u : along_u) {
            const SurfaceTangents tangents = surface.tangents(u, v);
            if (!is_singular(tangents))
                samples.push_back({{u, v}, tangents.point, side * unit_normal(tangents)});
        }
    return samples;
}

// Radius of the ball that touches at `p` and passes through `q`; infinite if `q` lies
// behind the tangent plane, or too near for its radius to mean anything but curvature.
double pair_radius(const Surface& surface, const SurfaceSample& p, const SurfaceSample& q)
{
    const auto widths_apart = [&](Parameter along, double a, double b) {
        return std::abs(a - b) * surface.patches(along) / surface.range(along).length();
    };
    if (std::max(widths_apart(Parameter::U, p.at.u, q.at.u),
                 widths_apart(Parameter::V, p.at.v, q.at.v)) < least_pair_distance)
        return infinity;
    const Vec3 chord = q.point - p.point;
    const double height = p.normal.dot(chord);
    return height > 0 ? chord.squaredNorm() / (2 * height) : infinity;
}

struct Pair {
    SurfacePoint p;
    SurfacePoint q;
};

// Pairs at which the radius fell below all before it, from `limit` on; the last few.
std::vector<Pair> tightest_sampled_pairs(const Surface& surface, double side,
                                         double limit)
{
    const std::vector<SurfaceSample> samples = surface_samples(surface, side);
    std::vector<Vec3> points;
    points.reserve(samples.size());
    for (const SurfaceSample& sample : samples)
        points.push_back(sample.point);
    if (points.empty())
        return {};
    const PointTree tree{points};
    std::vector<Pair> pairs;
    for (const SurfaceSample& p : samples)
        for (;;) {
            const Vec3 centre = p.point + limit * p.normal;
            const SurfaceSample& q = samples[tree.nearest(centre)];
            const double radius = pair_radius(surface, p, q);
            if (!(radius < limit))
                break;
            limit = radius;
            pairs.push_back({p.at, q.at});
        }
    if (pairs.size() > candidates_to_refine)
        pairs.erase(pairs.begin(), pairs.end() - candidates_to_refine);
    return pairs;
}

BoxMinimum refined_pair(const Surface& surface, double side, const Pair& start)
{
    const auto sample = [&](double u, double v) -> SurfaceSample {
        const SurfaceTangents tangents = surface.tangents(u, v);
        const Vec3 normal =
            is_singular(tangents) ? Vec3::Zero() : Vec3{side * unit_normal(tangents)};
        return {{u, v}, tangents.point, normal};
    };
    const auto radius = [&](const Eigen::VectorXd& x) {
        return pair_radius(surface, sample(x[0], x[1]), sample(x[2], x[3]));
    };
    const auto [u_low, u_high] = surface.range(Parameter::U);
    const auto [v_low, v_high] = surface.range(Parameter::V);
    const double step = std::min((u_high - u_low) / surface.patches(Parameter::U),
                                 (v_high - v_low) / surface.patches(Parameter::V)) /
                        32;
    return minimize_in_box(radius,
                           {Eigen::Vector4d{u_low, v_low, u_low, v_low},
                            Eigen::Vector4d{u_high, v_high, u_high, v_high}},
                           Eigen::Vector4d{start.p.u, start.p.v, start.q.u, start.q.v},
                           step);
}

}  // namespace

std::optional<CurvatureRange> curvature_range(const Surface& surface, double side)
{
    const auto least = [](const PrincipalCurvatures& k) { return k.least; };
    const auto minus_greatest = [](const PrincipalCurvatures& k) { return -k.greatest; };
    const CurvatureRange range{
        least_principal_value(surface, side, least).value,
        -least_principal_value(surface, side, minus_greatest).value};
    if (!std::isfinite(range.least) || !std::isfinite(range.greatest))
        return std::nullopt;
    return range;
}

std::optional<CutterLimit> largest_cutter_by_curvature(const Surface& surface,
                                                       double side)
{
    const Candidate tightest = least_principal_value(
        surface, side, [](const PrincipalCurvatures& k) { return k.least; });
    const double concavity = -tightest.value;
    if (!(concavity * flat_diagonals * surface.diagonal() > 1))
        return std::nullopt;
    const auto [u, v] = tightest.at;
    return CutterLimit{
        1 / concavity, {u, v}, surface.jet_in_patch(tightest.i, tightest.j, u, v).point};
}

std::optional<CutterLimit> largest_cutter(const Surface& surface, double side)
{
    std::optional<CutterLimit> limit = largest_cutter_by_curvature(surface, side);
    double radius = limit ? limit->radius_mm : flat_diagonals * surface.diagonal();
    for (const Pair& pair : tightest_sampled_pairs(surface, side, radius)) {
        const BoxMinimum tightest = refined_pair(surface, side, pair);
        if (!(tightest.value < radius))
            continue;
        radius = tightest.value;
        const SurfacePoint at{tightest.at[0], tightest.at[1]};
        limit = CutterLimit{radius, at, surface.tangents(at.u, at.v).point};
    }
    return limit;
}

}  // namespace endmill
