// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/path_error.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/planning/iso_parametric.h"
#include "planned_path.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double bend = 0.05;

Surface trough()
{
    return test::graph(test::monomial(2, 0, bend / 2), {{-20, 20}, {0, 30}}, {2, 1});
}

// A path of one pass at v with contacts at the given u, made by link_passes.
ToolPath pass_through(const Surface& surface, const std::vector<double>& us, double v)
{
    Pass pass;
    for (const double u : us)
        pass.push_back({u, v, {surface.tangents(u, v).point, Vec3::UnitZ()}});
    return link_passes(std::vector<Pass>{pass}, BallCutter{1}, {});
}

// Greatest distance of the parabola from its chord over [a, b], which is in the middle.
double sagitta(double a, double b)
{
    const double slope = bend * (a + b) / 2;
    return bend * (b - a) * (b - a) / 8 / std::hypot(1, slope);
}

TEST(ChordError, OfAParabolaIsItsSagitta)
{
    const Surface surface = trough();
    const ChordError error = chord_error(
        surface, pass_through(surface, {0, 0.3, 0.9, 1.1, 2}, 0.5), Parameter::U);
    const double expected = sagitta(2, 20);  // the longest chord; next is -14 ... -2
    EXPECT_LT(test::relative_error(error.greatest_mm, expected), 1e-12);
    EXPECT_NEAR(error.at.u, 1.55, 1e-6);
    EXPECT_EQ(error.at.v, 0.5);
}

TEST(ChordError, IsTheSameForAPathCutBackwards)
{
    const Surface surface = trough();
    const ChordError error =
        chord_error(surface, pass_through(surface, {2, 1.1, 0.9, 0}, 0.5), Parameter::U);
    EXPECT_LT(test::relative_error(error.greatest_mm,
                                   std::max(sagitta(2, 20), sagitta(-20, -2))),
              1e-12);
}

TEST(ChordError, AlongVIsThatOfTheTransposedSurface)
{
    const Surface surface = trough();
    const Surface turned = transposed(surface);
    ToolPath path = pass_through(surface, {0, 0.8, 2}, 0.25);
    test::swap_parameters(path);
    const ChordError error = chord_error(turned, path, Parameter::V);
    EXPECT_LT(test::relative_error(error.greatest_mm, sagitta(-4, 20)), 1e-12);
    EXPECT_EQ(error.at.u, 0.25);
    EXPECT_NEAR(error.at.v, 1.4, 1e-6);
}

TEST(ChordError, PitchIsTheLongestDistanceOfTwoSamples)
{
    const Surface line = test::plane(160, 40);
    const ChordError error =
        chord_error(line, pass_through(line, {0, 0.05, 0.6}, 0.5), Parameter::U);
    EXPECT_LE(error.pitch_mm, 0.25);
    EXPECT_NEAR(error.greatest_mm, 0, 1e-13);
}

TEST(ChordError, OfNoCutIsZero)
{
    const Surface surface = trough();
    EXPECT_EQ(chord_error(surface, {}, Parameter::U).greatest_mm, 0);
    EXPECT_EQ(
        chord_error(surface, pass_through(surface, {0.7}, 0), Parameter::U).greatest_mm,
        0);
    const ChordError still =
        chord_error(surface, pass_through(surface, {0.7, 0.7}, 0), Parameter::U);
    EXPECT_EQ(still.greatest_mm, 0);
    EXPECT_EQ(still.pitch_mm, 0);
}

TEST(ChordError, OmitsLinks)
{
    const Surface surface = trough();
    std::vector<Pass> passes;
    for (const double v : {0.0, 1.0})
        passes.push_back({{0, v, {surface.tangents(0, v).point, Vec3::UnitZ()}},
                          {v, v, {surface.tangents(v, v).point, Vec3::UnitZ()}}});
    const ToolPath path = link_passes(passes, BallCutter{1}, {});
    EXPECT_LT(test::relative_error(chord_error(surface, path, Parameter::U).greatest_mm,
                                   sagitta(-20, 0)),
              1e-12);
}

double distance_to_segment(const Vec3& point, const Vec3& start, const Vec3& end)
{
    const Vec3 chord = end - start;
    const double share =
        std::clamp((point - start).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    return (start + share * chord - point).norm();
}

// The chord error by 400 samples of the surface for every cut.
double scanned_error(const Surface& surface, const ToolPath& path)
{
    double greatest = 0;
    for (const auto& pass : test::passes_of(path))
        for (std::size_t k = 1; k < pass.size(); ++k)
            for (int sample = 1; sample < 400; ++sample) {
                const double u = std::lerp(pass[k - 1].contact()->u, pass[k].contact()->u,
                                           sample / 400.0);
                greatest = std::max(
                    greatest,
                    distance_to_segment(surface.tangents(u, pass[k].contact()->v).point,
                                        test::contact_point(pass[k - 1]),
                                        test::contact_point(pass[k])));
            }
    return greatest;
}

TEST(ChordError, OfPlannedPathsIsWhatADenseScanFinds)
{
    test::Random random{1};
    for (int k = 0; k < 6; ++k) {
        test::Polynomial height;
        for (int m = 0; m < 4; ++m)
            for (int n = 0; n < 4; ++n)
                height(m, n) = random.uniform(-3, 3) * std::pow(15.0, -m - n);
        const Surface surface = test::graph(height, {{-20, 15}, {-10, 20}}, {2, 1});
        IsoParametricOptions options;
        options.chord_tolerance = 0.2;
        options.scallop_height = 0.3;
        options.end_point = k % 2 == 0 ? EndPoint::Force : EndPoint::Free;
        const ToolPath path = plan_iso_parametric(surface, BallCutter{0.5}, options).path;
        const double found = chord_error(surface, path, Parameter::U).greatest_mm;
        const double scanned = scanned_error(surface, path);
        EXPECT_GE(found, scanned) << k;
        EXPECT_LE(found, scanned * (1 + 1e-5)) << k;
    }
}

TEST(ChordError, OfACutOverARidgeIsItsHeight)
{
    // A roof of two planes, 15 mm high and 40 mm wide. Its lines have a corner at the
    // ridge.
    const Surface roof = test::valley(20, 30, -0.75);
    const ChordError error =
        chord_error(roof, pass_through(roof, {0, 2}, 0.5), Parameter::U);
    EXPECT_NEAR(error.greatest_mm, 15, 1e-9);
    EXPECT_NEAR(error.at.u, 1, 1e-6);
}

}  // namespace
}  // namespace endmill
