// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/mesh_sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "test_meshes.h"

namespace endmill {
namespace {

const std::array cutters{Cutter::ball(2), Cutter::flat(2), Cutter{2, 0.5}};
const DrivePlanes along_x{DriveFrame{Angle::degrees(0)}, {5}};

// A plate from 0 to 20, 10 wide, with the given heights along x.
template <typename Height>
TriangleMesh plate(int cells, const Height& height)
{
    return test::grid_mesh(cells, 1, [&](double i, double j) {
        const double x = 20 * i / cells;
        return Vec3{x, 10 * j, height(x)};
    });
}

TEST(MeshSections, AreALevelLineOverAPlane)
{
    const TriangleMesh mesh = plate(2, [](double) { return 3.0; });
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        const auto sections = mesh_sections(drop_cutter, along_x, {.samples = 5});
        ASSERT_EQ(sections.size(), 1U);
        ASSERT_EQ(sections[0].size(), 1U);
        const auto& points = sections[0][0].points;
        ASSERT_EQ(points.size(), 5U);
        EXPECT_FALSE(sections[0][0].is_closed);
        for (int k = 0; k < 5; ++k) {
            EXPECT_NEAR(points[k].x(), 5 * k, 1e-12);
            EXPECT_NEAR(points[k].y(), 3 + cutter.corner_radius(), 1e-9);
        }
    }
}

// s and t turn with the feed: the section of a slope z = y / 2 by oblique planes.
TEST(MeshSections, FollowTheFeed)
{
    const TriangleMesh mesh = test::grid_mesh(1, 1, [](double i, double j) {
        return Vec3{100 * i - 50, 100 * j - 50, 50 * j};
    });
    const DropCutter drop_cutter{mesh, Cutter::ball(2)};
    const DriveFrame frame{Angle::radians(std::atan2(-0.8, 0.6))};
    const auto sections =
        mesh_sections(drop_cutter, DrivePlanes{frame, {3}}, {.samples = 50});
    ASSERT_EQ(sections[0].size(), 1U);
    for (const SectionPoint& point : sections[0][0].points) {
        const double y = -0.8 * point.x() + 3 * 0.6;
        if (std::abs(y) < 20 && std::abs(0.6 * point.x() + 3 * 0.8) < 20) {
            EXPECT_NEAR(point.y(), 25 + y / 2 + 2 * std::sqrt(1.25), 1e-9);
        }
    }
}

// Whether the cutter is free at this height over a position no farther than the
// tolerance. Then it goes no deeper into the mesh than the tolerance.
bool is_free_nearby(const DropCutter& drop_cutter, double end, const SectionPoint& at,
                    double tolerance)
{
    const auto found = drop_cutter.contact({end, along_x.positions[0]});
    const double tip = at.y() - drop_cutter.cutter().corner_radius();
    return std::abs(end - at.x()) <= tolerance && found && found->tip_z <= tip + 1e-9;
}

void expect_no_chord_gouges(const DropCutter& drop_cutter,
                            const std::vector<SectionCurve>& curves, double tolerance)
{
    const double r = drop_cutter.cutter().corner_radius();
    for (const SectionCurve& curve : curves)
        for (std::size_t k = 1; k < curve.points.size(); ++k)
            for (const double share : {0.1, 0.37, 0.5, 0.8}) {
                const SectionPoint at =
                    curve.points[k - 1] + share * (curve.points[k] - curve.points[k - 1]);
                const auto found = drop_cutter.contact({at.x(), along_x.positions[0]});
                if (found && found->tip_z > at.y() - r + tolerance) {
                    EXPECT_TRUE(
                        is_free_nearby(drop_cutter, curve.points[k - 1].x(), at,
                                       tolerance) ||
                        is_free_nearby(drop_cutter, curve.points[k].x(), at, tolerance));
                }
            }
}

TEST(MeshSections, AreHalvedUntilNoChordGouges)
{
    const auto ridges = plate(40, [](double x) { return 2 * std::abs(std::sin(x)); });
    const auto step = test::both(plate(1, [](double) { return 0.0; }),
                                 test::box_mesh({8.03, 0, 0}, {12.01, 10, 5}));
    for (const TriangleMesh& mesh : std::array{ridges, step})
        for (const Cutter& cutter : cutters) {
            const DropCutter drop_cutter{mesh, cutter};
            const auto sections =
                mesh_sections(drop_cutter, along_x, {.samples = 8, .tolerance = 0.01});
            ASSERT_EQ(sections[0].size(), 1U);
            EXPECT_GT(sections[0][0].points.size(), 16U);
            expect_no_chord_gouges(drop_cutter, sections[0], 0.01);
        }
}

// Islands from 0 to 5 and from 15 to 20. The rim of the cutter leaves the first one at 7.
TEST(MeshSections, BreakAtTheBorderOfTheMesh)
{
    const TriangleMesh mesh = test::both(test::box_mesh({0, 0, 0}, {5, 10, 1}),
                                         test::box_mesh({15, 0, 0}, {20, 10, 1}));
    for (const Cutter& cutter : cutters) {
        const DropCutter drop_cutter{mesh, cutter};
        const auto sections = mesh_sections(drop_cutter, along_x);
        ASSERT_EQ(sections[0].size(), 2U);
        EXPECT_NEAR(sections[0][0].points.back().x(), 7, 0.01);
        EXPECT_NEAR(sections[0][1].points.front().x(), 13, 0.01);
        for (const SectionCurve& curve : sections[0])
            for (std::size_t k = 1; k < curve.points.size(); ++k)
                EXPECT_LT(curve.points[k - 1].x(), curve.points[k].x());
    }
}

TEST(MeshSections, AreEmptyBesideTheMesh)
{
    const TriangleMesh mesh = test::flat_mesh(2, 2);
    const DrivePlanes far{along_x.frame, {50}};
    EXPECT_TRUE(mesh_sections(DropCutter{mesh, cutters[0]}, far)[0].empty());
    const TriangleMesh empty;
    EXPECT_TRUE(mesh_sections(DropCutter{empty, cutters[0]}, far)[0].empty());
    EXPECT_TRUE(mesh_sections(DropCutter{mesh, cutters[0]}, {far.frame, {}}).empty());
}

TEST(MeshSections, DoNotDependOnThreads)
{
    const TriangleMesh mesh = plate(40, [](double x) { return std::sin(3 * x); });
    DrivePlanes planes{DriveFrame{Angle::radians(0.3)}, {}};
    for (int k = 0; k < 20; ++k)
        planes.positions.push_back(0.4 * k);
    const DropCutter drop_cutter{mesh, cutters[2]};
    set_thread_count(1);
    const auto alone = mesh_sections(drop_cutter, planes, {.samples = 30});
    set_thread_count(4);
    const auto together = mesh_sections(drop_cutter, planes, {.samples = 30});
    for (std::size_t k = 0; k < alone.size(); ++k) {
        ASSERT_EQ(alone[k].size(), together[k].size());
        for (std::size_t curve = 0; curve < alone[k].size(); ++curve)
            EXPECT_EQ(alone[k][curve].points, together[k][curve].points);
    }
}

TEST(MeshSections, RefuseInvalidOptions)
{
    const TriangleMesh mesh = test::flat_mesh(2, 2);
    const DropCutter drop_cutter{mesh, cutters[0]};
    const auto run = [&](const DrivePlanes& planes, const MeshSectionOptions& options) {
        mesh_sections(drop_cutter, planes, options);
    };
    EXPECT_THROW(run(along_x, {.samples = 1}), DomainError);
    EXPECT_THROW(run(along_x, {.tolerance = 0}), DomainError);
    EXPECT_THROW(run({along_x.frame, {0, std::nan("")}}, {}), DomainError);
}

// A V-groove of slope 3/4: the centre of a ball runs 5/4 R above each flank, with a corner over
// the bottom line at x = 7. Chords across the corner lie above it.
TEST(MeshSections, KeepTheOuterToleranceInAGroove)
{
    const TriangleMesh mesh = plate(20, [](double x) { return 0.75 * std::abs(x - 7); });
    const double R = 2;
    const DropCutter drop_cutter{mesh, Cutter::ball(R)};
    const auto most_above = [&](double outer) {
        MeshSectionOptions options{.samples = 7, .tolerance = 0.01};
        options.outer_tolerance = outer;
        const auto sections = mesh_sections(drop_cutter, along_x, options);
        double most = 0;
        for (const SectionCurve& curve : sections[0])
            for (std::size_t k = 0; k + 1 < curve.points.size(); ++k)
                for (double share = 0; share <= 1; share += 0.0625) {
                    const SectionPoint at =
                        curve.points[k] + share * (curve.points[k + 1] - curve.points[k]);
                    if (at.x() > 2 * R && at.x() < 14 - 2 * R)
                        most = std::max(most,
                                        at.y() - 0.75 * std::abs(at.x() - 7) - 1.25 * R);
                }
        return most;
    };
    EXPECT_GT(most_above(std::numeric_limits<double>::infinity()), 0.1);
    for (const double outer : {0.1, 0.01, 0.001})
        EXPECT_LE(most_above(outer), outer + 0.75 * 0.01);
    EXPECT_THROW(
        mesh_sections(drop_cutter, along_x, {.samples = 7, .outer_tolerance = 0}),
        DomainError);
}

}  // namespace
}  // namespace endmill
