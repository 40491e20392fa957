// SPDX-License-Identifier: GPL-3.0-or-later
// Cases that the first rays do not meet: creases, seams, narrow cutters, walls.
#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/deviation/detail/deviation_measurement.h"
#include "endmill/stock/stock_history.h"
#include "endmill/verification/detail/stock_ray.h"
#include "test_meshes.h"
#include "test_surfaces.h"
#include "tip_path.h"

namespace endmill {
namespace {

struct Judged {
    Verdict verdict;
    Deviation deviation;
};

Judged judged(const Part& part, const std::vector<Vec3>& tips, const Cutter& cutter,
              double pitch, const DeviationLimits& limits)
{
    const PartCharts charts = part_charts(part);
    const std::vector<StraightSweep> sweeps = path_sweeps(test::tip_path(tips), cutter);
    DeviationOptions options;
    options.limits = limits;
    options.pitch = pitch;
    const MachinedStock stock{
        sweeps, 0, [](const PartRay& ray) {
            return ray_in_block({Vec3{-99, -99, -99}, Vec3{99, 99, 12}}, ray);
        }};
    Deviation found = measure_deviation(charts, stock, options);
    const Verdict word = verdict(found, limits);
    return {word, std::move(found)};
}

constexpr double any_rest = 100;  // mm: only gouges are judged

// Two faces with slope 0.6 that meet in a ridge along x at a height of 6.
TriangleMesh roof_mesh()
{
    return {
        {{0, -8, 1.2}, {20, -8, 1.2}, {20, 0, 6}, {0, 0, 6}, {20, 8, 1.2}, {0, 8, 1.2}},
        {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}}};
}

// The plane z = height + slope y over a rectangle.
Surface slope(double height, double slope, const test::Rectangle& over)
{
    return test::graph(test::monomial(0, 0, height) + test::monomial(0, 1, slope), over);
}

std::vector<Surface> roof_surfaces()
{
    return {slope(6, 0.6, {{0, 20}, {-8, 0}}), slope(6, -0.6, {{0, 20}, {0, 8}})};
}

std::vector<Vec3> along_ridge(double tip)
{
    return {{-10, 0, tip}, {30, 0, tip}};
}

class Roof : public testing::TestWithParam<double> {};

// The cutter removes 0.03 of the ridge, which is 0.0257 from either face.
TEST_P(Roof, OfAFlattenedRidgeIsNeverClean)
{
    const double truth = 0.03 / std::hypot(1, 0.6);
    for (const Part& part : {Part{roof_mesh()}, Part{roof_surfaces()}}) {
        const auto [word, left] = judged(part, along_ridge(5.97), Cutter::ball(5),
                                         GetParam(), {0.01, any_rest});
        EXPECT_TRUE(word == Verdict::Gouged || word == Verdict::Undecided);
        EXPECT_GE(left.max_gouge_mm + left.gouge_bound_mm, truth);
        EXPECT_LE(left.max_gouge_mm, truth + 1e-9);
        if (word == Verdict::Gouged) {
            EXPECT_GT(left.gouge_area_mm2, 0);
        }
    }
}

TEST_P(Roof, OfATouchedRidgeIsClean)
{
    for (const double tip : {6.0, 5.995})
        for (const Part& part : {Part{roof_mesh()}, Part{roof_surfaces()}})
            EXPECT_EQ(judged(part, along_ridge(tip), Cutter::ball(5), GetParam(),
                             {0.01, any_rest})
                          .verdict,
                      Verdict::Clean)
                << tip;
}

INSTANTIATE_TEST_SUITE_P(AtAnyPitch, Roof, testing::Values(0.07, 0.1, 0.25, 0.6, 1.7));

// A thin cutter cuts into a seam of two patches, between two rays.
TEST(DeviationCertainty, HoldsAtSeamsBetweenPatches)
{
    const Part apart = std::vector<Surface>{slope(0, 0, {{0, 10}, {0, 12}}),
                                            slope(0, 0, {{10, 20}, {0, 12}})};
    const Part together = std::vector<Surface>{test::plane(20, 12, {2, 1})};
    for (const Part* part : {&apart, &together})
        for (const Cutter& cutter : {Cutter::ball(0.1), Cutter::flat(0.1)})
            for (const double pitch : {0.5, 1.0}) {
                const auto [word, left] = judged(*part, {{10, 6, 5}, {10, 6, -0.05}},
                                                 cutter, pitch, {0.01, any_rest});
                EXPECT_EQ(word, Verdict::Gouged);
                EXPECT_LE(left.max_gouge_mm, 0.05 + 1e-12);
                EXPECT_GT(left.gouge_area_mm2, 0);
            }
}

TEST(DeviationCertainty, HoldsForPlungesThatNoRayMeets)
{
    const Part surface = std::vector<Surface>{test::plane(20, 12)};
    const Part mesh = test::box_mesh({0, 0, -5}, {20, 12, 0});
    for (const Part* part : {&surface, &mesh})
        for (const Vec3& at : {Vec3{7, 6, 0}, Vec3{7.13, 6.31, 0}, Vec3{8, 5.5, 0}}) {
            const Vec3 bottom = at - Vec3{0, 0, 0.05};
            const auto [word, left] = judged(*part, {at + Vec3{0, 0, 4}, bottom},
                                             Cutter::flat(0.2), 1, {0.01, any_rest});
            EXPECT_EQ(word, Verdict::Gouged);
            EXPECT_NEAR(left.max_gouge_mm, 0.05, 1e-9);
            EXPECT_GT(left.gouge_area_mm2, 0);
            EXPECT_LT(left.gouge_area_mm2, 1);
            EXPECT_TRUE(left.is_cut);
        }
}

// A step up at x = 0 with a floor z = 0 beyond it. The cutter moves along the corner.
TEST(DeviationCertainty, OfAFlatCutterJustAtAWallIsClean)
{
    const TriangleMesh mesh{
        {{0, 0, 0}, {9, 0, 0}, {9, 10, 0}, {0, 10, 0}, {0, 0, 4}, {0, 10, 4}},
        {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4}}};
    for (const double radius : {5.0, 4.7})
        for (const double pitch : {0.1, 0.25})
            EXPECT_EQ(
                judged(mesh, {{radius, -9, 0}, {radius, 19, 0}, {6, 19, 0}, {6, -9, 0}},
                       Cutter::flat(radius), pitch, {0.01, 0.01})
                    .verdict,
                Verdict::Clean)
                << radius << " " << pitch;
}

