// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/interference/refined_planes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/interference/clearance.h"
#include "endmill/interference/clipped_sections.h"
#include "endmill/interference/envelope_trimming.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double p = 4;       // mm, of the trough z = x^2 / (2 p) + y tan(beta)
constexpr double radius = 7;  // mm, of the ball
constexpr double beta = 25 * std::numbers::pi / 180;

// A part, its sections and what is left of them.
struct Sections {
    std::vector<Surface> surfaces;
    Cutter cutter;
    int grid_lines;
    DrivePlanes planes;
    OffsetMesh offset;
    std::vector<PlaneSection> sections;
    std::vector<Trimmed> trimmed;

    Sections(std::vector<Surface> part, const Cutter& with, int grid, DrivePlanes at)
        : surfaces{std::move(part)},
          cutter{with},
          grid_lines{grid},
          planes{std::move(at)},
          offset{offset_mesh(surfaces, cutter, {.grid_lines = grid})},
          sections{slice(offset.mesh, planes, {offset.own_triangles})}
    {
        for (const PlaneSection& section : sections) {
            trimmed.push_back(envelope_trimming(section.curves, {}));
            // Not over the border, where the offset stands upright in the end.
            trimmed.back().curves = clipped(trimmed.back().curves, {-15, 15});
        }
    }

    SectionSource source() const
    {
        return {surfaces, offset, grid_lines, planes, sections};
    }
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

TEST(RefinedPlanes, FindTheCrossingOfTheInclinedTroughWhateverTheGrid)
{
    // Acceptance A3; the sampled crossing is off by 5e-3 and 2e-3 mm on these grids.
    const double crossing =
        radius * radius / (2 * p) + p / (2 * std::cos(beta) * std::cos(beta));
    for (const int grid_lines : {51, 101}) {
        const Sections sections = trough(grid_lines);
        const RefinedPlanes refined = refine_planes(sections.source(), sections.trimmed);
        const auto& points = refined.curves[0].front().points;
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
    for (std::size_t k = 0; k < refined.curves.size(); ++k)
        for (const TrimmedCurve& curve : refined.curves[k])
            for (const TrimmedPoint& point : curve.points)
                places.push_back(sections.planes.frame.point(
                    point.at.x(), sections.planes.positions[k], point.at.y()));
    ASSERT_GT(places.size(), 40U);
    constexpr double resolution = 1e-7;
    EXPECT_GE(least_gap(sections.surfaces, sections.cutter, places, resolution)->gap,
              -1e-8);
    // Each on its own, so that none hangs above the part either.
    for (std::size_t k = 0; k < places.size(); k += 7)
        EXPECT_NEAR(
            least_gap(sections.surfaces, sections.cutter, {&places[k], 1}, resolution)
                ->gap,
            0, 2 * resolution);
}

TEST(RefinedPlanes, TellTheErrorOfTheSampling)
{
    // Of second order in the pitch: 16 times less at a quarter of it.
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
        for (const auto& curves :
             refine_planes(sections.source(), sections.trimmed).curves)
            for (const TrimmedCurve& curve : curves)
                for (const TrimmedPoint& point : curve.points)
                    all.push_back(point.at.y());
    }
    EXPECT_EQ(heights[0], heights[1]);
}

TEST(RefinedPlanes, KeepLevelPlacesOfAFlatCutterAsSampled)
{
    const Sections level{
        {test::plane(20, 10)}, Cutter::flat(2), 11, {DriveFrame{Angle::degrees(0)}, {5}}};
    const RefinedPlanes refined = refine_planes(level.source(), level.trimmed);
    EXPECT_GT(refined.unrefined, 0U);
    for (const TrimmedPoint& point : refined.curves[0].front().points)
        EXPECT_LE(point.at.y(), 0.0);
}

TEST(RefinedPlanes, RefuseAnotherNumberOfPlanes)
{
    const Sections sections = trough(21);
    EXPECT_THROW(refine_planes(sections.source(), std::span{sections.trimmed}.first(1)),
                 DomainError);
}

}  // namespace
}  // namespace endmill
