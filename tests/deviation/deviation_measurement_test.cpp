// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/deviation_measurement.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/tolerance.h"
#include "endmill/stock/stock_history.h"
#include "endmill/verification/detail/stock_ray.h"
#include "revolved_surfaces.h"
#include "test_meshes.h"
#include "test_surfaces.h"
#include "tip_path.h"

namespace endmill {
namespace {

// Measures a path that cuts a block which ends `above` mm over z = 0.
Deviation deviation_of(const Part& part, const ToolPath& path, const Cutter& cutter,
                       const DeviationOptions& options, double above = 3)
{
    const PartCharts charts = part_charts(part);
    const std::vector<StraightSweep> sweeps = path_sweeps(path, cutter);
    const MachinedStock stock{
        sweeps, 0, [above](const PartRay& ray) {
            return ray_in_block({Vec3::Constant(-1e3), {1e3, 1e3, above}}, ray);
        }};
    return measure_deviation(charts, stock, options);
}

// Level passes along x; `tip_at(number)` returns y and z of the tip.
template <typename TipAt>
ToolPath passes(int count, double from_x, double to_x, const TipAt& tip_at)
{
    std::vector<Vec3> tips;
    for (int i = 0; i < count; ++i) {
        const Eigen::Vector2d yz = tip_at(i);
        const bool is_back = i % 2 == 1;
        tips.emplace_back(is_back ? to_x : from_x, yz.x(), yz.y());
        tips.emplace_back(is_back ? from_x : to_x, yz.x(), yz.y());
    }
    return test::tip_path(tips);
}

Part plane_part()
{
    return std::vector<Surface>{test::plane(20, 12)};
}

ToolPath level_passes(double pitch)
{
    return passes(static_cast<int>(std::lround(12 / pitch)) + 1, 0, 20, [&](int i) {
        return Eigen::Vector2d{i * pitch, 0};
    });
}

// The centre of a ball passes outside the edge x = 0 of a plane, at a distance of
// `beyond`. The ball removes 0.3 mm along the normal at the edge, and nothing from 0.06
// mm inside the edge on.
TEST(Deviation, IsUndecidedAtTheBorderWithACoarseGrid)
{
    constexpr double radius = 4;
    constexpr double beyond = 3.9;
    const Part part = std::vector<Surface>{test::plane(4, 3)};
    const double tip = std::sqrt(radius * radius - beyond * beyond) - 0.3 - radius;
    const auto verdict_at = [&](double pitch, bool is_beside) {
        std::vector<Vec3> tips{{0, 0, 0},   {4, 0, 0}, {4, 1.5, 0},
                               {0, 1.5, 0}, {0, 3, 0}, {4, 3, 0}};
        if (is_beside)
            for (const Vec3& at : {Vec3{4, 3, 9}, Vec3{-beyond, 3, 9},
                                   Vec3{-beyond, 3, tip}, Vec3{-beyond, 0, tip}})
                tips.push_back(at);
        DeviationOptions options;
        options.limits = {0.1, 1};
        options.pitch = pitch;
        const Deviation deviation =
            deviation_of(part, test::tip_path(tips), Cutter::ball(radius), options);
        return verdict(deviation, options.limits);
    };
    for (const double pitch : {1.0, 0.3, 0.02})
        EXPECT_EQ(verdict_at(pitch, false), Verdict::Clean) << pitch;
    EXPECT_EQ(verdict_at(1, true), Verdict::Undecided);
    EXPECT_EQ(verdict_at(0.3, true), Verdict::Undecided);
    EXPECT_EQ(verdict_at(0.02, true), Verdict::Gouged);
}

// The cutter is said to reach only the half x > 10 of a plane of 20 by 12 mm.
TEST(Deviation, JudgesRemainingStockOnlyWhereTheCutterReaches)
{
    constexpr double scallop = 0.101020514434;  // R 5, passes 2 apart
    DeviationOptions options;
    options.pitch = 0.1;
    options.limits = {0.01, 0.05};
    const auto measured = [&] {
        return deviation_of(plane_part(), level_passes(2), Cutter::ball(5), options);
    };
    const Deviation all = measured();
    EXPECT_EQ(all.inaccessible_area_mm2, 0);
    options.is_accessible = [](const PartRay& ray) { return ray.point.x() > 10; };
    const Deviation half = measured();
    EXPECT_NEAR(half.uncut_area_mm2, all.uncut_area_mm2 / 2, 1e-6 * all.uncut_area_mm2);
    EXPECT_NEAR(half.inaccessible_area_mm2 + half.area_mm2, 240, 1e-3);
    // On each level pass the parabola y^2 / (2 R) leaves more than half of the limit where y
    // exceeds sqrt(R * limit); the passes are 2 apart.
    const double left_out = 120 * (1 - std::sqrt(5 * options.limits.scallop));
    EXPECT_NEAR(half.inaccessible_area_mm2, left_out, 0.05 * left_out);
    EXPECT_NEAR(half.max_inaccessible_mm, scallop, 0.01 * scallop + 0.01);
    EXPECT_GT(half.highest->ray.point.x(), 10);

    options.is_accessible = [](const PartRay&) { return false; };
    const Deviation none = measured();
    EXPECT_EQ(none.uncut_area_mm2, 0);
    EXPECT_LE(none.max_scallop_mm, reached_share * options.limits.scallop);
    EXPECT_EQ(verdict(none, options.limits), Verdict::Clean);
}

// Gouges are judged everywhere.
TEST(Deviation, JudgesGougesWhereTheCutterDoesNotReach)
{
    DeviationOptions options;
    options.pitch = 0.2;
    options.limits = {0.01, 1};
    options.is_accessible = [](const PartRay&) { return false; };
    const auto lowered = [](int i) { return Eigen::Vector2d{2.0 * i, -0.2}; };
    const Deviation deep =
        deviation_of(plane_part(), passes(7, 0, 20, lowered), Cutter::ball(5), options);
    EXPECT_NEAR(deep.max_gouge_mm, 0.2, 1e-3);
    EXPECT_EQ(verdict(deep, options.limits), Verdict::Gouged);
}

// Passes over the half of a mesh that is not skipped; the ball enters the other half.
TEST(Deviation, JudgesGougesOnlyOnSkippedFacets)
{
    const TriangleMesh mesh = test::flat_mesh(20, 12);
    const Part part = mesh;
    std::vector<std::size_t> far;
    for (std::size_t facet = 0; facet < mesh.triangles().size(); ++facet) {
        const auto [a, b, c] = mesh.corners(facet);
        if (a.x() + b.x() + c.x() > 30)
            far.push_back(facet);
    }
    DeviationOptions options;
    options.pitch = 0.25;
    options.limits = {0.01, 0.2};
    const ToolPath half = passes(7, 0, 10, [](int i) {
        return Eigen::Vector2d{2.0 * i, 0};
    });
    const auto measured = [&](const ToolPath& path) {
        return deviation_of(part, path, Cutter::ball(5), options);
    };
    EXPECT_EQ(verdict(measured(half), options.limits), Verdict::Uncut);
    options.skipped_facets = far;
    const Deviation found = measured(half);
    EXPECT_EQ(verdict(found, options.limits), Verdict::Clean);
    EXPECT_NEAR(found.area_mm2, 120, 1e-5);  // areas have single precision
    EXPECT_EQ(found.inaccessible_area_mm2, 0);
    ToolPath deep = half;
    const ToolPath below = test::tip_path({{15, 6, 5}, {15, 6, -0.2}});
    deep.points.insert(deep.points.end(), below.points.begin(), below.points.end());
    const Deviation gouged = measured(deep);
    EXPECT_NEAR(gouged.max_gouge_mm, 0.2, 0.02);
    EXPECT_EQ(verdict(gouged, options.limits), Verdict::Gouged);
}

class ParallelPasses : public testing::TestWithParam<double> {};

// The passes are a whole number of pitches apart, so that cusps fall between rays.
TEST_P(ParallelPasses, LeaveTheScallopOfTheClosedForm)
{
    constexpr double scallop = 0.101020514434;  // R 5, passes 2 apart
    DeviationOptions options;
    options.pitch = GetParam();
    options.limits = {0.01, scallop + 1e-6};
    const Deviation left =
        deviation_of(plane_part(), level_passes(2), Cutter::ball(5), options);
    EXPECT_EQ(verdict(left, options.limits), Verdict::Clean);
    EXPECT_LE(left.max_scallop_mm, scallop + 1e-12);
    EXPECT_GE(left.max_scallop_mm + left.scallop_bound_mm, scallop - 1e-9);
    EXPECT_LE(left.scallop_bound_mm, 0.005);
    EXPECT_EQ(left.max_gouge_mm, 0);
    EXPECT_NEAR(left.mean_scallop_mm, 0.0331988468909, 0.2 * GetParam() * GetParam());
    EXPECT_NEAR(left.area_mm2, 240, 1e-3);
    EXPECT_TRUE(left.is_cut);
}

INSTANTIATE_TEST_SUITE_P(AtAnyPitch, ParallelPasses,
                         testing::Values(0.4, 0.2, 0.1, 0.07));

TEST(Deviation, OfAnOmittedPassIsTheScallopOfTwiceThePitch)
{
    const ToolPath path = passes(8, 0, 20, [](int i) {
        return Eigen::Vector2d{1.5 * (i < 3 ? i : i + 1), 0};  // none at y = 4.5
    });
    DeviationOptions options;
    options.limits = {0.01, 0.1};
    const Deviation left = deviation_of(plane_part(), path, Cutter::ball(5), options);
    EXPECT_EQ(verdict(left, options.limits), Verdict::Uncut);
    constexpr double scallop = 0.230303992915;  // R 5, passes 3 apart
    EXPECT_LE(left.max_scallop_mm, scallop + 1e-12);
    EXPECT_GE(left.max_scallop_mm + left.scallop_bound_mm, scallop - 1e-12);
    ASSERT_TRUE(left.highest);
    EXPECT_NEAR(left.highest->ray.point.y(), 4.5, 0.1);
    // The strip where the balls on both sides leave more than the limit.
    const double half = 1.5 - std::sqrt(25 - 4.9 * 4.9);
    EXPECT_NEAR(left.uncut_area_mm2, 20 * 2 * half, 20 * 0.2);
}

// Most passes lie beside the ray at the middle of such a cell and never meet it.
TEST(Deviation, OfCellsWiderThanTheCutterOverstatesNothing)
{
    const double scallop = 1 - std::sqrt(0.75);  // R 1, passes 1 apart
    for (const double pitch : {3.0, 6.0, 12.0}) {
        DeviationOptions options;
        options.pitch = pitch;
        options.limits = {0.01, 1.1 * scallop};
        const Deviation left =
            deviation_of(plane_part(), level_passes(1), Cutter::ball(1), options);
        EXPECT_LE(left.max_scallop_mm, scallop + 1e-12) << pitch;
        EXPECT_NE(verdict(left, options.limits), Verdict::Uncut) << pitch;
    }
}

TEST(Deviation, OfMoreHalvingsIsNoLessCertain)
{
    DeviationOptions options;
    options.pitch = 6;
    options.limits = {0.01, 0.05};
    double gouge_bound = 1e3;
    for (const int halvings : {2, 4, 8, 12}) {
        options.max_refine = halvings;
        const Deviation left =
            deviation_of(plane_part(), level_passes(1), Cutter::ball(5), options);
        EXPECT_LE(left.gouge_bound_mm, gouge_bound) << halvings;
        gouge_bound = left.gouge_bound_mm;
    }
    EXPECT_LE(gouge_bound, options.limits.tolerance);
}

TEST(Deviation, FindsAndPlacesADeliberateGouge)
{
    ToolPath path = level_passes(1.5);
    path.points.push_back({.pass = 0,
                           .point = 0,
                           .move = Move::Cut,
                           .location = {{7.3, 4.1, -0.05}, Vec3::UnitZ()}});
    path.points[path.points.size() - 2].location.tip = {7.3, 4.1, 3};
    DeviationOptions options;
    options.limits = {0.01, 1};
    const Deviation left = deviation_of(plane_part(), path, Cutter::ball(5), options);
    EXPECT_EQ(verdict(left, options.limits), Verdict::Gouged);
    EXPECT_LE(left.max_gouge_mm, 0.05 + 1e-12);
    EXPECT_GE(left.max_gouge_mm + left.gouge_bound_mm, 0.05 - 1e-12);
    ASSERT_TRUE(left.deepest);
    EXPECT_NEAR(left.deepest->ray.point.x(), 7.3, 0.1);
    EXPECT_NEAR(left.deepest->ray.point.y(), 4.1, 0.1);
    // The disc in which the ball is deeper than the tolerance.
    EXPECT_NEAR(left.gouge_area_mm2, std::numbers::pi * (25 - 4.96 * 4.96), 0.2);
}

// Passes 0.05 mm below the plane, or on it, measured without and with refinement: only a
// bound that was refined may become smaller.
TEST(RefinedBounds, AreThoseThatHalvingCellsMakesSmaller)
{
    struct Case {
        double depth;
        DeviationLimits limits;
        RefinedBounds refined;
    };
    for (const auto& [depth, limits, refined] :
         {Case{0.05, {0.01, 1}, {false, false}}, Case{0, {0.01, 0.01}, {true, false}},
          Case{0, {0.01, 0.12}, {true, true}}}) {
        const ToolPath path = passes(7, 0, 20, [depth = depth](int i) {
            return Eigen::Vector2d{2 * i, -depth};
        });
        DeviationOptions options{.limits = limits, .pitch = 1, .max_refine = 0};
        const Deviation coarse =
            deviation_of(plane_part(), path, Cutter::ball(5), options);
        options.max_refine = 8;
        const Deviation fine = deviation_of(plane_part(), path, Cutter::ball(5), options);
        EXPECT_EQ(refined_bounds(fine, limits).gouge_is_refined,
                  refined.gouge_is_refined);
        EXPECT_EQ(refined_bounds(fine, limits).scallop_is_refined,
                  refined.scallop_is_refined);
        EXPECT_EQ(fine.gouge_bound_mm < coarse.gouge_bound_mm, refined.gouge_is_refined);
        if (refined.scallop_is_refined) {
            EXPECT_LT(fine.scallop_bound_mm, coarse.scallop_bound_mm);
        }
    }
}

TEST(Deviation, OnACylinderIsThatOfItsPassesOutsideAndInside)
{
    const auto check = [](double angle_deg, double rho, double side, double scallop) {
        const double R = 5;
        const double step = angle_deg * std::numbers::pi / 180;
        const double from = side > 0 ? 0.3 : -2.5;
        Surface surface = nurbs_surface(test::cylinder(rho, 4, from, from + 2));
        const int count = static_cast<int>(2 / step) + 2;
        const ToolPath path = passes(count, -1, 5, [&](int i) {
            const double angle = from + i * step;
            const double centre = rho + side * R;
            return Eigen::Vector2d{centre * std::cos(angle),
                                   centre * std::sin(angle) - R};
        });
        DeviationOptions options;
        options.pitch = 0.05;
        options.limits = {0.01, scallop + 1e-3};
        const Deviation left = deviation_of(std::vector<Surface>{surface}, path,
                                            Cutter::ball(R), options, 30);
        EXPECT_EQ(verdict(left, options.limits), Verdict::Clean);
        EXPECT_NEAR(left.max_scallop_mm, scallop, left.scallop_bound_mm + 1e-9);
        EXPECT_LT(left.max_gouge_mm, 1e-9);
    };
    check(4, 20, +1, 0.0614825764327);
    check(6, 20, -1, 0.0825702199982);
}

class LoweredPath : public testing::TestWithParam<double> {};

// The slopes include upright walls, where the vertical gap says nothing about the
// distance.
TEST_P(LoweredPath, GougesByItsShareAlongTheNormal)
{
    const double slope = GetParam() * std::numbers::pi / 180;
    const Vec3 normal{-std::sin(slope), 0, std::cos(slope)};
    const Vec3 up{std::cos(slope), 0, std::sin(slope)};
    const Part part = std::vector<Surface>{test::parallelogram(6 * up, Vec3{0, 6, 0})};
    std::vector<Vec3> tips;
    for (int i = 0; i <= 60; ++i)
        for (const double y : {i % 2 ? 6.0 : 0.0, i % 2 ? 0.0 : 6.0})
            tips.push_back(0.1 * i * up + Vec3{0, y, 0} + 5 * normal - Vec3{0, 0, 5.2});
    DeviationOptions options;
    options.limits = {0.001, 0.1};
    const Deviation left =
        deviation_of(part, test::tip_path(tips), Cutter::ball(5), options, 20);
    EXPECT_NEAR(left.max_gouge_mm, 0.2 * std::cos(slope), 1e-9 + left.gouge_bound_mm);
}

INSTANTIATE_TEST_SUITE_P(FromFlatToSteep, LoweredPath,
                         testing::Values(0.0, 30.0, 60.0, 80.0, 89.0));

TEST(Deviation, OfAFlatCutterAlongAWallIsItsDistance)
{
    // A step up at x = 0: floor z = 0 for x > 0, wall x = 0 up to z = 4.
    const TriangleMesh mesh{
        {{0, 0, 0}, {13, 0, 0}, {13, 10, 0}, {0, 10, 0}, {0, 0, 4}, {0, 10, 4}},
        {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4}}};
    for (const double away : {0.03, -0.03}) {
        const ToolPath path = test::tip_path(
            {{5 + away, -9, 0}, {5 + away, 19, 0}, {9, 19, 0}, {9, -9, 0}});
        DeviationOptions options;
        options.limits = {0.01, 0.01};
        options.pitch = 0.25;
        const Deviation left = deviation_of(mesh, path, Cutter::flat(5), options, 4);
        if (away > 0) {
            EXPECT_LE(left.max_scallop_mm, away + 1e-9);
            EXPECT_GE(left.max_scallop_mm + left.scallop_bound_mm, away - 1e-9);
            EXPECT_GE(left.max_scallop_mm, away - 1e-9);
            EXPECT_EQ(verdict(left, options.limits), Verdict::Uncut);
        } else {
            EXPECT_NEAR(left.max_gouge_mm, -away, 1e-9);
            EXPECT_EQ(verdict(left, options.limits), Verdict::Gouged);
        }
    }
}

// The passes of a flat cutter leave a thin wall between them, which no ray need hit.
TEST(Deviation, OfAThinWallBetweenPassesIsNotClean)
{
    const ToolPath path = passes(2, -9, 29, [](int i) {
        return Eigen::Vector2d{i * 10.02 + 1.013, 0};
    });
    DeviationOptions options;
    options.limits = {0.01, 0.5};
    const Part part = std::vector<Surface>{test::plane(20, 12)};
    EXPECT_NE(verdict(deviation_of(part, path, Cutter::flat(5), options), options.limits),
              Verdict::Clean);
}

TEST(Deviation, OfABullNoseLeavesNoScallopBetweenItsFlats)
{
    DeviationOptions options;
    options.limits = {0.01, 0.01};
    const Deviation left =
        deviation_of(plane_part(), level_passes(4), Cutter{5, 2}, options);
    EXPECT_EQ(verdict(left, options.limits), Verdict::Clean);
    EXPECT_LT(left.max_scallop_mm, 1e-12);
}

TEST(Deviation, OfAMeshIsThatOfTheSurfaceItSamples)
{
    DeviationOptions options;
    options.limits = {0.01, 0.2};
    const ToolPath path = level_passes(2);
    const Deviation of_surface =
        deviation_of(plane_part(), path, Cutter::ball(5), options);
    const TriangleMesh mesh = test::grid_mesh(5, 3, [](int i, int j) {
        return Vec3{4.0 * i, 4.0 * j, 0};
    });
    const Deviation of_mesh = deviation_of(mesh, path, Cutter::ball(5), options);
    EXPECT_NEAR(of_mesh.area_mm2, of_surface.area_mm2, 1e-3);
    EXPECT_NEAR(of_mesh.mean_scallop_mm, of_surface.mean_scallop_mm, 1e-3);
    EXPECT_NEAR(of_mesh.max_scallop_mm, of_surface.max_scallop_mm, 5e-3);
}

TEST(Deviation, IsTheSameWithAnyNumberOfThreads)
{
    DeviationOptions options;
    options.limits = {0.01, 0.09};
    const ToolPath path = level_passes(1.9);
    const auto measure = [&](int threads) {
        set_thread_count(threads);
        return deviation_of(plane_part(), path, Cutter::ball(5), options);
    };
    const Deviation one = measure(1);
    for (const int threads : {2, 3, 8}) {
        const Deviation many = measure(threads);
        EXPECT_EQ(many.left, one.left);
        EXPECT_EQ(many.max_scallop_mm, one.max_scallop_mm);
        EXPECT_EQ(many.scallop_bound_mm, one.scallop_bound_mm);
        EXPECT_EQ(many.rays, one.rays);
        EXPECT_EQ(many.highest->ray.point, one.highest->ray.point);
    }
}

TEST(Deviation, OfAPathElsewhereCutsNothing)
{
    const ToolPath path = test::tip_path({{100, 100, 0}, {120, 100, 0}});
    const Deviation left = deviation_of(plane_part(), path, Cutter::ball(5), {});
    EXPECT_FALSE(left.is_cut);
    EXPECT_NEAR(left.max_scallop_mm, 3, 1e-12);
    EXPECT_EQ(verdict(left, {}), Verdict::Uncut);
}

TEST(Deviation, RefusesUnsupportedInput)
{
    DeviationOptions options;
    options.pitch = 0;
    EXPECT_THROW(deviation_of(plane_part(), level_passes(2), Cutter::ball(5), options),
                 DomainError);
    options.pitch = 1e-3;
    options.most_cells = 1000;
    EXPECT_THROW(deviation_of(plane_part(), level_passes(2), Cutter::ball(5), options),
                 LimitError);
}

TEST(Verdict, OfTheGridIsNeverReversedByAFinerOne)
{
    // The true scallop is 0.1010205. The closer the limit is to it, the longer the
    // verdict stays undecided.
    for (const double limit : {0.08, 0.099, 0.1, 0.1004, 0.102, 0.2}) {
        const double truth = 0.101020514434;
        for (const double pitch : {0.8, 0.4, 0.2})
            for (const int refine : {0, 1, 8}) {
                DeviationOptions options;
                options.pitch = pitch;
                options.max_refine = refine;
                options.limits = {0.01, limit};
                const Verdict found = verdict(
                    deviation_of(plane_part(), level_passes(2), Cutter::ball(5), options),
                    options.limits);
                if (found != Verdict::Undecided) {
                    EXPECT_EQ(found, truth > limit + verdict_slack ? Verdict::Uncut
                                                                   : Verdict::Clean)
                        << limit << " " << pitch << " " << refine;
                }
            }
    }
}

}  // namespace
}  // namespace endmill
