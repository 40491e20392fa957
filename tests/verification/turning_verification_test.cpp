// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/turning_verification.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/verification/detail/closed_form_parts.h"
#include "endmill/verification/verification.h"
#include "turning_paths.h"

namespace endmill {
namespace {

double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

Part plane_below(double low_x, double high_x, double half_y)
{
    const Nurbs plane{{1, {0, 0, 1, 1}},
                      {1, {0, 0, 1, 1}},
                      {{low_x, -half_y, 0},
                       {high_x, -half_y, 0},
                       {low_x, half_y, 0},
                       {high_x, half_y, 0}},
                      {}};
    return std::vector<Surface>{nurbs_surface(plane)};
}

VerificationTask task_of(const ToolPath& path, const Cutter& cutter, const Part* part,
                         RemovalEngine engine)
{
    VerificationTask task{
        .path = &path, .cutter = cutter, .stock = default_block(part, path, cutter)};
    if (part)
        task.judged = JudgedPart{.part = part, .limits = {0.01, 0.05}};
    task.resolution = 0.25;
    task.engine = engine;
    return task;
}

TEST(TurningVerification, CleanPathIsCleanAndRefiningDoesNotChangeIt)
{
    const Cutter cutter{5, 1};
    const ToolPath path =
        test::plane_passes(cutter, {.count = 5, .lead = {rad(10), rad(20)}});
    const Part part = plane_below(5, 15, 3);
    for (const int refine : {2, 8}) {
        VerificationTask task = task_of(path, cutter, &part, RemovalEngine::FiveAxis);
        task.judged->max_refine = refine;
        const Verification found = verify_path(task);
        EXPECT_EQ(found.verdict, Verdict::Clean);
        EXPECT_EQ(found.contacts.rapid_cuts.count, 0U);
        EXPECT_GT(found.removal.total, 0);
        ASSERT_TRUE(found.removed_bounds);
        EXPECT_LT(found.removed_bounds->bound, 0.01 * found.removal.total);
    }
}

// With a constant axis both engines measure the same.
// Of an upright path both engines measure the deviation by the same sweeps.
TEST(TurningVerification, RemovesWhatThreeAxesRemoveIfTheAxisIsConstant)
{
    for (const Cutter& cutter : {Cutter::ball(5), Cutter{5, 2}, Cutter::flat(5)}) {
        ToolPath path = level_passes(1, std::nullopt);
        path.points[7].location.tip.z() -= 0.03;
        const Part part = plane_part({20, 0, 0}, {0, 12, 0});
        const Verification three =
            verify_path(task_of(path, cutter, &part, RemovalEngine::ThreeAxis));
        const Verification five =
            verify_path(task_of(path, cutter, &part, RemovalEngine::FiveAxis));
        EXPECT_EQ(three.verdict, five.verdict);
        // Heights are the middles of cells, accurate to the square of the pitch.
        EXPECT_NEAR(three.removal.total, five.removal.total,
                    five.removed_bounds->bound + five.removed_bounds->spread +
                        2e-3 * three.removal.total);
        EXPECT_EQ(three.contacts.rapid_cuts.count, five.contacts.rapid_cuts.count);
    }
}

// Upright, the deviation has the closed forms of sweeps; turned together with the part, the
// same path is judged by searches on its rays.
TEST(TurningVerification, UprightPathIsJudgedAsTheSamePathTurned)
{
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd{0.4, Vec3{1, 2, 0}.normalized()}.toRotationMatrix();
    for (const Cutter& cutter : {Cutter::ball(5), Cutter{5, 2}, Cutter::flat(5)}) {
        ToolPath path = level_passes(1, std::nullopt);
        path.points[7].location.tip.z() -= 0.03;
        const Part part = plane_part({20, 0, 0}, {0, 12, 0});
        const ToolPath leaning_path = turned(path, rotation);
        const Part leaning_part = turned(part, rotation);
        const Verification upright =
            verify_path(task_of(path, cutter, &part, RemovalEngine::FiveAxis));
        const Verification leaning = verify_path(
            task_of(leaning_path, cutter, &leaning_part, RemovalEngine::FiveAxis));
        EXPECT_EQ(upright.verdict, leaning.verdict);
        const Deviation& a = upright.on_part->deviation;
        const Deviation& b = leaning.on_part->deviation;
        EXPECT_NEAR(a.max_gouge_mm, b.max_gouge_mm,
                    a.gouge_bound_mm + b.gouge_bound_mm + 1e-6);
        EXPECT_NEAR(a.max_scallop_mm, b.max_scallop_mm,
                    a.scallop_bound_mm + b.scallop_bound_mm + 1e-6);
        ASSERT_TRUE(a.deepest && b.deepest);
        EXPECT_EQ(a.deepest->sweep, b.deepest->sweep);
    }
}

// A flat cutter on a head leans by 25 degrees while the table turns in steps of 20 degrees:
// its disc leaves a cone. With straight tips between the points it would not.
TEST(TurningVerification, TableTurnsAConeExactlyInCoarseSteps)
{
    const Cutter flat = Cutter::flat(5);
    const double lean = rad(25);
    ToolPath path;
    MachineMotion motion;
    motion.interpolation = Interpolation::Joint;
    motion.setup.machine.configuration = configuration_from_word("W/cBxyzb/T");
    motion.setup.machine.pivot = 60;
    motion.setup.tool_length = 40;
    for (int k = 0; k <= 8; ++k) {
        const double turn = rad(20) * k;
        const Vec3 out{std::cos(turn), -std::sin(turn), 0};
        const RotaryPositions rotary{turn, lean};
        motion.positions.push_back(axis_positions(motion.setup, rotary, 30 * out));
        const CutterLocation here = tool_location(motion.setup, motion.positions.back());
        EXPECT_LE((here.tip - 30 * out).norm(), 1e-12);
        EXPECT_NEAR(here.axis.dot(out), std::sin(lean), 1e-12);
        test::add(path, k == 0 ? Move::Rapid : Move::Cut, here);
    }
    path.machine = motion;
    Nurbs cone{{2, {}}, {1, {0, 0, 1, 1}}, {}, {}};
    const test::UnitArc arc = test::unit_arc(-1.5, -0.5);
    cone.u.knots = arc.knots;
    for (const double away : {-4.9, 4.9})
        for (std::size_t i = 0; i < arc.points.size(); ++i) {
            const double radius = 30 + away * std::cos(lean);
            cone.control_points.emplace_back(radius * arc.points[i].x(),
                                             radius * arc.points[i].y(),
                                             -away * std::sin(lean));
            cone.weights.push_back(arc.weights[i]);
        }
    const Part part = std::vector<Surface>{nurbs_surface(cone)};
    VerificationTask task = task_of(path, flat, &part, RemovalEngine::FiveAxis);
    task.resolution = 0.5;
    task.judged->limits = {0.01, 0.01};
    const Verification exact = verify_path(task);
    // The rim is sharp: the bounds between the rays may leave it undecided.
    EXPECT_NE(exact.verdict, Verdict::Gouged);
    EXPECT_NE(exact.verdict, Verdict::Uncut);
    EXPECT_LT(exact.on_part->deviation.max_gouge_mm, 1e-3);
    path.machine->interpolation = Interpolation::Tcp;
    const Verification straight = verify_path(task);
    EXPECT_EQ(straight.verdict, Verdict::Gouged);
    // The chords of the tip are 30 (1 - cos 10) = 0.456 nearer to the axis.
    EXPECT_GT(straight.on_part->deviation.max_gouge_mm, 0.1);
}

TEST(TurningVerification, RapidThroughTheStockGouges)
{
    const Cutter ball = Cutter::ball(5);
    ToolPath path = test::plane_passes(ball, {.count = 5, .lead = {rad(10), rad(20)}});
    const Part part = plane_below(5, 15, 3);
    // The first pass is made at rapid speed.
    const std::size_t rapid = 20;
    path.points[rapid].move = Move::Rapid;
    const Verification found =
        verify_path(task_of(path, ball, &part, RemovalEngine::FiveAxis));
    EXPECT_EQ(found.verdict, Verdict::Gouged);
    EXPECT_EQ(found.contacts.rapid_cuts.count, 1U);
    EXPECT_EQ(found.contacts.rapid_cuts.first, rapid);
    EXPECT_GT(found.contacts.rapid_cuts.deepest, 0.1);
}

TEST(TurningVerification, ShankInTheStockGouges)
{
    const Cutter ball = Cutter::ball(5);
    const ToolPath path =
        test::plane_passes(ball, {.count = 3, .lead = {rad(10), rad(20)}});
    const Part part = plane_below(5, 15, 1);
    VerificationTask task = task_of(path, ball, &part, RemovalEngine::FiveAxis);
    task.stock = Block{{0, -10, -2}, {20, 10, 8}};
    task.body = {{30, 6, 60}};
    const Verification found = verify_path(task);
    EXPECT_EQ(found.verdict, Verdict::Gouged);
    EXPECT_GT(found.contacts.collisions.count, 0U);
}

TEST(TurningVerification, WithoutAPartIsNotJudged)
{
    const Cutter ball = Cutter::ball(5);
    const ToolPath path =
        test::plane_passes(ball, {.count = 3, .lead = {rad(10), rad(20)}});
    VerificationTask task = task_of(path, ball, nullptr, RemovalEngine::FiveAxis);
    const Verification found = verify_path(task);
    EXPECT_EQ(found.verdict, Verdict::NotJudged);
    EXPECT_FALSE(found.on_part);
}

TEST(TurningVerification, RefusesAPathBesideThePart)
{
    const Cutter ball = Cutter::ball(5);
    const ToolPath path = test::plane_passes(ball, {.count = 3, .lead = {0.1, 0.2}});
    const Part part = plane_below(40, 50, 3);
    try {
        verify_path(task_of(path, ball, &part, RemovalEngine::FiveAxis));
        FAIL();
    } catch (const GeometryError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("cuts nothing over the part"), std::string::npos) << text;
        EXPECT_NE(text.find("mm apart"), std::string::npos) << text;
    }
}

TEST(TurningVerification, RefusesOppositeAxes)
{
    ToolPath path;
    test::add(path, Move::Rapid, {{0, 0, 5}, {0, 0, 1}});
    test::add(path, Move::Cut, {{1, 0, 5}, {0, 0, -1}});
    const Part part = plane_below(0, 5, 3);
    EXPECT_THROW(
        verify_path(task_of(path, Cutter::ball(5), &part, RemovalEngine::FiveAxis)),
        GeometryError);
}

// Straight through a block, deeper than the cutting edges are long: the cutter leaves the
// material above them, and its neck is in it.
TEST(TurningVerification, CutterOfFiniteLengthLeavesWhatIsAboveIt)
{
    ToolPath path;
    for (const double x : {-20.0, 30.0})
        test::add(path, x < 0 ? Move::Rapid : Move::Cut, {{x, 0, -6}, {0, 0, 1}});
    VerificationTask task =
        task_of(path, Cutter::flat(5), nullptr, RemovalEngine::FiveAxis);
    task.stock = Block{{0, -8, -10}, {10, 8, 0}};
    task.cutting_length = 4;
    const Verification found = verify_path(task);
    EXPECT_NEAR(found.removal.total, 10 * 10 * 4,
                found.removed_bounds->bound + found.removed_bounds->spread);
    EXPECT_EQ(found.verdict, Verdict::Collides);
    EXPECT_EQ(found.contacts.collisions.first, 1U);
    // A shank that begins at the edges' end is tested as itself.
    task.body = {{4, 4, 30}};
    EXPECT_EQ(verify_path(task).verdict, Verdict::Collides);
    task.cutting_length = 6;
    task.body.clear();
    const Verification deep = verify_path(task);
    EXPECT_NEAR(deep.removal.total, 10 * 10 * 6,
                deep.removed_bounds->bound + deep.removed_bounds->spread);
    EXPECT_EQ(deep.contacts.collisions.count, 0U);
    EXPECT_EQ(deep.verdict, Verdict::NotJudged);
}

// On the way down the cutter clears the place of its neck, also within a single move.
TEST(TurningVerification, NeckFollowsAPlungeWithoutAContact)
{
    ToolPath path;
    for (const double z : {5.0, -8.0})
        test::add(path, z > 0 ? Move::Rapid : Move::Plunge, {{5, 0, z}, {0, 0, 1}});
    VerificationTask task =
        task_of(path, Cutter::flat(5), nullptr, RemovalEngine::FiveAxis);
    task.stock = Block{{-2, -7, -10}, {12, 7, 0}};
    task.cutting_length = 3;
    const Verification found = verify_path(task);
    EXPECT_EQ(found.verdict, Verdict::NotJudged);
    EXPECT_NEAR(found.removal.total, std::numbers::pi * 25 * 8,
                found.removed_bounds->bound + found.removed_bounds->spread);
}

// Every place of the part is cut below the end of the edges, so the length changes nothing.
TEST(TurningVerification, LongCuttingEdgesAreLikeEndlessOnes)
{
    const Cutter cutter{5, 1};
    const ToolPath path =
        test::plane_passes(cutter, {.count = 5, .lead = {rad(10), rad(20)}});
    const Part part = plane_below(5, 15, 3);
    VerificationTask task = task_of(path, cutter, &part, RemovalEngine::FiveAxis);
    const Verification endless = verify_path(task);
    task.cutting_length = 20;
    const Verification finite = verify_path(task);
    EXPECT_EQ(finite.verdict, endless.verdict);
    EXPECT_EQ(finite.removal.total, endless.removal.total);
    EXPECT_EQ(finite.on_part->deviation.max_scallop_mm,
              endless.on_part->deviation.max_scallop_mm);
    EXPECT_GE(finite.on_part->deviation.scallop_bound_mm, 0);
}

// Check [22] of docs/methods/five-axis-paths.md, section 9: a head swings from -60 to 60
// degrees about its pivot, H above the bottom of a flat cutter, or above the reference point
// of a bull-nose cutter. The block lies below the lowest tip, so that only poses between the
// ends cut: a cap of the sphere on which the rim moves.
TEST(TurningVerification, SwingingHeadCutsACapBelowItsTip)
{
    struct Case {
        Cutter cutter;
        double exact;
    };
    for (const auto& [cutter, exact] :
         {Case{Cutter::flat(5), 47.2128721}, Case{Cutter{5, 2}, 7.4875022}}) {
        const double height = 10;
        const double corner = cutter.corner_radius();
        const double rim = std::hypot(height, cutter.flat_radius());
        const double cap = rim - height;
        EXPECT_NEAR(std::numbers::pi * cap * cap * (3 * (rim + corner) - cap) / 3, exact,
                    1e-7);
        const Vec3 lowest{0, 0, -height - corner};
        ToolPath path;
        MachineMotion motion;
        motion.interpolation = Interpolation::Joint;
        motion.setup.machine.configuration = configuration_from_word("W/Bxyzb/T");
        motion.setup.machine.pivot = height + corner;
        for (const double degrees : {-60.0, 60.0}) {
            motion.positions.push_back({{rad(degrees), 0}, lowest});
            const CutterLocation tip =
                tool_location(motion.setup, motion.positions.back());
            // The pivot stays at the origin.
            EXPECT_LE((tip.tip + (height + corner) * tip.axis).norm(), 1e-12);
            test::add(path, degrees < 0 ? Move::Rapid : Move::Cut, tip);
        }
        path.machine = motion;
        VerificationTask task = task_of(path, cutter, nullptr, RemovalEngine::FiveAxis);
        task.stock = Block{lowest - Vec3{8, 7, 3}, lowest + Vec3{8, 7, 0}};
        for (const double pitch : {0.2, 0.1}) {
            task.resolution = pitch;
            const Verification found = verify_path(task);
            EXPECT_NEAR(found.removal.total, exact,
                        found.removed_bounds->bound + found.removed_bounds->spread);
            EXPECT_LT(found.removed_bounds->bound, 0.02 * exact);
        }
    }
}

}  // namespace
}  // namespace endmill
