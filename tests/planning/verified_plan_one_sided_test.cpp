// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/planning/detail/verified_pass.h"
#include "endmill/planning/path_error.h"
#include "endmill/planning/verified_plan.h"
#include "normal_depth.h"
#include "revolved_surfaces.h"
#include "swept_deviation.h"
#include "test_surfaces.h"

// Plans with a tolerance of 0 on one side. The deviation of each step is measured by
// samples of the line between its contacts, without the bounds of the planner.
namespace endmill {
namespace {

using std::numbers::pi;
constexpr double rounding = 1e-10;  // mm

// Deviation of the lines of all steps from the swept ball, mm along the distance: above 0
// stock remains, below 0 the ball gouges.
struct LineDeviations {
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();
};

LineDeviations line_deviations(const Surface& part, const ToolPath& path, double radius)
{
    constexpr int samples = 200;
    LineDeviations found;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        if (path.points[k].move != Move::Cut)
            continue;
        const SurfaceContact* from = path.points[k - 1].contact();
        const SurfaceContact* to = path.points[k].contact();
        const auto centre = [&](const PathPoint& point) -> Vec3 {
            return point.location.tip + radius * point.location.axis;
        };
        const test::SampledMove move{centre(path.points[k - 1]), centre(path.points[k])};
        for (int i = 0; i <= samples; ++i) {
            const double share = i / double(samples);
            const Vec3 point = part.tangents(std::lerp(from->u, to->u, share),
                                             std::lerp(from->v, to->v, share))
                                   .point;
            const double deviation = test::distance_to(point, move) - radius;
            found.least = std::min(found.least, deviation);
            found.greatest = std::max(found.greatest, deviation);
        }
    }
    return found;
}

VerifiedOptions options_of(const MotionTolerances& tolerances, Parameter direction)
{
    VerifiedOptions options;
    options.direction = direction;
    options.tolerances = tolerances;
    options.scallop_height = 0.1;
    options.link.safe_height = 400;
    return options;
}

// Expects that every step deviates to the allowed side only, that it uses this side, and
// that the whole part keeps the limits.
void expect_one_side(const Surface& part, double radius,
                     const MotionTolerances& tolerances)
{
    const double width = tolerances.inner + tolerances.outer;
    for (const Parameter direction : {Parameter::U, Parameter::V}) {
        const VerifiedPlan plan = plan_verified({&part, 1}, BallCutter{radius},
                                                options_of(tolerances, direction));
        EXPECT_TRUE(plan.uncovered.empty());
        const LineDeviations line = line_deviations(part, plan.path, radius);
        EXPECT_GE(line.least, -tolerances.inner - rounding);
        EXPECT_LE(line.greatest, tolerances.outer + rounding);
        EXPECT_GT(line.greatest - line.least, 0.7 * width);
        const test::SweptDeviation whole = test::swept_deviation(
            {&part, 1}, plan.path, radius, 0.1 + tolerances.outer, 25);
        EXPECT_LE(whole.gouge, tolerances.inner + rounding);
        EXPECT_LE(whole.beyond_height, 1e-9);
        EXPECT_LE(test::border_depth(part, plan.path, radius, 200, 0),
                  tolerances.inner + rounding);
    }
}

TEST(OneSidedPlan, DeviatesToTheAllowedSideOnlyOnASaddle)
{
    expect_one_side(test::saddle(30, 15, {2, 2}), 4, {0, 0.05});
    expect_one_side(test::saddle(30, 15, {2, 2}), 4, {0.05, 0});
}

TEST(OneSidedPlan, DeviatesToTheAllowedSideOnlyOnSurfacesOfRevolution)
{
    const Surface torus = nurbs_surface(test::torus(30, 12, {0, 1.5, 0.4, 2.6, 2}));
    expect_one_side(torus, 4, {0, 0.1});
    expect_one_side(torus, 4, {0.1, 0});
}

// The tolerances of the fourth paper's figure 7 on a surface that is convex and concave.
TEST(OneSidedPlan, KeepsAnOutsideToleranceOfAHundredth)
{
    expect_one_side(test::saddle(20, 8, {1, 1}), 3, {0, 0.01});
}

TEST(OneSidedPlan, ScallopMayBeSmallerThanTheTolerance)
{
    const Surface part = test::saddle(30, 15);
    VerifiedOptions options = options_of({0.2, 0}, Parameter::U);
    options.scallop_height = 0.05;
    const VerifiedPlan plan = plan_verified({&part, 1}, BallCutter{4}, options);
    EXPECT_TRUE(plan.uncovered.empty());
    const test::SweptDeviation whole =
        test::swept_deviation({&part, 1}, plan.path, 4, 0.05, 60);
    EXPECT_LE(whole.gouge, 0.2 + rounding);
    EXPECT_LE(whole.beyond_height, 1e-9);
}

TEST(OneSidedPlan, IsMeasuredOneSidedByTheMotionError)
{
    const Surface part = test::saddle(30, 15, {2, 2});
    const BallCutter ball{4};
    const auto error = [&](const MotionTolerances& tolerances) {
        return motion_error(
            {&part, 1},
            plan_verified({&part, 1}, ball, options_of(tolerances, Parameter::U)).path,
            ball, Parameter::U);
    };
    EXPECT_LE(error({0, 0.05}).gouge.greatest_mm, rounding);
    EXPECT_LE(error({0.05, 0}).remaining.greatest_mm, rounding);
}

// A cylinder between two angles for passes across its axis, and the tests of its moves.
struct AcrossCylinder {
    static constexpr double radius = 5;
    static constexpr double rho = 20;

