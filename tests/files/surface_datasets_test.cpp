// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the files of datasets/surfaces that have a formula with the formula itself.
// The numbers in their README are checked by tests/scripts and tests/cli.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/files/surface_file.h"

namespace endmill {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr double coordinate_rounding = 1e-13;  // mm, of coordinates up to 60 mm

Surface only_surface(const std::string& name)
{
    const std::string folder = ENDMILL_SOURCE_DIR "/datasets/surfaces/";
    return read_surface(folder + name + ".json").surfaces.at(0);
}

// Calls `look` at the points of a grid over a surface; each side of a patch has `parts`
// intervals.
void for_points_of(const Surface& surface, int parts,
                   const std::function<void(const SurfaceJet&)>& look)
{
    for (int j = 0; j < surface.patches(Parameter::V); ++j)
        for (int i = 0; i < surface.patches(Parameter::U); ++i)
            for (int k = 0; k <= parts * (parts + 2); ++k) {
                const int column = k % (parts + 1);
                const int row = k / (parts + 1);
                const double s = double(column) / parts;
                const double t = double(row) / parts;
                const auto u = surface.breaks(Parameter::U).subspan(i, 2);
                const auto v = surface.breaks(Parameter::V).subspan(j, 2);
                look(surface.jet_in_patch(i, j, std::lerp(u[0], u[1], s),
                                          std::lerp(v[0], v[1], t)));
            }
}

struct HeightGridFile {
    std::string name;
    std::function<double(double x, double y)> height;
    double error;  // mm, as stated in the README, rounded up in its last digit
};

class HeightGridFiles : public testing::TestWithParam<HeightGridFile> {};

TEST_P(HeightGridFiles, DifferFromTheirFormulaByTheErrorInTheReadme)
{
    double farthest = 0;
    for_points_of(only_surface(GetParam().name), 16, [&](const SurfaceJet& jet) {
        const Vec3& p = jet.point;
        farthest = std::max(farthest, std::abs(p.z() - GetParam().height(p.x(), p.y())));
    });
    EXPECT_LE(farthest, GetParam().error);
    EXPECT_GE(farthest, 0.9 * GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    All, HeightGridFiles,
    testing::Values(HeightGridFile{"gaussian-bump",
                                   [](double x, double y) {
                                       return 20 * std::exp(-(x * x + y * y) / 450);
                                   },
                                   0.0041},
                    HeightGridFile{"wavy",
                                   [](double x, double y) {
                                       return 3 * std::cos(two_pi * x / 80) *
                                              std::cos(two_pi * y / 60);
                                   },
                                   0.0059},
                    HeightGridFile{"ball-end-test-surface",
                                   [](double x, double y) {
                                       const double a = x / 40;
                                       const double b = y / 40;
                                       return 40 * a * b * (a * a - b * b) /
                                              (a * a + b * b + 0.25);
                                   },
                                   0.0096}));

struct RoundFile {
    std::string name;
    std::function<double(const Vec3& point)> distance;  // mm, outside positive
    double least_normal_z;
};

class RoundFiles : public testing::TestWithParam<RoundFile> {};

TEST_P(RoundFiles, LieOnTheirEquationAndFaceTheTool)
{
    const Surface surface = only_surface(GetParam().name);
    double least_normal_z = 1;
    for_points_of(surface, 16, [&](const SurfaceJet& jet) {
        EXPECT_NEAR(GetParam().distance(jet.point), 0, coordinate_rounding);
        const Vec3 normal = jet.du.cross(jet.dv).normalized();
        least_normal_z = std::min(least_normal_z, std::abs(normal.z()));
        const Vec3 outwards = jet.point + 1e-3 * std::copysign(1, normal.z()) * normal;
        EXPECT_GT(GetParam().distance(outwards), 0);
    });
    EXPECT_NEAR(least_normal_z, GetParam().least_normal_z, 1e-13);
}

INSTANTIATE_TEST_SUITE_P(
    All, RoundFiles,
    testing::Values(
        RoundFile{"cylinder", [](const Vec3& p) { return std::hypot(p.y(), p.z()) - 20; },
                  0.28},
        RoundFile{"sphere", [](const Vec3& p) { return p.norm() - 25; }, 0.36},
        RoundFile{"torus",
                  [](const Vec3& p) {
                      const double ring = std::hypot(p.x(), p.y()) - 40;
                      return std::hypot(ring, p.z()) - 15;
                  },
                  0.28}));

}  // namespace
}  // namespace endmill