// The block's walls face stock that no path over the top can remove.
TEST(DeviationCertainty, OfABlockWithAFinishedTopIsClean)
{
    const Part box = test::box_mesh({0, 0, 0}, {12, 8, 5});
    for (const Cutter& cutter : {Cutter::flat(3), Cutter::ball(3), Cutter{3, 1}})
        for (const double height : {5.0, 4.995}) {
            std::vector<Vec3> tips;
            for (int i = 0; i <= 16; ++i) {
                tips.emplace_back(i % 2 ? 12 : 0, 0.5 * i, height);
                tips.emplace_back(i % 2 ? 0 : 12, 0.5 * i, height);
            }
            const auto [word, left] = judged(box, tips, cutter, 0.25, {0.01, 0.02});
            EXPECT_EQ(word, Verdict::Clean) << cutter.corner_radius() << " " << height;
            EXPECT_LE(left.max_gouge_mm, 5 - height + 1e-9);
            EXPECT_GE(left.max_gouge_mm + left.gouge_bound_mm, 5 - height - 1e-9);
            EXPECT_EQ(left.uncut_area_mm2, 0);
            EXPECT_NEAR(left.area_mm2, 12 * 8, 1e-3);
        }
}

// A sharp rim moves along a slope. The verdict becomes certain with finer rays.
TEST(DeviationCertainty, OfAFlatCutterOnASlopeIsReached)
{
    const Part part = std::vector<Surface>{slope(0, 0.5, {{0, 20}, {0, 12}})};
    for (const double lowered : {0.0, 0.05}) {
        std::vector<Vec3> tips;
        for (int i = 0; i <= 10; ++i)
            tips.emplace_back(i % 2 ? 14 : 6, i, 0.5 * (i + 3) - lowered);
        const auto [word, left] =
            judged(part, tips, Cutter::flat(3), 0.25, {0.01, any_rest});
        EXPECT_EQ(word, lowered > 0 ? Verdict::Gouged : Verdict::Clean);
        EXPECT_LE(left.max_gouge_mm, lowered / std::hypot(1, 0.5) + 1e-9);
    }
}

// The measurement of the first rays depends on part and path, not on the limits.
void expect_same_values(const Deviation& one, const Deviation& other)
{
    EXPECT_EQ(one.mean_scallop_mm, other.mean_scallop_mm);
    EXPECT_EQ(one.p99_scallop_mm, other.p99_scallop_mm);
    EXPECT_EQ(one.left, other.left);
}

// A bull-nose cutter leaves a fillet in the corner of floor and wall. The point of the
// fillet that is furthest from both faces is its middle, (sqrt(2) - 1) r / sqrt(2) from
// each.
TEST(DeviationCertainty, OfAFilletInACornerHoldsAtAnyLimit)
{
    const TriangleMesh mesh{
        {{0, 0, 0}, {20, 0, 0}, {20, 10, 0}, {0, 10, 0}, {20, 0, 10}, {20, 10, 10}},
        {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}};
    std::vector<Vec3> tips;
    for (int i = 0; i < 6; ++i)
        for (const double y : {-9.0, 19.0})
            tips.emplace_back(std::min(-5 + 4.0 * i, 15.0), i % 2 ? 10 - y : y, 0);
    const double truth = 2 * (std::sqrt(2.0) - 1) / std::sqrt(2.0);
    std::optional<Deviation> first;
    for (const double limit : {0.1, 0.5, 0.6, 1.0, 3.0}) {
        const auto [word, left] = judged(mesh, tips, Cutter{5, 2}, 0.1, {0.01, limit});
        EXPECT_EQ(word, limit < truth ? Verdict::Uncut : Verdict::Clean) << limit;
        EXPECT_LE(left.max_scallop_mm, truth + 1e-9) << limit;
        EXPECT_GE(left.max_scallop_mm, truth - 0.01) << limit;
        EXPECT_GE(left.max_scallop_mm + left.scallop_bound_mm, truth) << limit;
        if (first)
            expect_same_values(*first, left);
        else
            first = left;
    }
}

