// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/move_contacts.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "pass_examples.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;

// A ball that rolls along x over z = bend x^2 / 2 at y = 4, in `count` equal moves.
ToolPath rolled(double bend, int count)
{
    ToolPath path;
    for (int i = 0; i <= count; ++i) {
        const double x = -15 + 30.0 * i / count;
        const Vec3 normal = Vec3{-bend * x, 0, 1}.normalized();
        const Vec3 point{x, 4, bend * x * x / 2};
        path.points.push_back(
            {0,
             i,
             i == 0 ? Move::Plunge : Move::Cut,
             0,
             {point + radius * normal - radius * Vec3::UnitZ(), Vec3::UnitZ()},
             SurfaceContact{0, 0, {point, normal}}});
    }
    return path;
}

std::vector<std::optional<MoveContact>> stated_contacts(const ToolPath& path,
                                                        std::span<const CutMove> moves)
{
    std::vector<std::optional<MoveContact>> contacts;
    for (const CutMove& move : moves)
        contacts.push_back(stated_contact(path, move));
    return contacts;
}

TEST(MoveContacts, StatedAtBothEndsAreHalfwayBetween)
{
    ToolPath path = rolled(-0.02, 10);
    const auto moves = cut_moves(path);
    const auto contacts = stated_contacts(path, moves);
    EXPECT_LT((contacts[2]->normal - (path.points[2].contact()->contact.normal +
                                      path.points[3].contact()->contact.normal)
                                         .normalized())
                  .norm(),
              1e-14);
    EXPECT_FALSE(contacts[2]->foot);
    path.points[3].known_contact = {};
    const auto fewer = stated_contacts(path, moves);
    EXPECT_FALSE(fewer[2]);
    EXPECT_FALSE(fewer[3]);
    EXPECT_TRUE(fewer[4]);
}

// On short moves the contact in the middle is halfway between the ends, to second order.
TEST(MoveContacts, ProjectedOnThePartAreWhereTheBallRolls)
{
    const double bend = -0.02;
    const std::vector<Surface> part{test::parabolic_cylinder(bend, 20, 10, {2, 1})};
    const ContactSearch search{part};
    ToolPath path = rolled(bend, 600);
    for (PathPoint& point : path.points)
        point.known_contact = {};
    const auto moves = cut_moves(path);
    const auto contacts = projected_contacts(path, moves, search, {radius, 0.05});
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const double x = -15 + 30.0 * (i + 0.5) / 600;
        EXPECT_NEAR(contacts[i]->foot->point.x(), x, 1e-5);
        EXPECT_LT((contacts[i]->normal - Vec3{-bend * x, 0, 1}.normalized()).norm(),
                  1e-5);
    }
}

TEST(MoveContacts, AreTheSameWithAnyNumberOfThreads)
{
    const std::vector<Surface> part{test::parabolic_cylinder(-0.02, 20, 10, {2, 1})};
    const ContactSearch search{part};
    const ToolPath path = rolled(-0.02, 500);
    const auto moves = cut_moves(path);
    set_thread_count(1);
    const auto one = projected_contacts(path, moves, search, {radius, 0.05});
    set_thread_count(4);
    const auto four = projected_contacts(path, moves, search, {radius, 0.05});
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i]->foot->point, four[i]->foot->point);
    }
}

TEST(MoveContacts, RefuseAPathThatMissesThePartAndNameTheWorstPlace)
{
    const std::vector<Surface> part{test::plane(40, 10)};
    const ContactSearch search{part};
    ToolPath path = passes({{Vec3{2, 5, 0.01}, Vec3{38, 5, 0.01}}}, 6);
    EXPECT_NO_THROW(projected_contacts(path, cut_moves(path), search, {radius, 0.05}));
    path.points[4].location.tip.z() = 0.75;
    try {
        projected_contacts(path, cut_moves(path), search, {radius, 0.05});
        ADD_FAILURE() << "expected a GeometryError";
    } catch (const GeometryError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find("misses it by 0.75 mm at point 4 of pass 0"),
                  std::string::npos)
            << what;
    }
    path.points[2].location.tip.z() = -2;
    try {
        projected_contacts(path, cut_moves(path), search, {radius, 0.05});
        ADD_FAILURE() << "expected a GeometryError";
    } catch (const GeometryError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find("reaches into it by 2 mm at point 2"), std::string::npos)
            << what;
    }
}

// The contact lies on the normal through the centre, so normals state the same contacts.
TEST(MoveContacts, StatedByNormalsAloneEqualWholeContacts)
{
    const ToolPath whole = rolled(-0.02, 10);
    ToolPath bare = whole;
    for (PathPoint& point : bare.points) {
        const Vec3 normal = *point.normal();
        point.known_contact = normal;
    }
    const auto moves = cut_moves(whole);
    const auto stated = stated_contacts(whole, moves);
    const auto by_normals = stated_contacts(bare, moves);
    for (std::size_t i = 0; i < moves.size(); ++i) {
        ASSERT_TRUE(by_normals[i]);
        EXPECT_EQ(by_normals[i]->normal, stated[i]->normal);
    }
    bare.points[3].known_contact = {};
    EXPECT_FALSE(stated_contacts(bare, moves)[2]);
    EXPECT_TRUE(stated_contacts(bare, moves)[4]);
}

TEST(MoveContacts, RefuseContactsOfAnotherBall)
{
    const ToolPath path = rolled(-0.02, 10);
    const auto moves = cut_moves(path);
    EXPECT_NO_THROW(require_ball(path, moves, {radius, 1e-9}));
    try {
        require_ball(path, moves, {4, 0.05});
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string{error.what()}.find("ball:8"), std::string::npos);
        EXPECT_NE(std::string{error.what()}.find("point 0 of pass 0"), std::string::npos);
    }
    EXPECT_NO_THROW(require_ball({}, {}, {4, 0.05}));
}

}  // namespace
}  // namespace endmill