    AcrossCylinder(double from, double to, double side, MotionTolerances motion)
        : marched{transposed(nurbs_surface(test::cylinder(rho, 30, from, to, 2))), side},
          bounds{marched.surface},
          clear{{&marched.surface, 1}, {&marched.side, 1},
                BallCutter{radius},    Vec3::UnitZ(),
                motion.inner,          motion.inner == 0 ? motion.outer / 2 : 0},
          cover{marched, bounds, BallCutter{radius}, motion.outer},
          tolerances{motion}
    {
    }

    // The angles in rad by which the steps turn.
    std::vector<double> turns() const
    {
        const VerifiedPass pass =
            verified_pass({marched, clear, cover, tolerances, Parameter::U,
                           PatchBorders::Cross, 10'000, contact_offsets(tolerances)},
                          0.5, {});
        std::vector<double> found;
        const Pass& piece = pass.pieces.at(0);
        for (std::size_t k = 1; k < piece.size(); ++k)
            found.push_back(
                std::acos(piece[k - 1].contact.normal.dot(piece[k].contact.normal)));
        return found;
    }

    MarchedSurface marched;
    OffsetBounds bounds;
    ClearMoves clear;
    StripCover cover;
    MotionTolerances tolerances;
};

// All steps but the first, which comes from the other offset, and the last, which ends at
// the border.
void expect_turns(const std::vector<double>& turns, double angle)
{
    ASSERT_GT(turns.size(), 3U);
    for (std::size_t k = 1; k + 1 < turns.size(); ++k) {
        EXPECT_LE(turns[k], angle * (1 + 1e-9));
        EXPECT_GE(turns[k], angle * (1 - 3e-3));
    }
}

// Outside, the contacts lie at the outer limit and the chord descends to the inner one.
TEST(OneSidedPass, OutsideACylinderUsesTheWholeBandAsSagitta)
{
    for (const MotionTolerances motion :
         {MotionTolerances{0, 0.05}, MotionTolerances{0.05, 0}}) {
        const AcrossCylinder across{pi / 6, 5 * pi / 6, 1, motion};
        const double centre = across.rho + across.radius;
        const double high = motion.outer - offset_margin * 0.05;
        expect_turns(across.turns(),
                     2 * std::acos((centre - motion.inner) / (centre + high)));
    }
}

// Inside, the contacts lie at the inner limit and the chord rises to the outer one.
TEST(OneSidedPass, InsideACylinderUsesTheWholeBandAsSagitta)
{
    for (const MotionTolerances motion :
         {MotionTolerances{0, 0.05}, MotionTolerances{0.05, 0}}) {
        const AcrossCylinder across{7 * pi / 6, 11 * pi / 6, -1, motion};
        const double centre = across.rho - across.radius;
        const double low = offset_margin * 0.05 - motion.inner;
        expect_turns(across.turns(),
                     2 * std::acos((centre - motion.outer) / (centre - low)));
    }
}

TEST(ContactOffsets, LieOnTheSurfaceUnlessTheToleranceIsOneSided)
{
    EXPECT_EQ(contact_offsets({0.1, 0.2}), std::vector<double>{0});
    const std::vector<double> outside = contact_offsets({0, 0.5});
    ASSERT_EQ(outside.size(), 2U);
    EXPECT_DOUBLE_EQ(outside[0], 0.5 * (1 - offset_margin));
    EXPECT_DOUBLE_EQ(outside[1], 0.5 * offset_margin);
}

}  // namespace
}  // namespace endmill