// A flat cutter removes the tip of a 45 degree ridge, 0.5 mm high. The middle of the flat
// is 0.5 / sqrt(2) from either face.
TEST(DeviationCertainty, OfAGougeInARidgeIsTheDistanceFromItsFacesAtAnyLimit)
{
    const TriangleMesh mesh{{{-10, -5, -10},
                             {0, -5, 0},
                             {0, 5, 0},
                             {-10, 5, -10},
                             {10, -5, -10},
                             {10, 5, -10}},
                            {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}};
    const double truth = 0.5 / std::sqrt(2.0);
    std::optional<Deviation> first;
    for (const double limit : {0.01, 0.3, 0.4, 0.5, 0.7, 1.0}) {
        const auto [word, left] = judged(mesh, {{0, -20, -0.5}, {0, 20, -0.5}},
                                         Cutter::flat(3), 0.1, {limit, any_rest});
        EXPECT_EQ(word, limit < truth ? Verdict::Gouged : Verdict::Clean) << limit;
        EXPECT_LE(left.max_gouge_mm, truth + 1e-9) << limit;
        EXPECT_GE(left.max_gouge_mm, truth - 0.01) << limit;
        EXPECT_GE(left.max_gouge_mm + left.gouge_bound_mm, truth) << limit;
        if (first)
            expect_same_values(*first, left);
        else
            first = left;
    }
}

// A strip is narrower than the pitch, and a thin cutter cuts into it beside its only row
// of rays.
TEST(DeviationCertainty, OfAGougeThatNoFirstRayMeetsIsFound)
{
    const Part part = std::vector<Surface>{test::plane(20, 2)};
    for (const double pitch : {2.0, 1.0, 0.5}) {
        const auto [word, left] = judged(part, {{7.4, 1.6, 5}, {7.4, 1.6, -0.5}},
                                         Cutter::flat(0.2), pitch, {0.3, 0.05});
        EXPECT_TRUE(left.is_cut) << pitch;
        EXPECT_EQ(word, Verdict::Gouged) << pitch;
        EXPECT_LE(left.max_gouge_mm, 0.5 + 1e-9) << pitch;
    }
}

// While a gouge is possible the verdict is undecided, because a finer grid could still
// find the gouge.
TEST(DeviationCertainty, OfRemainingStockIsOpenWhileAGougeIsPossible)
{
    Deviation left;
    left.max_scallop_mm = 1;
    left.gouge_bound_mm = 0.05;
    EXPECT_EQ(verdict(left, {0.02, 0.1}), Verdict::Undecided);
    EXPECT_EQ(verdict(left, {0.05, 0.1}), Verdict::Uncut);
    left.max_gouge_mm = 0.06;
    EXPECT_EQ(verdict(left, {0.05, 0.1}), Verdict::Gouged);
}

// A gouge that an earlier run left in the stock remains a gouge.
TEST(DeviationCertainty, OfAGougeInTheStockItselfIsReported)
{
    const Part part = std::vector<Surface>{test::plane(20, 12)};
    HeightStock stock = block_stock({{-5, -5, -5}, {25, 17, 0}}, 0.5);
    for (int row = 18; row < 26; ++row)
        for (int column = 20; column < 30; ++column)
            stock.set_height(column, row, -0.5);
    const PartCharts charts = part_charts(part);
    const std::vector<StraightSweep> sweeps =
        path_sweeps(test::tip_path({{0, 6, 0}, {20, 6, 0}}), Cutter::ball(5));
    DeviationOptions options;
    options.pitch = 0.25;
    const Deviation left = measure_deviation(
        charts, {sweeps, 0, [&](const PartRay& ray) { return ray_in_stock(stock, ray); }},
        options);
    EXPECT_EQ(verdict(left, options.limits), Verdict::Gouged);
    EXPECT_NEAR(left.max_gouge_mm, 0.5, 1e-9);
    // The pit is 4 by 5 mm. Cells do not resolve a ring of half a pitch, and one cell
    // inside it.
    EXPECT_GT(left.gouge_area_mm2, 3 * 4 - 1);
    EXPECT_LT(left.gouge_area_mm2, 4 * 5 + 1);
}

}  // namespace
}  // namespace endmill
