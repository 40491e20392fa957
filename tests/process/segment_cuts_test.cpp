// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/segment_cuts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/surface/nurbs.h"
#include "pass_examples.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

SegmentCutOptions by_passes()
{
    return {.radius = 5, .stock_top = 20, .source = CutSource::Passes};
}

// Two passes on a plane that rises by `slope` across the feed and by `climb` along it.
// The second pass is on the given side of the first.
TEST(SegmentCuts, OfParallelPassesOnAPlaneHaveTheGeometryOfItsPickFeed)
{
    for (const double slope : {0.0, 0.4, -0.7})
        for (const double climb : {0.0, 0.5, -0.9})
            for (const bool to_right : {true, false}) {
                // The feed, and its horizontal normal on the side of the stock.
                const Vec3 feed{std::cos(climb), 0, std::sin(climb)};
                const Vec3 y{0, to_right ? -1.0 : 1.0, 0};
                const Vec3 e1{-std::sin(climb), 0, std::cos(climb)};
                const Vec3 pick = 1.5 * (std::cos(slope) * y + std::sin(slope) * e1);
                const ToolPath path =
                    passes({{Vec3{0, 0, 0}, feed * 20}, {pick, pick + feed * 20}}, 10);
                const SegmentCuts cuts = segment_cuts(path, by_passes());
                ASSERT_EQ(cuts.cuts.size(), 20u);
                EXPECT_EQ(cuts.cuts[3].previous, PreviousPass::None);
                const SegmentCut& cut = cuts.cuts[15];
                EXPECT_EQ(cut.previous, PreviousPass::Beside);
                EXPECT_EQ(cut.milling, to_right ? Milling::Down : Milling::Up);
                EXPECT_NEAR(cut.mu.value(), slope, 1e-12);
                EXPECT_NEAR(cut.lambda, climb, 1e-12);
                EXPECT_NEAR(cut.pick_feed_mm.value(), 1.5, 1e-12);
                EXPECT_NEAR(cut.pick_feed_horizontal_mm.value(), 1.5 * std::cos(slope),
                            1e-12);
                EXPECT_NEAR(cut.length_mm, 2, 1e-12);
                EXPECT_NEAR(cut.depth_mm, 20 - (pick + feed * 11).z(), 1e-12);
            }
}

// Passes of a ball along a cylinder of radius 30, 4 degrees apart. By eq. (13) f_p = d (1
// + r0 k), where d is the chord between the contacts. The slope is that of the surface
// half a step before.
TEST(SegmentCuts, AlongACylinderHaveThePickFeedOfTheSurfaceAndItsSlopeHalfAStepBack)
{
    const double radius = 5;
    const double step = 4 * std::numbers::pi / 180;
    for (const double curvature : {1 / 30.0, -1 / 30.0}) {
        const double reach =
            1 / curvature + radius;  // radius of the ball centres; negative: concave
        std::vector<Pass> lines;
        // Towards the right of the feed, -y.
        for (int k = -8; k <= 8; ++k) {
            const double turn = -k * step;
            const Vec3 centre =
                std::abs(reach) *
                Vec3{0, std::sin(turn), (curvature > 0 ? 1 : -1) * std::cos(turn)};
            lines.push_back({centre, centre + 40 * Vec3::UnitX()});
        }
        const SegmentCuts cuts = segment_cuts(passes(lines, 4), by_passes());
        for (int k = -7; k <= 8; ++k) {
            const SegmentCut& cut = cuts.cuts[static_cast<std::size_t>(k + 8) * 4 + 1];
            const double contacts = 2 * 30 * std::sin(step / 2);
            EXPECT_NEAR(cut.pick_feed_mm.value(), contacts * (1 + radius * curvature),
                        1e-11);
            // The pick feed descends where the normal leans towards the stock.
            const double surface = (curvature > 0 ? -1 : 1) * k * step;
            const double half = (curvature > 0 ? 1 : -1) * step / 2;
            EXPECT_NEAR(cut.mu.value(), surface + half, 1e-11);
            EXPECT_EQ(cut.milling, Milling::Down);
        }
    }
}

