// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/linking.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "planned_path.h"

namespace endmill {
namespace {

constexpr double radius = 5;

// Three passes of three contacts each, on a slope in x, 7 mm apart.
std::vector<Pass> slope_passes()
{
    const Vec3 normal = Vec3{-0.6, 0, 0.8};
    std::vector<Pass> passes;
    for (int j = 0; j < 3; ++j) {
        Pass& pass = passes.emplace_back();
        for (int i = 0; i < 3; ++i)
            pass.push_back({0.5 * i, 1.0 * j, {Vec3{8.0 * i, 7.0 * j, 6.0 * i}, normal}});
    }
    return passes;
}

std::vector<Move> moves_of(const ToolPath& path)
{
    std::vector<Move> moves;
    for (const PathPoint& point : path.points)
        moves.push_back(point.move);
    return moves;
}

TEST(Linking, ZigZagTurnsEveryOtherPassAndLinksThem)
{
    const std::vector<Pass> passes = slope_passes();
    const ToolPath path = link_passes(passes, BallCutter{radius}, {});
    EXPECT_EQ(moves_of(path),
              (std::vector{Move::Plunge, Move::Cut, Move::Cut, Move::Link, Move::Cut,
                           Move::Cut, Move::Link, Move::Cut, Move::Cut}));
    for (int k = 0; k < 9; ++k) {
        const PathPoint& point = path.points[k];
        EXPECT_EQ(point.pass, k / 3);
        EXPECT_EQ(point.point, k % 3);
        const int i = point.pass == 1 ? 2 - k % 3 : k % 3;
        EXPECT_EQ(point.contact()->u, passes[k / 3][i].u);
        EXPECT_EQ(test::contact_point(point), passes[k / 3][i].contact.point);
    }
}

TEST(Linking, NeedsOnePassAtATime)
{
    const BallCutter ball{radius};
    for (const PassOrder order : {PassOrder::ZigZag, PassOrder::OneWay}) {
        const LinkOptions options{order, Vec3::UnitZ(), 40};
        Pass current;  // overwritten by each call
        const auto next = [&current, number = 0]() mutable {
            current = slope_passes()[number++];
            return std::span<const SurfaceContact>{current};
        };
        const ToolPath path = link_passes_one_by_one({3, 9, next}, ball, options);
        EXPECT_TRUE(test::are_equal(path, link_passes(slope_passes(), ball, options)));
    }
}

TEST(Linking, PutsTheBallOnEveryContact)
{
    const Vec3 axis = Vec3{0.2, -0.3, 1}.normalized();
    const ToolPath path =
        link_passes(slope_passes(), BallCutter{radius}, {PassOrder::ZigZag, axis, 0});
    for (const PathPoint& point : path.points) {
        const Vec3 centre = point.location.tip + radius * axis;
        EXPECT_NEAR((centre - test::contact_point(point)).norm(), radius, 1e-14);
        EXPECT_EQ(point.location.axis, axis);
    }
}

TEST(Linking, OneWayLiftsMovesAndLowersBetweenPasses)
{
    const std::vector<Pass> passes = slope_passes();
    const Vec3 axis = Vec3{0, 0.6, 0.8};
    const ToolPath path =
        link_passes(passes, BallCutter{radius}, {PassOrder::OneWay, axis, 40});
    const std::vector<Move> expected{
        Move::Plunge, Move::Cut, Move::Cut, Move::Retract, Move::Rapid,
        Move::Plunge, Move::Cut, Move::Cut, Move::Retract, Move::Rapid,
        Move::Plunge, Move::Cut, Move::Cut};
    ASSERT_EQ(moves_of(path), expected);
    for (const int retract : {3, 8}) {
        const Vec3 last = path.points[retract - 1].location.tip;
        const Vec3 up = path.points[retract].location.tip;
        const Vec3 over = path.points[retract + 1].location.tip;
        const Vec3 next = path.points[retract + 2].location.tip;
        EXPECT_NEAR(up.dot(axis), 40, 1e-13);
        EXPECT_NEAR(over.dot(axis), 40, 1e-13);
        EXPECT_LT((up - last).cross(axis).norm(), 1e-13) << "straight up the axis";
        EXPECT_LT((over - next).cross(axis).norm(), 1e-13) << "straight down the axis";
        EXPECT_FALSE(path.points[retract].contact());
        EXPECT_FALSE(path.points[retract + 1].contact());
    }
    for (const auto& pass : test::passes_of(path)) {
        EXPECT_EQ(pass.front().contact()->u, 0) << "all forwards";
        EXPECT_EQ(pass.back().contact()->u, 1);
    }
}

TEST(Linking, NumbersThePointsOfEveryPassFromZero)
{
    const ToolPath path = link_passes(slope_passes(), BallCutter{radius},
                                      {PassOrder::OneWay, Vec3::UnitZ(), 40});
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const bool is_first = path.points[k].pass != path.points[k - 1].pass;
        EXPECT_EQ(path.points[k].point, is_first ? 0 : path.points[k - 1].point + 1);
    }
}

TEST(Linking, OfPassesOfOnePointTurnsThemToo)
{
    std::vector<Pass> passes = slope_passes();
    for (Pass& pass : passes)
        pass.resize(1);
    EXPECT_EQ(moves_of(link_passes(passes, BallCutter{radius}, {})),
              (std::vector{Move::Plunge, Move::Link, Move::Link}));
    EXPECT_EQ(
        link_passes(passes, BallCutter{radius}, {PassOrder::OneWay, Vec3::UnitZ(), 40})
            .points.size(),
        7U);
}

TEST(Linking, OfNoPassIsAnEmptyPath)
{
    for (const PassOrder order : {PassOrder::ZigZag, PassOrder::OneWay})
        EXPECT_TRUE(link_passes({}, BallCutter{radius}, {order}).points.empty());
}

TEST(Linking, RefusesASafeHeightBelowThePath)
{
    // The highest tip is at 12 + R (0.8 - 1) = 11 mm.
    const auto lifted_to = [](double height) {
        return link_passes(slope_passes(), BallCutter{radius},
                           {PassOrder::OneWay, Vec3::UnitZ(), height});
    };
    EXPECT_NO_THROW(lifted_to(11.001));
    EXPECT_THROW(lifted_to(10.999), GeometryError);
    EXPECT_NO_THROW(link_passes(slope_passes(), BallCutter{radius},
                                {PassOrder::ZigZag, Vec3::UnitZ(), -1000}))
        << "zigzag is never lifted";
}

TEST(Linking, RefusesAContactThatTheBallCannotTouch)
{
    EXPECT_THROW(link_passes(slope_passes(), BallCutter{radius},
                             {PassOrder::ZigZag, Vec3{0.8, 0, 0.6}, 0}),
                 GeometryError)
        << "normal . axis = 0";
    EXPECT_THROW(link_passes(slope_passes(), BallCutter{radius},
                             {PassOrder::ZigZag, -Vec3::UnitZ(), 0}),
                 GeometryError);
}

TEST(Linking, PathsOverSeveralSurfacesAreJoinedByLifts)
{
    const LinkOptions options{PassOrder::ZigZag, Vec3::UnitZ(), 50};
    const ToolPath path = link_passes(slope_passes(), BallCutter{radius}, options);
    const ToolPath joined = join_paths(std::vector{path, ToolPath{}, path}, options);
    ASSERT_EQ(joined.points.size(), 2 * path.points.size() + 2);
    const auto second = path.points.size();
    const PathPoint& retract = joined.points[second];
    const PathPoint& rapid = joined.points[second + 1];
    const PathPoint& plunge = joined.points[second + 2];
    EXPECT_EQ(retract.move, Move::Retract);
    EXPECT_EQ(rapid.move, Move::Rapid);
    EXPECT_EQ(plunge.move, Move::Plunge);
    EXPECT_EQ(retract.location.tip.z(), 50);
    EXPECT_EQ(retract.location.tip.head<2>(), path.points.back().location.tip.head<2>());
    EXPECT_EQ(rapid.location.tip.head<2>(), path.points.front().location.tip.head<2>());
    EXPECT_EQ(plunge.location.tip, path.points.front().location.tip);
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(joined.points[second + k].pass, 3);
        EXPECT_EQ(joined.points[second + k].point, k);
        EXPECT_EQ(joined.points[second + k].patch, 2);
    }
    EXPECT_EQ(joined.points.back().pass, 5);
    EXPECT_EQ(joined.points.back().point, 2);
    EXPECT_EQ(joined.points.front().patch, 0);
    EXPECT_THROW(
        join_paths(std::vector{path, path}, {PassOrder::ZigZag, Vec3::UnitZ(), 1}),
        GeometryError);
}

