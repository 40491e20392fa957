// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/scallop_passes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/drop_cutter/mesh_sections.h"
#include "test_meshes.h"

namespace endmill {
namespace {

constexpr double radius = 3;
constexpr double height = 0.1;
// Half the chord of a circle at this height: R^2 - (R - h)^2 = h (2 R - h).
const double level_interval = 2 * std::sqrt(height * (2 * radius - height));
const ScallopLimit limit{.height = height, .level_interval = level_interval};
const PassLimit examined{
    .height = height, .level_interval = level_interval, .samples = 50};

// A plane over [0, 30]^2 that rises across the feed, along y.
TriangleMesh slope(double degrees)
{
    const double rise = std::tan(degrees * std::acos(-1.0) / 180);
    return test::grid_mesh(3, 3, [&](double i, double j) {
        return Vec3{10 * i, 10 * j, 10 * j * rise};
    });
}

DrivePlanes planes_of(const TriangleMesh& mesh)
{
    const DriveFrame frame{Angle::degrees(0)};
    return drive_planes_by_pitch(frame, extent_across(mesh, frame), level_interval);
}

// The greatest distance between neighbouring planes up to `end`.
double widest_gap(const DrivePlanes& planes, double end)
{
    double widest = 0;
    for (std::size_t k = 1; k < planes.positions.size(); ++k)
        if (planes.positions[k] <= end)
            widest = std::max(widest, planes.positions[k] - planes.positions[k - 1]);
    return widest;
}

TEST(ScallopPasses, AddNoneOnLevelGround)
{
    const TriangleMesh mesh = slope(0);
    const DropCutter drop_cutter{mesh, Cutter::ball(radius)};
    EXPECT_TRUE(added_passes(drop_cutter, planes_of(mesh), {0, 30}, examined).empty());
}

// Passes a distance w apart in plan lie w / cos a apart on a plane that slopes by a across the
// feed, and leave the scallop of level passes at this distance.
TEST(ScallopPasses, HoldTheHeightOnSlopes)
{
    for (const double degrees : {10.0, 30.0, 45.0, 60.0, 75.0, 85.0}) {
        const TriangleMesh mesh = slope(degrees);
        const DropCutter drop_cutter{mesh, Cutter::ball(radius)};
        const MeshPasses passes = mesh_passes(drop_cutter, planes_of(mesh), limit);
        const double angle = degrees * std::acos(-1.0) / 180;
        // Above, the contact is at the upper border.
        const double gap = widest_gap(passes.planes, 30 - radius * std::sin(angle));
        const double apart = gap / std::cos(angle);
        const double scallop =
            radius - std::sqrt(std::max(0.0, radius * radius - apart * apart / 4));
        EXPECT_TRUE(gap <= height || scallop <= height * 1.0001) << degrees;
        EXPECT_EQ(passes.added_planes > 0, degrees > 20);
        // no more than halving needs
        EXPECT_GT(2.001 * apart, level_interval) << degrees;
    }
}

// Along the feed the cutter follows any slope.
TEST(ScallopPasses, AddNoneForASlopeAlongTheFeed)
{
    const TriangleMesh mesh = test::grid_mesh(3, 3, [](double i, double j) {
        return Vec3{10 * i, 10 * j, 20 * i};
    });
    const DropCutter drop_cutter{mesh, Cutter::ball(radius)};
    EXPECT_EQ(mesh_passes(drop_cutter, planes_of(mesh), limit).added_planes, 0U);
}

// A valley along the feed. Its sides rise by `degrees` from the line y = `corner`.
TriangleMesh valley(double degrees, double corner)
{
    const double rise = std::tan(degrees * std::acos(-1.0) / 180);
    return test::grid_mesh(3, 2, [&](double i, double j) {
        const double y = j < 1 ? 0 : j < 2 ? corner : 30;
        return Vec3{10 * i, y, rise * std::abs(y - corner)};
    });
}

// The ball in the valley touches both sides at R tan a from the corner. Over every place farther
// up a pass must cut the point at the scallop height. Its centre is R / cos a above the sides.
TEST(ScallopPasses, HoldTheHeightBesideInnerCorners)
{
    for (const double degrees : {3.0, 6.0, 12.0, 25.0, 40.0})
        for (const double corner : {14.0, 14.3, 14.7, 15.1}) {
            const TriangleMesh mesh = valley(degrees, corner);
            const DropCutter drop_cutter{mesh, Cutter::ball(radius)};
            const MeshPasses passes = mesh_passes(drop_cutter, planes_of(mesh), limit);
            const double angle = degrees * std::acos(-1.0) / 180;
            const auto height_of_sides = [&](double y) {
                return std::tan(angle) * std::abs(y - corner);
            };
            double least_uncut = 0;
            for (const double side : {-1.0, 1.0})
                for (double away = radius * std::sin(angle); away < 5; away += 0.01) {
                    const double y = corner + side * away;
                    const Eigen::Vector2d above{
                        y - side * height * std::sin(angle),
                        height_of_sides(y) + height * std::cos(angle)};
                    double nearest = 100;
                    for (const double t : passes.planes.positions) {
                        const Eigen::Vector2d centre{
                            t, height_of_sides(t) + radius / std::cos(angle)};
                        nearest = std::min(nearest, (centre - above).norm());
                    }
                    least_uncut = std::max(least_uncut, nearest - radius);
                }
            EXPECT_LE(least_uncut, 1e-6) << degrees << " degrees, corner at " << corner;
            EXPECT_LE(passes.added_planes, 4U + (degrees > 20 ? 25U : 0U));
        }
}

// A block in the middle of a plate, with walls along the feed. The cutter follows the plate
// up to one radius from the wall; a pass must come within the height of this place.
TEST(ScallopPasses, ComeNearToWallsAlongTheFeed)
{
    const TriangleMesh plate = test::box_mesh({0, 0, -5}, {40, 40, 0});
    const TriangleMesh block = test::box_mesh({10, 17, 0}, {30, 23, 10});
    const TriangleMesh mesh = test::both(plate, block);
    const DropCutter drop_cutter{mesh, Cutter::ball(radius)};
    const MeshPasses passes = mesh_passes(drop_cutter, planes_of(mesh), limit);
    for (const double side : {17 - radius, 23 + radius}) {
        double nearest = 40;
        for (std::size_t k = 0; k < passes.curves.size(); ++k) {
            const double away = side < 20 ? side - passes.planes.positions[k]
                                          : passes.planes.positions[k] - side;
            for (const SectionCurve& curve : passes.curves[k])
                if (curve.points.front().x() < 19 && curve.points.back().x() > 21 &&
                    away >= 0)
                    nearest = std::min(nearest, away);
        }
        EXPECT_LE(nearest, height) << side;
    }
    // Around the upper edges the cutter rolls down one radius, in steps of the height at most.
    EXPECT_LE(static_cast<double>(passes.added_planes), 2 * (radius / (height / 2) + 5));
    // Away from the block the plate is level: added passes do not reach the plate's ends.
    for (std::size_t k = 0; k < passes.curves.size(); ++k)
        for (const SectionCurve& curve : passes.curves[k])
            EXPECT_TRUE(curve.points.front().x() == 0 || curve.points.front().x() > 2);
}

// A ball touches the foot of a slope by a at the border only if its axis is R sin a beyond the
// border.
TEST(ScallopPasses, ReachTheFootOfASlopeBeyondTheBorder)
{
    const double degrees = 40;
    const double beyond = radius * std::sin(degrees * std::acos(-1.0) / 180);
    const TriangleMesh mesh = slope(degrees);
    const DropCutter drop_cutter{mesh, Cutter::ball(radius)};
    MeshSectionOptions options;
    options.beyond_borders = true;
    const MeshPasses passes = mesh_passes(drop_cutter, planes_of(mesh), limit, options);
    // The outermost pass touches the slope so near to its foot that it leaves the height there.
    const double outermost = passes.planes.positions.front();
    const double away =
        std::max(0.0, outermost + beyond) / std::cos(degrees * std::acos(-1.0) / 180);
    EXPECT_LE(radius - std::sqrt(radius * radius - away * away), height);
    EXPECT_LT(outermost, 0);
    EXPECT_GE(outermost, -beyond - level_interval);
    // At the upper border the contact is ahead of the axis.
    EXPECT_LE(passes.planes.positions.back(), 30);

    const TriangleMesh along_feed = test::grid_mesh(3, 3, [](double i, double j) {
        return Vec3{10 * i, 10 * j, 10 * i * std::tan(40 * std::acos(-1.0) / 180)};
    });
    const DropCutter other{along_feed, Cutter::ball(radius)};
    const auto curves =
        mesh_sections(other, DrivePlanes{DriveFrame{Angle::degrees(0)}, {15}}, options);
    EXPECT_NEAR(curves[0][0].points.front().x(), -beyond, options.tolerance);
    EXPECT_EQ(curves[0][0].points.back().x(), 30);
}

// At the ends of its passes a bull-nose cutter rolls off the border of level ground. A pass for
// each pitch is enough there, up to two beyond the borders. Every place, those on the border
// too, is cut to the height by a position of the cutter on a pass.
TEST(ScallopPasses, AreOneForEachPitchOnLevelGroundInEveryDirection)
{
    const TriangleMesh mesh = test::grid_mesh(3, 3, [](double i, double j) {
        return Vec3{20 * i, 15 * j, 0};
    });
    const Cutter bull{5, 1};
    const DropCutter drop_cutter{mesh, bull};
    const double pitch = 2 * (4 + std::sqrt(height * (2 - height)));
    for (const double degrees : {17.0, 45.0, 80.0}) {
        const DriveFrame frame{Angle::degrees(degrees)};
        const Interval across = extent_across(mesh, frame);
        MeshSectionOptions options;
        options.beyond_borders = true;
        const MeshPasses passes =
            mesh_passes(drop_cutter, drive_planes_by_pitch(frame, across, pitch),
                        {.height = height, .level_interval = pitch}, options);
        EXPECT_LE(passes.planes.positions.size(),
                  std::ceil((across.high - across.low) / pitch) + 3);
        // whether the cutter contains a point where it passes it
        const auto cuts = [&](const Vec3& from, const Vec3& to, const Vec3& point) {
            const Vec3 way = to - from;
            const double share = std::clamp(
                (point - from).head<2>().dot(way.head<2>()) / way.head<2>().squaredNorm(),
                0.0, 1.0);
            const Vec3 tip = from + share * way;
            const double away = (point - tip).head<2>().norm();
            return away <= 5 && point.z() >= tip.z() + bull.profile(away);
        };
        for (int i = 0; i <= 60; ++i)
            for (int j = 0; j <= 45; ++j) {
                const Vec3 above{double(i), double(j), height + 1e-9};
                bool is_cut = false;
                for (std::size_t plane = 0; plane < passes.curves.size(); ++plane) {
                    const double position = passes.planes.positions[plane];
                    for (const SectionCurve& curve : passes.curves[plane])
                        for (std::size_t k = 1; k < curve.points.size() && !is_cut; ++k) {
                            const auto& a = curve.points[k - 1];
                            const auto& b = curve.points[k];
                            is_cut = cuts(frame.point(a.x(), position, a.y() - 1),
                                          frame.point(b.x(), position, b.y() - 1), above);
                        }
                }
                EXPECT_TRUE(is_cut) << degrees << ": " << i << ", " << j;
            }
    }
}

TEST(ScallopPasses, DoNotDependOnTheThreads)
{
    const TriangleMesh mesh = slope(50);
    const DropCutter drop_cutter{mesh, Cutter::ball(radius)};
    const DrivePlanes planes = planes_of(mesh);
    set_thread_count(1);
    const auto one = added_passes(drop_cutter, planes, {0, 30}, examined);
    set_thread_count(4);
    const auto four = added_passes(drop_cutter, planes, {0, 30}, examined);
    ASSERT_EQ(one.size(), four.size());
    for (std::size_t k = 0; k < one.size(); ++k)
        EXPECT_EQ(one[k].position, four[k].position);
}

TEST(ScallopPasses, RefuseLimitsOutsideTheirDomain)
{
    const TriangleMesh mesh = slope(0);
    const DropCutter drop_cutter{mesh, Cutter::ball(radius)};
    const DrivePlanes planes = planes_of(mesh);
    for (const PassLimit& wrong :
         {PassLimit{0, 1}, PassLimit{-1, 1}, PassLimit{1, 0},
          PassLimit{.height = 1, .level_interval = 1, .allowance = radius}})
        EXPECT_THROW(added_passes(drop_cutter, planes, {0, 30}, wrong), DomainError);
    DrivePlanes falling = planes;
    std::ranges::reverse(falling.positions);
    EXPECT_THROW(added_passes(drop_cutter, falling, {0, 30}, examined), DomainError);
}

}  // namespace
}  // namespace endmill
