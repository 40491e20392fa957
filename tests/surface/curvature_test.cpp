// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/curvature.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

FundamentalForms forms_at(const Surface& surface, double u, double v)
{
    return fundamental_forms(surface.jet(u, v), 1);
}

// Curvature of the section of z = f(x, y) by the plane through the normal and
// `direction`, from three of its points: for points near p on that plane, 1/R = 2 |N.(q -
// p)| / |q - p|^2.
double curvature_by_chords(const Surface& surface, double u, double v,
                           const TangentVector& along)
{
    constexpr double h = 1e-4;
    const SurfaceJet jet = surface.jet(u, v);
    const Vec3 normal = unit_normal({jet.point, jet.du, jet.dv});
    double sum = 0;
    for (const double step : {h, -h}) {
        const Vec3 chord =
            surface.jet(u + along.a * step, v + along.b * step).point - jet.point;
        sum += -2 * normal.dot(chord) / chord.squaredNorm();
    }
    return sum / 2;
}

TEST(Curvature, OfAPlaneVanishes)
{
    const auto [least, greatest] = principal_curvatures(
        forms_at(test::parallelogram({3, 1, 2}, {-1, 4, 1}), 0.3, 0.6));
    EXPECT_NEAR(least, 0, 1e-16);
    EXPECT_NEAR(greatest, 0, 1e-16);
}

TEST(Curvature, OfTheSaddleAtItsMiddleIsOneOverCBothWays)
{
    const FundamentalForms forms = forms_at(test::saddle(32, 40), 0.5, 0.5);
    const auto [least, greatest] = principal_curvatures(forms);
    EXPECT_NEAR(least, -1.0 / 32, 1e-16);
    EXPECT_NEAR(greatest, 1.0 / 32, 1e-16);
    EXPECT_NEAR(normal_curvature(forms, {1.0 / 80, 0}), -1.0 / 32, 1e-16)
        << "concave along x, where the saddle rises";
    EXPECT_NEAR(normal_curvature(forms, {0, 1.0 / 80}), 1.0 / 32, 1e-16);
}

// For z = r^2 / (2 c): 1/c (1 + r^2/c^2)^(-3/2) along the meridian, and with exponent
// -1/2 across it.
TEST(Curvature, OfAParaboloidIsThatOfItsParabola)
{
    constexpr double c = 25;
    const Surface bowl =
        test::graph(test::monomial(2, 0, 0.5 / c) + test::monomial(0, 2, 0.5 / c),
                    {{-30, 30}, {-20, 40}});
    for (double u = 0; u <= 1; u += 0.125)
        for (double v = 0; v <= 1; v += 0.125) {
            const SurfaceJet jet = bowl.jet(u, v);
            const double steep = 1 + jet.point.head<2>().squaredNorm() / (c * c);
            const auto [least, greatest] =
                principal_curvatures(fundamental_forms(jet, 1));
            EXPECT_NEAR(least, -1 / (c * std::sqrt(steep)), 1e-16);
            EXPECT_NEAR(greatest, -1 / (c * std::pow(steep, 1.5)), 1e-16);
        }
}

TEST(Curvature, OfAParabolicCylinderIsThatOfItsParabolaAndZero)
{
    const Surface trough = test::parabolic_cylinder(0.02, 40, 30);
    for (double u = 0; u <= 1; u += 0.0625) {
        const SurfaceJet jet = trough.jet(u, 0.4);
        const double steep = 1 + std::pow(0.02 * jet.point.x(), 2);
        const auto [least, greatest] = principal_curvatures(fundamental_forms(jet, 1));
        EXPECT_NEAR(least, -0.02 / std::pow(steep, 1.5), 1e-16);
        EXPECT_NEAR(greatest, 0, 1e-16);
    }
}

TEST(Curvature, ChangesItsSignWithTheSide)
{
    const SurfaceJet jet = test::random_surface(1).jet(0.3, 0.4);
    const auto [least, greatest] = principal_curvatures(fundamental_forms(jet, 1));
    const auto [other_least, other_greatest] =
        principal_curvatures(fundamental_forms(jet, -1));
    EXPECT_EQ(other_least, -greatest);
    EXPECT_EQ(other_greatest, -least);
    EXPECT_EQ(fundamental_forms(jet, -1).normal, -fundamental_forms(jet, 1).normal);
}