TEST(Linking, LiftsBetweenPiecesWhereTheLinkIsNotClear)
{
    const std::vector<Pass> passes = slope_passes();
    const std::vector<PassPiece> pieces{{0, passes[0]}, {0, passes[1]}, {1, passes[2]}};
    LinkOptions options;
    options.safe_height = 50;
    const auto from_first = [](const Vec3& from, const Vec3&) { return from.y() < 1; };
    const auto [path, lifted_links, arched_links] =
        link_pieces(pieces, BallCutter{radius}, options, from_first);
    EXPECT_EQ(lifted_links, 1U);
    EXPECT_EQ(arched_links, 0U);
    EXPECT_EQ(
        moves_of(path),
        (std::vector{Move::Plunge, Move::Cut, Move::Cut, Move::Link, Move::Cut, Move::Cut,
                     Move::Retract, Move::Rapid, Move::Plunge, Move::Cut, Move::Cut}));
    EXPECT_EQ(path.points[3].pass, 0);
    EXPECT_EQ(path.points[6].pass, 1);
    options.order = PassOrder::OneWay;
    EXPECT_EQ(link_pieces(pieces, BallCutter{radius}, options, from_first).lifted_links,
              0U);
}

// Two contacts on a floor, 8 mm apart, with a wall between them. The tip at the safe height is
// 40 mm above the floor; arches are 5, 10 or 20 mm high.
class ArchOverAWall : public testing::TestWithParam<double> {};