// By contact, on a real cylinder: d and k come from the surface, so f_p equals the
// distance of the centres, and mu is the slope of the surface at the contact.
TEST(SegmentCuts, ByContactOnACylinderHaveItsSlopeAndTheSamePickFeed)
{
    const double radius = 5;
    const double step = 4 * std::numbers::pi / 180;
    const std::vector<Surface> part{
        nurbs_surface(test::cylinder(30, 50, 0.7, std::numbers::pi - 0.7))};
    std::vector<Pass> lines;
    for (int k = -8; k <= 8; ++k) {
        const Vec3 centre = 35 * Vec3{0, -std::sin(k * step), std::cos(k * step)};
        const Vec3 tip = centre - radius * Vec3::UnitZ();
        lines.push_back({tip + 5 * Vec3::UnitX(), tip + 45 * Vec3::UnitX()});
    }
    SegmentCutOptions options = by_passes();
    options.source = CutSource::Contact;
    options.part = part;
    const SegmentCuts cuts = segment_cuts(passes(lines, 4), options);
    EXPECT_EQ(cuts.by_contact, cuts.cuts.size());
    for (int k = -7; k <= 8; ++k) {
        const SegmentCut& cut = cuts.cuts[static_cast<std::size_t>(k + 8) * 4 + 1];
        EXPECT_NEAR(cut.mu.value(), -k * step, 1e-9);
        EXPECT_NEAR(cut.pick_feed_mm.value(), 2 * 35 * std::sin(step / 2), 1e-9);
        EXPECT_NEAR(cut.pick_feed_horizontal_mm.value(),
                    cut.pick_feed_mm.value() * std::cos(cut.mu.value()), 1e-12);
    }
}

// The tip of a ball of 5 mm that touches a part with this normal at `point`.
SurfaceContact touched(const PathPoint& point, const Vec3& normal)
{
    const Vec3 centre = point.location.tip + 5 * Vec3::UnitZ();
    return {0, 0, {centre - 5 * normal, normal}};
}

// Eq. (10) and (11) on a tilted plane, milled in both senses, from the normals of the
// path alone.
TEST(SegmentCuts, ByStatedContactsOnAPlaneEqualThoseByPasses)
{
    const Vec3 normal = Vec3{-0.3, 0.4, 1}.normalized();
    const Vec3 feed = Vec3{1, 0.2, 0.3 - 0.4 * 0.2}.normalized();
    for (const double side : {1.0, -1.0}) {
        const Vec3 pick = 1.2 * side * feed.cross(normal);
        ToolPath path = passes({{Vec3::Zero(), 20 * feed}, {pick, pick + 20 * feed}}, 5);
        const SegmentCuts by_path = segment_cuts(path, by_passes());
        for (PathPoint& point : path.points)
            point.known_contact = touched(point, normal);
        SegmentCutOptions options = by_passes();
        options.source = CutSource::Auto;
        const SegmentCuts by_normals = segment_cuts(path, options);
        EXPECT_EQ(by_normals.by_contact, 10u);
        EXPECT_EQ(by_path.by_passes, 10u);
        const SegmentCut& one = by_path.cuts[7];
        const SegmentCut& other = by_normals.cuts[7];
        EXPECT_EQ(one.milling, side > 0 ? Milling::Down : Milling::Up);
        EXPECT_EQ(one.milling, other.milling);
        EXPECT_NEAR(one.mu.value(), other.mu.value(), 1e-12);
        EXPECT_NEAR(one.pick_feed_mm.value(), other.pick_feed_mm.value(), 1e-12);
        EXPECT_NEAR(one.pick_feed_horizontal_mm.value(),
                    other.pick_feed_horizontal_mm.value(), 1e-12);
    }
}

TEST(SegmentCuts, TakeThePassesWhereAnEndHasNoContact)
{
    ToolPath path = passes({{Vec3{0, 0, 0}, Vec3{20, 0, 0}}}, 5);
    for (std::size_t i = 0; i < 4; ++i)
        path.points[i].known_contact = touched(path.points[i], Vec3::UnitZ());
    SegmentCutOptions options = by_passes();
    options.source = CutSource::Auto;
    const SegmentCuts cuts = segment_cuts(path, options);
    EXPECT_EQ(cuts.by_contact, 3u);
    EXPECT_EQ(cuts.by_passes, 2u);
}

TEST(SegmentCuts, CountTheNearerOfTwoNeighboursAndNoteIt)
{
    const ToolPath path = passes({{Vec3{0, 0, 0}, Vec3{20, 0, 0}},
                                  {Vec3{0, 5, 0}, Vec3{20, 5, 0}},
                                  {Vec3{0, 3, 0}, Vec3{20, 3, 0}}},
                                 2);
    const SegmentCuts cuts = segment_cuts(path, by_passes());
    EXPECT_FALSE(cuts.cuts[2].has_two_neighbours);
    EXPECT_TRUE(cuts.cuts[4].has_two_neighbours);
    EXPECT_NEAR(cuts.cuts[4].pick_feed_mm.value(), 2, 1e-12);
    EXPECT_EQ(cuts.cuts[4].milling, Milling::Down);  // the pass at y = 5 lies to the left
}