TEST(Curvature, AlongATangentIsThatOfShortChords)
{
    const Surface surface = test::random_surface(2);
    test::Random random{2};
    for (int k = 0; k < 100; ++k) {
        const double u = random.uniform(0.1, 0.9);
        const double v = random.uniform(0.1, 0.9);
        const SurfaceJet jet = surface.jet(u, v);
        const FundamentalForms forms = fundamental_forms(jet, 1);
        const double angle = random.uniform(0, std::numbers::pi);
        const Vec3 direction =
            (std::cos(angle) * jet.du.normalized() +
             std::sin(angle) * forms.normal.cross(jet.du).normalized());
        const TangentVector tangent = tangent_components(forms, jet, direction);
        EXPECT_LT((tangent.a * jet.du + tangent.b * jet.dv - direction).norm(), 1e-13);
        EXPECT_NEAR(normal_curvature(forms, tangent),
                    curvature_by_chords(surface, u, v, tangent), 1e-5);
    }
}

TEST(Curvature, ComponentsOfADirectionOffTheTangentPlaneAreThoseOfItsFoot)
{
    const SurfaceJet jet = test::random_surface(3).jet(0.6, 0.2);
    const FundamentalForms forms = fundamental_forms(jet, 1);
    const Vec3 direction = jet.du - 0.5 * jet.dv + 7 * forms.normal;
    const auto [a, b] = tangent_components(forms, jet, direction);
    EXPECT_NEAR(a, 1, 1e-13);
    EXPECT_NEAR(b, -0.5, 1e-13);
}

TEST(PrincipalCurvatures, AreTheExtremesOverAllDirections)
{
    const Surface surface = test::random_surface(4);
    const SurfaceJet jet = surface.jet(0.35, 0.55);
    const FundamentalForms forms = fundamental_forms(jet, 1);
    const auto [least, greatest] = principal_curvatures(forms);
    double lowest = 1e300;
    double highest = -1e300;
    constexpr int turns = 20000;
    for (int k = 0; k < turns; ++k) {
        const double angle = k * std::numbers::pi / turns;
        const Vec3 direction = std::cos(angle) * jet.du.normalized() +
                               std::sin(angle) * forms.normal.cross(jet.du).normalized();
        const double found =
            normal_curvature(forms, tangent_components(forms, jet, direction));
        lowest = std::min(lowest, found);
        highest = std::max(highest, found);
    }
    const double size = std::max(std::abs(least), std::abs(greatest));
    EXPECT_NEAR(lowest, least, 1e-7 * size);
    EXPECT_NEAR(highest, greatest, 1e-7 * size);
    EXPECT_GE(lowest, least - 1e-15 * size);
    EXPECT_LE(highest, greatest + 1e-15 * size);
}

// The jet of the same surface with the parameters u + shear v and v.
SurfaceJet sheared(const SurfaceJet& jet, double shear)
{
    return {jet.point,
            jet.du,
            jet.dv + shear * jet.du,
            jet.duu,
            jet.duv + shear * jet.duu,
            jet.dvv + 2 * shear * jet.duv + shear * shear * jet.duu};
}

TEST(PrincipalCurvatures, DoNotDependOnTheParameters)
{
    const Surface surface = test::random_surface(5);
    for (double u = 0; u <= 1; u += 0.25)
        for (double v = 0; v <= 1; v += 0.25) {
            const SurfaceJet jet = surface.jet(u, v);
            const auto [least, greatest] =
                principal_curvatures(fundamental_forms(jet, 1));
            const double size = std::max(std::abs(least), std::abs(greatest));
            for (const double shear : {-2.0, -0.5, 0.3, 1.0}) {
                const auto other =
                    principal_curvatures(fundamental_forms(sheared(jet, shear), 1));
                EXPECT_NEAR(other.least, least, 1e-13 * size);
                EXPECT_NEAR(other.greatest, greatest, 1e-13 * size);
            }
        }
}