TEST_P(ArchOverAWall, IsAsLowAsItIsClear)
{
    const double wall = GetParam();
    const auto at = [](double x) -> Pass {
        return {{x, 0, {Vec3{x, 0, 0}, Vec3::UnitZ()}}};
    };
    const std::vector<PassPiece> pieces{{0, at(0)}, {1, at(8)}};
    LinkOptions options;
    options.safe_height = 40;
    options.barred = BarredLink::Arched;
    const auto is_clear = [&](const Vec3& from, const Vec3& to) {
        return std::min(from.z(), to.z()) - radius >= wall;
    };
    const LinkedPath linked = link_pieces(pieces, BallCutter{radius}, options, is_clear);
    const std::vector<PathPoint>& points = linked.path.points;
    if (wall > 20) {
        EXPECT_EQ(linked.arched_links, 0U);
        EXPECT_EQ(linked.lifted_links, 1U);
        EXPECT_EQ(moves_of(linked.path),
                  (std::vector{Move::Plunge, Move::Retract, Move::Rapid, Move::Plunge}));
        return;
    }
    EXPECT_EQ(linked.arched_links, 1U);
    EXPECT_EQ(linked.lifted_links, 0U);
    EXPECT_EQ(moves_of(linked.path),
              (std::vector{Move::Plunge, Move::Link, Move::Link, Move::Link}));
    double height = 5;
    while (height < wall)
        height *= 2;
    EXPECT_EQ(points[1].location.tip, Vec3(0, 0, height));
    EXPECT_EQ(points[2].location.tip, Vec3(8, 0, height));
    EXPECT_EQ(points[3].location.tip, Vec3(8, 0, 0));
    EXPECT_EQ(points[1].contact(), nullptr);
    EXPECT_EQ(points[1].pass, 1);
    // 8 mm across are longer than retract and plunge to a safe height of 4 mm
    options.safe_height = 4;
    EXPECT_EQ(link_pieces(pieces, BallCutter{radius}, options, is_clear).arched_links,
              0U);
}

INSTANTIATE_TEST_SUITE_P(LowToHigh, ArchOverAWall, testing::Values(3.0, 7.0, 19.0, 25.0));

}  // namespace
}  // namespace endmill
