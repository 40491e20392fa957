// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/simple_shape.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/surface/curvature.h"
#include "endmill/surface/extent.h"

namespace endmill {
namespace {

// Distance from the shape as a share of the diagonal. Rational arcs with rounded control
// points are within 1e-15; a surface this close changes no digit of the bound that is
// printed.
constexpr double distance_share = 1e-9;
// Difference of curvatures, as a share of one over the diagonal or of the greater
// curvature, up to which they are tried as equal. The distances decide.
constexpr double equal_curvature = 1e-6;
// Least cosine between a normal and that of the shape.
constexpr double least_cosine = 1 - 1e-9;

struct Sample {
    Vec3 point;
    Vec3 normal;
};

// The places that decide, of all patches; empty if one has no normal.
std::vector<Sample> samples_of(const Surface& surface, double side)
{
    std::vector<Sample> samples;
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i) {
            const BezierPatch& patch = surface.patch(i, j);
            const int steps_u = 2 * patch.degree(Parameter::U);
            const int steps_v = 2 * patch.degree(Parameter::V);
            for (int b = 0; b <= steps_v; ++b)
                for (int a = 0; a <= steps_u; ++a) {
                    const SurfaceTangents tangents =
                        patch.tangents(a / double(steps_u), b / double(steps_v));
                    if (is_singular(tangents))
                        return {};
                    samples.push_back({tangents.point, side * unit_normal(tangents)});
                }
        }
    return samples;
}

// Whether all samples lie on the shape that has this vector from its plane, centre or
// axis to a point, at this signed radius (for a plane 0, with a fixed normal).
bool fits(const std::vector<Sample>& samples, double tolerance,
          const std::function<double(const Sample&)>& distance,
          const std::function<Vec3(const Sample&)>& normal)
{
    return std::ranges::all_of(samples, [&](const Sample& sample) {
        return std::abs(distance(sample)) <= tolerance &&
               sample.normal.dot(normal(sample)) >= least_cosine;
    });
}

// The least N . z over a round surface: N . direction is k (x - centre) . direction, where
// `direction` is the part of z across the axis, or z for a sphere.
double least_normal_z(const Surface& surface, double curvature, const Vec3& centre,
                      const Vec3& direction)
{
    const Interval along = extent(surface, direction);
    const double low = curvature * (along.low - centre.dot(direction));
    const double high = curvature * (along.high - centre.dot(direction));
    return std::min(low, high);
}

Angle slope_of(double normal_z)
{
    return Angle::radians(std::acos(std::clamp(normal_z, -1.0, 1.0)));
}

SimpleShape round_shape(ShapeKind kind, const Surface& surface, double curvature,
                        const Vec3& centre, const Vec3& direction)
{
    return {kind, curvature, area(surface),
            slope_of(least_normal_z(surface, curvature, centre, direction))};
}

// Curvatures and the direction of the smaller one, at a place inside the surface.
struct Bend {
    PrincipalCurvatures k;
    Vec3 straight;  // unit, along the curvature that is closer to 0
    Sample at;
};

Bend bend_at(const Surface& surface, double side)
{
    const auto u = surface.breaks(Parameter::U).first(2);
    const auto v = surface.breaks(Parameter::V).first(2);
    const SurfaceJet jet = surface.jet((u[0] + u[1]) / 2, (v[0] + v[1]) / 2);
    const FundamentalForms forms = fundamental_forms(jet, side);
    const PrincipalCurvatures k = principal_curvatures(forms);
    const double small = std::abs(k.least) < std::abs(k.greatest) ? k.least : k.greatest;
    // The direction a du + b dv with II (a, b) = -small I (a, b), from the longer row.
    const double ee = forms.e + small * forms.E;
    const double ff = forms.f + small * forms.F;
    const double gg = forms.g + small * forms.G;
    const Vec3 from_first = ff * jet.du - ee * jet.dv;
    const Vec3 from_second = gg * jet.du - ff * jet.dv;
    const Vec3 longer =
        from_first.squaredNorm() > from_second.squaredNorm() ? from_first : from_second;
    return {k, longer.normalized(), {jet.point, forms.normal}};
}

}  // namespace

std::optional<SimpleShape> simple_shape(const Surface& surface, double side)
{
    const std::vector<Sample> samples = samples_of(surface, side);
    if (samples.empty())
        return std::nullopt;
    const double tolerance = distance_share * surface.diagonal();
    const Bend bend = bend_at(surface, side);
    const Sample& origin = bend.at;
    const bool is_flat =
        std::max(std::abs(bend.k.least), std::abs(bend.k.greatest)) * surface.diagonal() <
        equal_curvature;
    if (is_flat) {
        const auto height = [&](const Sample& s) {
            return origin.normal.dot(s.point - origin.point);
        };
        if (!fits(samples, tolerance, height,
                  [&](const Sample&) { return origin.normal; }))
            return std::nullopt;
        return SimpleShape{ShapeKind::Plane, 0, area(surface),
                           slope_of(origin.normal.z())};
    }
    const double k = std::abs(bend.k.least) > std::abs(bend.k.greatest) ? bend.k.least
                                                                        : bend.k.greatest;
    const bool is_sphere = bend.k.greatest - bend.k.least < equal_curvature * std::abs(k);
    const Vec3 centre = origin.point - origin.normal / k;
    const auto across = [&](const Vec3& vector) -> Vec3 {
        if (is_sphere)
            return vector;
        return vector - bend.straight.dot(vector) * bend.straight;
    };
    const auto distance = [&](const Sample& s) {
        return across(s.point - centre).norm() - 1 / std::abs(k);
    };
    const auto normal = [&](const Sample& s) -> Vec3 {
        return k * across(s.point - centre);
    };
    if (!fits(samples, tolerance, distance, normal))
        return std::nullopt;
    return round_shape(is_sphere ? ShapeKind::Sphere : ShapeKind::Cylinder, surface, k,
                       centre, across(Vec3::UnitZ()));
}

}  // namespace endmill
