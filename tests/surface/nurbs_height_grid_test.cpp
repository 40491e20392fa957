// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/nurbs.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/surface/continuity.h"
#include "random.h"

namespace endmill {
namespace {

template <class Height>
std::vector<double> heights(const std::vector<double>& x, const std::vector<double>& y,
                            const Height& height)
{
    std::vector<double> z;
    for (const double at_y : y)
        for (const double at_x : x)
            z.push_back(height(at_x, at_y));
    return z;
}

double bicubic(double x, double y)
{
    return (1 - 2 * x + 0.3 * x * x - 0.05 * x * x * x) *
           (2 + y - 0.1 * y * y + 0.02 * y * y * y);
}

TEST(HeightGrid, ReproducesABicubicPolynomial)
{
    const std::vector<double> x{-2, -1, 0.5, 1, 3, 3.5, 5};
    const std::vector<double> y{0, 1, 1.5, 4};
    const Surface surface = height_grid(x, y, heights(x, y, bicubic));
    EXPECT_EQ(surface.patches(Parameter::U), 4) << "two of six knots are none";
    EXPECT_EQ(surface.patches(Parameter::V), 1);
    for (double u = -2; u <= 5; u += 0.25)
        for (double v = 0; v <= 4; v += 0.25) {
            const SurfaceJet jet = surface.jet(u, v);
            EXPECT_NEAR(jet.point.x(), u, 1e-13);
            EXPECT_NEAR(jet.point.y(), v, 1e-13);
            EXPECT_NEAR(jet.point.z(), bicubic(u, v), 1e-12);
            EXPECT_NEAR(jet.du.x(), 1, 1e-13);
            EXPECT_NEAR(jet.dv.y(), 1, 1e-13);
        }
}

TEST(HeightGrid, OfFewLinesHasALowerDegree)
{
    const std::vector<double> two{0, 3};
    const std::vector<double> three{-1, 0, 2};
    const auto height = [](double x, double y) { return (1 + x) * (1 - y + 2 * y * y); };
    const Surface surface = height_grid(two, three, heights(two, three, height));
    for (double u = 0; u <= 3; u += 0.5)
        for (double v = -1; v <= 2; v += 0.25)
            EXPECT_NEAR(surface.tangents(u, v).point.z(), height(u, v), 1e-13);
}

TEST(HeightGrid, InterpolatesItsHeightsAndIsC2)
{
    test::Random random{1};
    std::vector<double> x{0};
    std::vector<double> y{0};
    for (int k = 0; k < 12; ++k)
        x.push_back(x.back() + random.uniform(0.3, 2));
    for (int k = 0; k < 8; ++k)
        y.push_back(y.back() + random.uniform(0.3, 2));
    const auto z = heights(x, y, [&](double, double) { return random.uniform(-1, 1); });
    const Surface surface = height_grid(x, y, z);
    for (std::size_t j = 0; j < y.size(); ++j)
        for (std::size_t i = 0; i < x.size(); ++i)
            EXPECT_NEAR(surface.tangents(x[i], y[j]).point.z(), z[j * x.size() + i],
                        1e-13);
    const auto breaks = surface.breaks(Parameter::U);
    for (std::size_t k = 1; k + 1 < breaks.size(); ++k) {
        const int number = static_cast<int>(k);
        const SurfaceJet below = surface.jet_in_patch(number - 1, 1, breaks[k], y[3]);
        const SurfaceJet above = surface.jet_in_patch(number, 1, breaks[k], y[3]);
        EXPECT_LT((below.du - above.du).norm(), 1e-11);
        EXPECT_LT((below.duu - above.duu).norm(), 1e-10);
        EXPECT_LT((below.duv - above.duv).norm(), 1e-10);
    }
    EXPECT_EQ(continuity(surface).continuity, Continuity::G1);
}

// The error of a cubic spline falls with the fourth power of the spacing.
TEST(HeightGrid, ConvergesWithTheFourthPower)
{
    const auto wave = [](double x, double y) { return std::sin(x) * std::cos(0.7 * y); };
    double before = 1;
    for (const int lines : {11, 21, 41}) {
        std::vector<double> grid(lines);
        for (int k = 0; k < lines; ++k)
            grid[k] = 4.0 * k / (lines - 1);
        const Surface surface = height_grid(grid, grid, heights(grid, grid, wave));
        double worst = 0;
        for (double u = 0.01; u < 4; u += 0.037)
            for (double v = 0.01; v < 4; v += 0.041)
                worst = std::max(worst,
                                 std::abs(surface.tangents(u, v).point.z() - wave(u, v)));
        EXPECT_GT(before / worst, 12);
        before = worst;
    }
    EXPECT_LT(before, 1e-5);
}

TEST(HeightGrid, RefusesAnInvalidGrid)
{
    const std::vector<double> line{0, 1, 2};
    const std::vector<double> z(9, 0.0);
    EXPECT_NO_THROW(height_grid(line, line, z));
    EXPECT_THROW(height_grid(line, {}, z), DomainError);
    EXPECT_THROW(height_grid(line, line, std::vector<double>(8, 0.0)), DomainError);
    EXPECT_THROW(height_grid(std::vector<double>{0, 1, 1}, line, z), DomainError);
    const std::vector<double> close{0, 1e-12, 1, 2, 3};
    EXPECT_THROW(height_grid(close, line, std::vector<double>(15, 0.0)), DomainError);
    const std::vector<double> endless{0, 1, INFINITY};
    EXPECT_THROW(height_grid(line, endless, z), DomainError);
    std::vector<double> bad = z;
    bad[3] = NAN;
    EXPECT_THROW(height_grid(line, line, bad), DomainError);
}

}  // namespace
}  // namespace endmill
