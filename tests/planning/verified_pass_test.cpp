// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/verified_pass.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double radius = 5;
constexpr double rho = 20;
using std::numbers::pi;

// A surface for passes along u, with the tests of its moves.
struct Planned {
    Planned(const Surface& part, double side, MotionTolerances motion)
        : marched{part, side},
          bounds{marched.surface},
          clear{{&marched.surface, 1},
                {&marched.side, 1},
                BallCutter{radius},
                Vec3::UnitZ(),
                motion.inner},
          cover{marched, bounds, BallCutter{radius}, motion.outer},
          tolerances{motion}
    {
    }

    VerifiedPass pass(double v, std::size_t most_points = 100'000,
                      PatchBorders patch_borders = PatchBorders::Cross) const
    {
        return verified_pass(surface(most_points, patch_borders), v, {});
    }

    VerifiedSurface surface(std::size_t most_points = 100'000,
                            PatchBorders patch_borders = PatchBorders::Cross) const
    {
        return {marched,      clear,         cover,      tolerances,
                Parameter::U, patch_borders, most_points};
    }

    MarchedSurface marched;
    OffsetBounds bounds;
    ClearMoves clear;
    StripCover cover;
    MotionTolerances tolerances;
};

// The cylinder between two angles, for passes across its axis.
Surface across_cylinder(double from, double to)
{
    return transposed(nurbs_surface(test::cylinder(rho, 30, from, to, 2)));
}

// Expects that all steps but the last turn by `angle`, which the closed form allows.
void expect_steps(const VerifiedPass& pass, double angle)
{
    ASSERT_EQ(pass.pieces.size(), 1U);
    const Pass& piece = pass.pieces.front();
    EXPECT_EQ(piece.front().u, 0);
    EXPECT_EQ(piece.back().u, 2);
    for (std::size_t k = 1; k + 1 < piece.size(); ++k) {
        const double turn =
            std::acos(piece[k - 1].contact.normal.dot(piece[k].contact.normal));
        EXPECT_LE(turn, angle * (1 + 1e-9));
        EXPECT_GE(turn, angle * (1 - 3e-3));
    }
}

// Outside, a straight move of the centre gouges by the sagitta of its chord.
TEST(VerifiedPass, OutsideACylinderStepsAsFarAsTheInnerToleranceAllows)
{
    const Surface part = across_cylinder(pi / 6, 5 * pi / 6);
    for (const double inner : {0.005, 0.1}) {
        const Planned planned{part, 1, {inner, 1e-3}};
        ASSERT_GT(contact_at(planned.marched, {1, 0.5}, Parameter::U).contact.normal.z(),
                  0.9);
        expect_steps(planned.pass(0.5), 2 * std::acos(1 - inner / (rho + radius)));
    }
}

// Inside, a straight move leaves its sagitta as remaining material.
TEST(VerifiedPass, InsideACylinderStepsAsFarAsTheOuterToleranceAllows)
{
    const Surface part = across_cylinder(7 * pi / 6, 11 * pi / 6);
    for (const double outer : {0.005, 0.1}) {
        const Planned planned{part, -1, {1e-3, outer}};
        ASSERT_GT(contact_at(planned.marched, {1, 0.5}, Parameter::U).contact.normal.z(),
                  0.9);
        expect_steps(planned.pass(0.5), 2 * std::acos(1 - outer / (rho - radius)));
    }
}

TEST(VerifiedPass, CrossesAPlaneInOneStep)
{
    const Planned planned{test::plane(100, 30, {3, 1}), 1, {0.01, 0.01}};
    const VerifiedPass pass = planned.pass(0.3);
    ASSERT_EQ(pass.pieces.size(), 1U);
    EXPECT_EQ(pass.pieces.front().size(), 2U);
    const VerifiedPass stopped = planned.pass(0.3, 100, PatchBorders::Stop);
    EXPECT_EQ(stopped.pieces.front().size(), 4U);
}

// In a valley of slopes -s and s the ball touches both sides at its lowest place. It may
// move further by the inner tolerance of 0.02 mm, measured towards the other side.
TEST(VerifiedPass, BreaksOffWhereTheBallNoLongerFits)
{
    constexpr double slope = 0.5;
    constexpr double inner = 0.02;
    const Planned planned{test::valley(30, 20, slope), 1, {inner, 0.01}};
    const VerifiedPass pass = planned.pass(0.5);
    ASSERT_EQ(pass.pieces.size(), 2U);
    const double tilt = std::atan(slope);
    const double nearest = radius * std::tan(tilt) - inner / std::sin(2 * tilt);
    const double from_crease = pass.pieces[1].front().contact.point.norm() > 0
                                   ? std::hypot(pass.pieces[1].front().contact.point.x(),
                                                pass.pieces[1].front().contact.point.z())
                                   : 0;
    EXPECT_GE(from_crease, nearest - 1e-6);
    EXPECT_LE(from_crease, nearest + 30.0 / 256);
    EXPECT_LT(pass.pieces[0].back().u, 1);
    EXPECT_EQ(pass.pieces[1].back().u, 2);
}

TEST(VerifiedPass, OnAPoleIsOneContact)
{
    const Planned planned{
        nurbs_surface(test::torus(0, rho, {0, 1.5, 0.5, pi / 2})), 1, {0.01, 0.01}};
    const VerifiedPass pass = planned.pass(1);
    ASSERT_EQ(pass.pieces.size(), 1U);
    ASSERT_EQ(pass.pieces.front().size(), 1U);
    EXPECT_LT((pass.pieces.front().front().contact.point - Vec3{0, 0, rho}).norm(), 1e-9);
    const SweptPass moves = swept(pass, BallCutter{radius});
    ASSERT_EQ(moves.size(), 1U);
    EXPECT_EQ(moves.front().start, moves.front().end);
}

TEST(VerifiedPass, HalvesAStep)
{
    const Planned planned{test::plane(100, 30), 1, {0.01, 0.01}};
    VerifiedPass pass = planned.pass(0.3);
    EXPECT_TRUE(halve_step(pass, 0, planned.surface()));
    ASSERT_EQ(pass.pieces.front().size(), 3U);
    EXPECT_EQ(pass.pieces.front()[1].u, 0.5);
    EXPECT_FALSE(halve_step(pass, 2, planned.surface()));
    EXPECT_EQ(pass.pieces.front().size(), 3U);
}

TEST(VerifiedPass, StopsAtTheMostPoints)
{
    const Planned planned{across_cylinder(pi / 6, 5 * pi / 6), 1, {1e-4, 1e-4}};
    EXPECT_THROW(planned.pass(0.5, 10), LimitError);
}

}  // namespace
}  // namespace endmill