struct LongPrincipal {
    long double least;
    long double greatest;
};

// Roots of (EG - F^2) x^2 - (eG - 2fF + gE) x + eg - f^2 in long double.
LongPrincipal companion(const FundamentalForms& forms)
{
    const long double E = forms.E, F = forms.F, G = forms.G;
    const long double e = forms.e, f = forms.f, g = forms.g;
    const long double W = E * G - F * F;
    const long double H = (e * G - 2 * f * F + g * E) / (2 * W);
    const long double K = (e * g - f * f) / W;
    const long double root = std::sqrt(std::max(0.0L, H * H - K));
    return {-(H + root), -(H - root)};
}

TEST(PrincipalCurvatures, HaveAnErrorOfAFewRoundingsOfTheLargerOne)
{
    test::Random random{6};
    double worst = 0;
    for (int k = 0; k < 5000; ++k) {
        const double du = random.log_uniform(1e-2, 1e2);
        const double dv = random.log_uniform(1e-2, 1e2);
        const double cosine = random.uniform(-0.7, 0.7);
        const FundamentalForms forms{du * du,
                                     cosine * du * dv,
                                     dv * dv,
                                     random.uniform(-1, 1) * du * du,
                                     random.uniform(-1, 1) * du * dv,
                                     random.uniform(-1, 1) * dv * dv,
                                     Vec3::UnitZ()};
        const auto [least, greatest] = principal_curvatures(forms);
        const LongPrincipal expected = companion(forms);
        const long double size =
            std::max(std::abs(expected.least), std::abs(expected.greatest));
        worst = std::max({worst, double(std::abs(least - expected.least) / size),
                          double(std::abs(greatest - expected.greatest) / size)});
    }
    EXPECT_LT(worst, 2e-15);
}

TEST(PrincipalCurvatures, AreEqualAtAnUmbilic)
{
    const FundamentalForms sphere{4,        0.6,          9, -4 * 0.1, -0.6 * 0.1,
                                  -9 * 0.1, Vec3::UnitZ()};
    const auto [least, greatest] = principal_curvatures(sphere);
    EXPECT_NEAR(least, 0.1, 1e-16);
    EXPECT_NEAR(greatest, 0.1, 1e-16);
}

TEST(Curvature, IsRefusedWhereThereIsNoNormal)
{
    const SurfaceJet pole{Vec3::Zero(), Vec3::Zero(),  Vec3::UnitY(),
                          Vec3::Zero(), Vec3::UnitX(), Vec3::Zero()};
    EXPECT_THROW(fundamental_forms(pole, 1), GeometryError);
}

TEST(CurveCurvature, OfACircleIsOneOverItsRadiusAtAnySpeed)
{
    for (const double radius : {1e-3, 1.0, 1e6})
        for (const double speed : {0.1, 1.0, 30.0}) {
            const Vec3 first{0, radius * speed, 0};
            const Vec3 second{-radius * speed * speed, 5 * radius, 0};
            EXPECT_NEAR(curve_curvature(first, second) * radius, 1, 1e-15);
        }
}

TEST(CurveCurvature, OfAStraightLineIsZeroAtAnyPace)
{
    EXPECT_EQ(curve_curvature({1, 2, 3}, {0, 0, 0}), 0);
    EXPECT_EQ(curve_curvature({1, 2, 3}, {-2, -4, -6}), 0);
}

TEST(Curvature, FormsWithAGivenNormalAreThoseOfTheSurfacesOwn)
{
    const SurfaceJet jet = test::random_surface(7).jet(0.2, 0.9);
    for (const double side : {1.0, -1.0}) {
        const FundamentalForms own = fundamental_forms(jet, side);
        const FundamentalForms given = fundamental_forms(jet, own.normal);
        EXPECT_EQ(given.e, own.e);
        EXPECT_EQ(given.f, own.f);
        EXPECT_EQ(given.G, own.G);
        EXPECT_EQ(given.normal, own.normal);
    }
}

}  // namespace
}  // namespace endmill