TEST(SegmentCuts, OfAFirstPassHaveTheKindOfTheOptions)
{
    SegmentCutOptions options = by_passes();
    options.first_pass = PreviousPass::Edge;
    const ToolPath path = passes({{Vec3{0, 0, 0}, Vec3{20, 0, 0}}}, 2);
    const SegmentCut cut = segment_cuts(path, options).cuts.front();
    EXPECT_EQ(cut.previous, PreviousPass::Edge);
    EXPECT_FALSE(cut.pick_feed_mm);
    EXPECT_FALSE(cut.mu);
}

TEST(SegmentCuts, LeaveOutMovesOfLengthZeroAndVerticalMoves)
{
    ToolPath path = passes({{Vec3{0, 0, 0}, Vec3{20, 0, 0}}}, 1);
    for (const Vec3& tip : {Vec3{20, 0, 0}, Vec3{20, 0, -3}, Vec3{25, 0, -3}})
        path.points.push_back({0,
                               static_cast<int>(path.points.size()),
                               Move::Cut,
                               0,
                               {tip, Vec3::UnitZ()}});
    const SegmentCuts cuts = segment_cuts(path, by_passes());
    ASSERT_EQ(cuts.cuts.size(), 2u);
    EXPECT_EQ(cuts.points[1], path.points.size() - 1);
}

TEST(SegmentCuts, OfAnEmptyPathAreEmpty)
{
    EXPECT_TRUE(segment_cuts({}, by_passes()).cuts.empty());
    EXPECT_TRUE(segment_cuts(passes({{Vec3::Zero(), Vec3::UnitX()}}, 1), by_passes())
                    .cuts.size() == 1);
}

TEST(SegmentCuts, RefuseOptionsOutOfTheirRanges)
{
    const ToolPath path = passes({{Vec3{0, 0, 0}, Vec3{20, 0, 0}}}, 1);
    SegmentCutOptions options = by_passes();
    options.radius = 0;
    EXPECT_THROW(segment_cuts(path, options), DomainError);
    options = by_passes();
    options.stock_top = std::nan("");
    EXPECT_THROW(segment_cuts(path, options), DomainError);
    options = by_passes();
    options.first_pass = PreviousPass::Beside;
    EXPECT_THROW(segment_cuts(path, options), DomainError);
    options = by_passes();
    options.source = CutSource::Contact;
    EXPECT_THROW(segment_cuts(path, options), GeometryError);
    ToolPath leaning = path;
    leaning.points[1].location.axis = Vec3{0, 0.1, 1}.normalized();
    EXPECT_THROW(segment_cuts(leaning, by_passes()), GeometryError);
}

// The nearest pass of a cut is searched in the whole path, so the cuts do not depend on the
// block in which they are asked for.
TEST(SegmentCutFinder, HasTheCutsOfThePathInBlocksOfAnySize)
{
    std::vector<Pass> lines;
    for (int k = 0; k < 6; ++k)
        lines.push_back({Vec3{0, 1.5 * k, 0.1 * k}, Vec3{20, 1.5 * k, 0.2 * k}});
    const ToolPath path = passes(lines, 7);
    const SegmentCuts whole = segment_cuts(path, by_passes());
    const SegmentCutFinder finder{path, by_passes()};
    ASSERT_EQ(finder.size(), whole.cuts.size());
    EXPECT_EQ(finder.zero_length(), whole.zero_length);
    EXPECT_TRUE(finder.has_depth());
    for (const std::size_t size : {1, 5, 42})
        for (std::size_t first = 0; first < finder.size(); first += size) {
            const SegmentCuts block =
                finder.cuts(first, std::min(size, finder.size() - first));
            for (std::size_t i = 0; i < block.cuts.size(); ++i) {
                const SegmentCut& cut = whole.cuts[first + i];
                EXPECT_EQ(block.points[i], whole.points[first + i]);
                EXPECT_EQ(block.points[i], finder.point(first + i));
                EXPECT_EQ(block.cuts[i].mu, cut.mu);
                EXPECT_EQ(block.cuts[i].pick_feed_mm, cut.pick_feed_mm);
                EXPECT_EQ(block.cuts[i].depth_mm, cut.depth_mm);
                EXPECT_EQ(block.cuts[i].milling, cut.milling);
            }
        }
}

TEST(SegmentCutFinder, HasNoDepthAboveTheStock)
{
    const ToolPath path = passes({{Vec3{0, 0, 21}, Vec3{9, 0, 21}}}, 3);
    EXPECT_FALSE(SegmentCutFinder(path, by_passes()).has_depth());
}

TEST(MoveSlope, IsThatOfATriangleOfThreeFourFive)
{
    const MoveSlope slope = move_slope({1, 1, 1}, {5, 1, 4}, 10);
    EXPECT_NEAR(slope.lambda, std::atan2(3, 4), 1e-15);
    EXPECT_EQ(slope.depth_mm, 7.5);
}

}  // namespace
}  // namespace endmill
