// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/trimmed_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "dense_drop.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/drop_cutter/clearance.h"
#include "offset_parts.h"
#include "trimmed_curves.h"

namespace endmill {
namespace {

constexpr double p = 4;       // mm, of the trough z = x^2 / (2 p) + y tan(beta)
constexpr double radius = 7;  // mm, of the ball
constexpr double beta = 25 * std::numbers::pi / 180;

// A part, its sections and their trimmed results.
struct Sections {
    std::vector<Surface> surfaces;
    Cutter cutter;
    DrivePlanes planes;
    OffsetMesh offset;
    std::vector<PlaneSection> sections;
    std::vector<Trimmed> trimmed;

    Sections(std::vector<Surface> part, const Cutter& with, int grid, DrivePlanes at)
        : surfaces{std::move(part)},
          cutter{with},
          planes{std::move(at)},
          offset{offset_mesh(surfaces, cutter, {.grid_lines = grid})},
          sections{slice(offset.mesh, planes, {offset.part_triangles})},
          trimmed{trim_planes(sections, path_ranges(offset, planes, sections),
                              test::trimming_method("envelope"), {})}
    {
    }

    SectionSource source() const { return {surfaces, offset, planes, sections}; }
};

Sections trough(int grid_lines)
{
    const test::Polynomial height =
        test::monomial(2, 0, 1 / (2 * p)) + test::monomial(0, 1, std::tan(beta));
    return {{test::graph(height, {{-20, 21}, {-15, 16}})},
            Cutter::ball(radius),
            grid_lines,
            {DriveFrame{Angle::degrees(0)}, {0, 1.3}}};
}

TEST(RefinedPlanes, FindTheCrossingOfTheInclinedTroughOnEveryGrid)
{
    // Closed form A3 of docs/methods/interference.md, section 11. On these grids the sampled
    // crossing is off by 5e-3 and 2e-3 mm.
    const double crossing =
        radius * radius / (2 * p) + p / (2 * std::cos(beta) * std::cos(beta));
    for (const int grid_lines : {51, 101}) {
        const Sections sections = trough(grid_lines);
        const RefinedPlanes refined = refine_planes(sections.source(), sections.trimmed);
        const auto& points = refined.planes[0].curves.front().points;
        const auto found =
            std::ranges::find(points, TrimmedKind::Crossing, &TrimmedPoint::kind);
        ASSERT_NE(found, points.end());
        EXPECT_NEAR(found->at.x(), 0, 1e-8);
        EXPECT_NEAR(found->at.y(), crossing, 1e-8);
    }
}

TEST(RefinedPlanes, TouchThePartAtEveryRefinedPoint)
{
    const Sections sections = trough(41);
    const RefinedPlanes refined = refine_planes(sections.source(), sections.trimmed);
    std::vector<Vec3> places;
    for (std::size_t k = 0; k < refined.planes.size(); ++k)
        for (const TrimmedCurve& curve : refined.planes[k].curves)
            for (const TrimmedPoint& point : curve.points)
                places.push_back(sections.planes.frame.point(
                    point.at.x(), sections.planes.positions[k], point.at.y()));
    ASSERT_GT(places.size(), 40U);
    constexpr double resolution = 1e-7;
    EXPECT_GE(least_gap(sections.surfaces, sections.cutter, places, {resolution})->gap,
              -1e-8);
    // Each point on its own, so that a point above the part is found as well.
    for (std::size_t k = 0; k < places.size(); k += 7)
        EXPECT_NEAR(
            least_gap(sections.surfaces, sections.cutter, {&places[k], 1}, {resolution})
                ->gap,
            0, 2 * resolution);
}

TEST(RefinedPlanes, ReportTheErrorOfTheSampling)
{
    // The error is of second order in the pitch: 16 times smaller at a quarter of the
    // pitch.
    const Sections coarse = trough(41);
    const double error = sampling_error(coarse.source(), coarse.trimmed);
    EXPECT_GT(error, 1e-3);
    const Sections fine = trough(161);
    EXPECT_LT(sampling_error(fine.source(), fine.trimmed), error / 8);
}

TEST(RefinedPlanes, AreTheSameWithAnyNumberOfThreads)
{
    const Sections sections = trough(41);
    std::vector<std::vector<double>> heights;
    for (const int threads : {1, 3}) {
        set_thread_count(threads);
        auto& all = heights.emplace_back();
        for (const Trimmed& plane :
             refine_planes(sections.source(), sections.trimmed).planes)
            for (const TrimmedCurve& curve : plane.curves)
                for (const TrimmedPoint& point : curve.points)
                    all.push_back(point.at.y());
    }
    EXPECT_EQ(heights[0], heights[1]);
}

TEST(RefinedPlanes, RestOnLevelPlacesWithAFlatCutter)
{
    const Sections level{
        {test::plane(20, 10)}, Cutter::flat(2), 11, {DriveFrame{Angle::degrees(0)}, {5}}};
    const RefinedPlanes refined = refine_planes(level.source(), level.trimmed);
    EXPECT_EQ(refined.unrefined, 0U);
    for (const TrimmedPoint& point : refined.planes[0].curves.front().points)
        EXPECT_EQ(point.at.y(), 0.0);
}

// A part with its closed form.
struct KnownPart {
    std::vector<Surface> surfaces;
    test::PlanPart plan;
};

// Hills and hollows that are too narrow for the cutters; the border is bent up and down.
KnownPart bumpy()
{
    const test::Polynomial height =
        test::monomial(2, 0, 0.02) + test::monomial(0, 2, -0.018) +
        test::monomial(1, 1, 0.006) + test::monomial(3, 0, 0.0012) +
        test::monomial(0, 3, -0.0011) + test::monomial(2, 2, -0.00012) +
        test::monomial(1, 0, -0.15) + test::monomial(0, 1, 0.1) +
        test::monomial(3, 2, 4e-6) + test::monomial(1, 3, 3e-5);
    const test::Rectangle over{{-20, 21}, {-15, 16}};
    return {{test::graph(height, over, {2, 1})}, test::plan_graph(height, over)};
}

double bernstein(const std::array<double, 4>& c, double t)
{
    const double s = 1 - t;
    return c[0] * s * s * s + 3 * c[1] * s * s * t + 3 * c[2] * s * t * t +
           c[3] * t * t * t;
}

// In the valley x depends on u alone and y on v. Newton's method finds u, starting from x
// / 100, where x' is at least 60.
KnownPart valley()
{
    const auto height = [](double x, double y) {
        double u = x / 100;
        for (int round = 0; round < 6; ++round)
            u -= (bernstein({0, 60, 40, 100}, u) - x) /
                 (180 * (1 - u) * (1 - u) - 120 * u * (1 - u) + 180 * u * u);
        const double outer = bernstein({40, 45, 55, 60}, y / 100);
        const double inner = bernstein({20, 0, -20, -40}, y / 100);
        return bernstein({outer, inner, inner, outer}, u);
    };
    return {{test::narrowing_valley()}, {{{0, 100}, {0, 100}}, height, {}}};
}

// A convex crease, a concave crease, and corners where they meet.
KnownPart folded()
{
    const auto height = [](double x, double y) {
        return 0.6 * std::abs(x) - 0.4 * std::abs(y);
    };
    std::vector<Surface> facets;
    for (const Interval& y : {Interval{-9, 0}, Interval{0, 9}})
        for (const Interval& x : {Interval{-9, 0}, Interval{0, 9}})
            facets.push_back(test::facet({x, y}, height));
    return {std::move(facets),
            {{{-9, 9}, {-9, 9}}, height, {{{{0, -9}, {0, 9}}}, {{{-9, 0}, {9, 0}}}}}};
}

struct Case {
    const char* name;
    KnownPart (*part)();
    Cutter cutter;
};

class RefinedHeights : public testing::TestWithParam<Case> {};

// The accuracy that refine_planes promises. The test takes a few planes, the first and
// the last next to the corners, and of their points all crossings, ends and neighbours of
// these, and some others, because the dense drop is slow.
TEST_P(RefinedHeights, AreThoseOfADenseDropOnEveryGrid)
{
    const KnownPart part = GetParam().part();
    const Cutter& cutter = GetParam().cutter;
    for (const double degrees : {0.0, 30.0})
        for (const int grid : {25, 50, 100, 200}) {
            const DriveFrame frame{Angle::degrees(degrees)};
            const Interval across = extent_across(part.surfaces, frame);
            const auto at = [&](double share) {
                return std::lerp(across.low, across.high, share);
            };
            const Sections sections{
                part.surfaces, cutter, grid, {frame, {at(0.01), at(0.63), at(0.985)}}};
            const RefinedPlanes refined =
                refine_planes(sections.source(), sections.trimmed);
            EXPECT_EQ(refined.unrefined, 0U);
            for (std::size_t k = 0; k < 3; ++k)
                for (const TrimmedCurve& curve : refined.planes[k].curves)
                    for (std::size_t i = 0; i < curve.points.size(); ++i) {
                        const auto is_plain = [&](std::size_t j) {
                            return curve.points[j].kind == TrimmedKind::Vertex;
                        };
                        if (i > 0 && i + 1 < curve.points.size() && i % 37 != 0 &&
                            is_plain(i - 1) && is_plain(i) && is_plain(i + 1))
                            continue;
                        const SectionPoint& point = curve.points[i].at;
                        const Vec3 axis =
                            frame.point(point.x(), sections.planes.positions[k], 0);
                        EXPECT_NEAR(point.y(),
                                    test::DenseDrop(part.plan, cutter, axis.x(), axis.y())
                                        .height(),
                                    1e-4)
                            << "grid " << grid << ", " << degrees << " deg, plane " << k
                            << ", s = " << point.x();
                    }
        }
}

INSTANTIATE_TEST_SUITE_P(OfPartsAndCutters, RefinedHeights,
                         testing::Values(Case{"ValleyByBall", valley, Cutter::ball(10)},
                                         Case{"ValleyByBullNose", valley, Cutter{10, 3}},
                                         Case{"ValleyByFlat", valley, Cutter::flat(10)},
                                         Case{"BumpyByBall", bumpy, Cutter::ball(8)},
                                         Case{"BumpyByBullNose", bumpy, Cutter{8, 2}},
                                         Case{"BumpyByFlat", bumpy, Cutter::flat(8)},
                                         Case{"FoldedByBall", folded, Cutter::ball(3)},
                                         Case{"FoldedByBullNose", folded, Cutter{3, 1}},
                                         Case{"FoldedByFlat", folded, Cutter::flat(3)}),
                         [](const auto& tested) {
                             return std::string{tested.param.name};
                         });

TEST(RefinedPlanes, RefuseAnotherNumberOfPlanes)
{
    const Sections sections = trough(21);
    EXPECT_THROW(refine_planes(sections.source(), std::span{sections.trimmed}.first(1)),
                 DomainError);
}

}  // namespace
}  // namespace endmill
