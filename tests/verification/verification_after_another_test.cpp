// SPDX-License-Identifier: GPL-3.0-or-later
// Verification of a path in the stock that an earlier run left.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/verification/verification.h"
#include "finished_plane.h"
#include "test_surfaces.h"
#include "tip_path.h"

namespace endmill {
namespace {

using test::finishing_path;
using test::task_of;

const Part& plane = test::finished_plane;

// A plane tilted by `degrees` about y, with passes of a ball of radius 3 along its slope.
struct Slope {
    explicit Slope(double degrees)
        : along{std::cos(degrees * std::numbers::pi / 180), 0,
                std::sin(degrees * std::numbers::pi / 180)},
          normal{-along.z(), 0, along.x()},
          part{std::vector<Surface>{test::parallelogram(10 * along, {0, 8, 0})}}
    {
    }

    // Passes from v = `low` to `high`, `above` mm off the plane along its normal.
    ToolPath passes(double low, double high, double above) const
    {
        std::vector<Vec3> tips;
        constexpr double pitch = 0.5;  // leaves a scallop of 0.0104
        for (int i = 0; low + i * pitch <= high + 1e-9; ++i)
            for (const double end : {i % 2 ? 11.0 : -1.0, i % 2 ? -1.0 : 11.0})
                tips.push_back(end * along + Vec3{0, low + i * pitch, 0} +
                               (above + 3) * normal - Vec3{0, 0, 3});
        return test::tip_path(tips);
    }

    VerificationTask task(const ToolPath& path, double resolution) const
    {
        const Cutter ball = Cutter::ball(3);
        VerificationTask task{.path = &path,
                              .cutter = ball,
                              .judged = JudgedPart{&part, {0.01, 0.02}},
                              .stock = {}};
        Block block = default_block(&part, path, ball);
        block.low.z() = -5;
        block.high.z() = 12;
        task.stock = block;
        task.resolution = resolution;
        return task;
    }

    Vec3 along;
    Vec3 normal;
    Part part;
};

// A second run in the stock of a first run, kept with its history.
struct TwoRuns {
    TwoRuns(const VerificationTask& first, VerificationTask second)
        : before{verify_path(first)},
          kept{before.heights(), history_of_rest(first)}
    {
        second.stock = &kept;
        after = verify_path(second);
    }

    Verification before;
    KeptStock kept;
    std::optional<Verification> after;
};

TEST(VerifyPathAfterAnother, FindsTwoHalvesCleanTogether)
{
    for (const double degrees : {0.0, 30.0, 60.0, 75.0}) {
        const Slope slope{degrees};
        const ToolPath left = slope.passes(-1, 4, 0);
        const ToolPath right = slope.passes(4, 9, 0);
        const TwoRuns runs{slope.task(left, 0.1), slope.task(right, 0.1)};
        EXPECT_EQ(runs.before.verdict, Verdict::Uncut) << degrees;
        EXPECT_EQ(runs.after->verdict, Verdict::Clean) << degrees;
        EXPECT_FALSE(runs.after->on_part->earlier_gouge);
        EXPECT_EQ(runs.after->earlier_moves, left.points.size());
    }
}

// Reference: one path of both runs, with a link between them that cuts nothing more.
TEST(VerifyPathAfterAnother, EqualsOnePathOfBoth)
{
    const Slope slope{40};
    const ToolPath left = slope.passes(-1, 4, 0.003);
    const ToolPath right = slope.passes(4, 9, -0.004);
    ToolPath both = left;
    for (const PathPoint& point : right.points)
        both.points.push_back(point);
    const TwoRuns runs{slope.task(left, 0.2), slope.task(right, 0.2)};
    const Verification one = verify_path(slope.task(both, 0.2));
    EXPECT_EQ(runs.after->verdict, one.verdict);
    const Deviation& found = runs.after->on_part->deviation;
    EXPECT_NEAR(found.max_gouge_mm, one.on_part->deviation.max_gouge_mm, 1e-12);
    EXPECT_NEAR(found.max_scallop_mm, one.on_part->deviation.max_scallop_mm, 1e-9);
    EXPECT_NEAR(found.gouge_bound_mm, one.on_part->deviation.gouge_bound_mm, 1e-9);
    ASSERT_EQ(found.left.size(), one.on_part->deviation.left.size());
    for (std::size_t k = 0; k < found.left.size(); ++k)
        EXPECT_NEAR(found.left[k], one.on_part->deviation.left[k], 1e-6);
}

// The first run gouges by 0.05 mm along the normal, which the second run cannot repair.
TEST(VerifyPathAfterAnother, FindsTheGougeOfTheFirst)
{
    for (const double degrees : {0.0, 20.0, 45.0, 60.0, 80.0})
        for (const double resolution : {0.4, 0.1}) {
            const Slope slope{degrees};
            ToolPath first = slope.passes(-1, 9, 0.3);
            for (PathPoint& point : first.points)
                if (std::abs(point.location.tip.y() - 4) < 1e-9)
                    point.location.tip -= 0.35 * slope.normal;
            const ToolPath second = slope.passes(-1, 9, 0);
            const TwoRuns runs{slope.task(first, resolution),
                               slope.task(second, resolution)};
            ASSERT_TRUE(runs.after->on_part->deviation.deepest) << degrees;
            EXPECT_EQ(runs.after->verdict, Verdict::Gouged) << degrees;
            const Deviation& found = runs.after->on_part->deviation;
            EXPECT_LE(found.max_gouge_mm, 0.05 + 1e-9) << degrees;
            EXPECT_GE(found.max_gouge_mm + found.gouge_bound_mm, 0.05) << degrees;
            EXPECT_EQ(found.deepest->sweep, by_earlier_run) << degrees;
            EXPECT_NEAR(found.deepest->ray.point.y(), 4, 0.5 * resolution + 1e-9);
        }
}

TEST(VerifyPathAfterAnother, IsCleanAfterRoughingThatLeftAnAllowance)
{
    for (const double degrees : {0.0, 45.0, 75.0}) {
        const Slope slope{degrees};
        const ToolPath rough = slope.passes(-1, 9, 0.3);
        const ToolPath finish = slope.passes(-1, 9, 0);
        EXPECT_EQ(TwoRuns(slope.task(rough, 0.1), slope.task(finish, 0.1)).after->verdict,
                  Verdict::Clean)
            << degrees;
    }
}

// Before the ball, a flat cutter has passed over the level plane: well above it, or into
// it.
TEST(VerifyPathAfterAnother, KnowsTheCutterOfEachRun)
{
    for (const double low : {0.3, -0.05}) {
        const ToolPath flat = test::tip_path({{-9, 6, low}, {29, 6, low}});
        VerificationTask first = task_of(flat, &plane);
        first.cutter = Cutter::flat(4);
        const ToolPath finishing = finishing_path(2);
        const TwoRuns runs{first, task_of(finishing, &plane)};
        EXPECT_EQ(runs.after->verdict, low > 0 ? Verdict::Clean : Verdict::Gouged);
        EXPECT_NEAR(runs.after->on_part->deviation.max_gouge_mm, std::max(0.0, -low),
                    1e-12);
        // The scallop lies beside the flat cutter's way: passes cover 12 mm, the cutter 8
        // mm.
        EXPECT_NEAR(runs.after->on_part->deviation.max_scallop_mm, 0.101020514434,
                    runs.after->on_part->deviation.scallop_bound_mm + 1e-12);
    }
}

TEST(VerifyPathAfterAnother, MustStillCutOverThePart)
{
    const ToolPath first = finishing_path(2);
    const ToolPath beside = test::tip_path({{40, 0, 0}, {40, 12, 0}});
    const auto both = [&](const ToolPath& second) {
        return TwoRuns{task_of(first, &plane), task_of(second, &plane)};
    };
    EXPECT_THROW(both(beside), GeometryError);
    EXPECT_EQ(both(first).after->verdict, Verdict::Clean);  // the same path again
}

TEST(VerifyPathAfterAnother, IsTheSameOnAnyNumberOfThreads)
{
    const Slope slope{50};
    const ToolPath first = slope.passes(-1, 9, -0.02);
    const ToolPath second = slope.passes(-1, 9, 0);
    std::vector<Verification> found;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        const Verification before = verify_path(slope.task(first, 0.8));
        VerificationTask task = slope.task(second, 0.8);
        KeptStock kept{before.heights()};
        task.stock = &kept;
        found.push_back(verify_path(task));  // with the heights only
        kept.history = history_of_rest(slope.task(first, 0.8));
        found.push_back(verify_path(task));
    }
    for (std::size_t k = 2; k < found.size(); ++k) {
        const Verification& other = found[k % 2];
        EXPECT_EQ(found[k].on_part->deviation.left, other.on_part->deviation.left);
        EXPECT_EQ(found[k].on_part->deviation.max_gouge_mm,
                  other.on_part->deviation.max_gouge_mm);
        EXPECT_EQ(found[k].on_part->deviation.gouge_bound_mm,
                  other.on_part->deviation.gouge_bound_mm);
        ASSERT_EQ(found[k].on_part->earlier_gouge.has_value(),
                  other.on_part->earlier_gouge.has_value());
        EXPECT_EQ(found[k].on_part->earlier_gouge.has_value(), k % 2 == 0);
        if (other.on_part->earlier_gouge) {
            EXPECT_EQ(found[k].on_part->earlier_gouge->found_mm,
                      other.on_part->earlier_gouge->found_mm);
            EXPECT_EQ(found[k].on_part->earlier_gouge->bound_mm,
                      other.on_part->earlier_gouge->bound_mm);
        }
    }
}

// With heights only, a gouge on a slope is not known well. The verdict is never clean
// then, and it is clean where enough material stands over the part.
TEST(VerifyPathInHeights, IsNotCleanIfAGougeIsPossible)
{
    for (const double degrees : {0.0, 30.0, 60.0})
        for (const double above : {-0.05, 1.5}) {
            const Slope slope{degrees};
            const ToolPath first = slope.passes(-1, 9, above);
            const Verification before = verify_path(slope.task(first, 0.4));
            const ToolPath second = slope.passes(-1, 9, 0);
            VerificationTask task = slope.task(second, 0.4);
            const KeptStock kept{before.heights()};
            task.stock = &kept;
            const Verification found = verify_path(task);
            ASSERT_TRUE(found.on_part->earlier_gouge);
            if (above > 0) {
                EXPECT_EQ(found.verdict, Verdict::Clean) << degrees;
                continue;
            }
            EXPECT_NE(found.verdict, Verdict::Clean) << degrees;
            EXPECT_NE(found.verdict, Verdict::Uncut) << degrees;
            const EarlierGouge& gouge = *found.on_part->earlier_gouge;
            EXPECT_LE(gouge.found_mm, 0.05 + 1e-9);
            EXPECT_GE(gouge.found_mm + gouge.bound_mm, 0.05);
            EXPECT_FALSE(history_of_rest(task));
        }
}

// Runs of cutters of every kind, the last of them too deep. The bounds include what a
// finer grid finds, and a certain verdict never changes.
TEST(VerifyPathAfterAnother, BoundsTheDepthAfterCuttersOfAllKinds)
{
    for (const double deep : {-0.03, 0.3})
        for (const Cutter& cutter : {Cutter::flat(4), Cutter{4, 1}, Cutter::ball(1)}) {
            const Slope slope{25};
            ToolPath first = slope.passes(3, 3, 0.3);
            for (PathPoint& point : first.points)
                point.location.tip =
                    point.location.tip + Vec3{0, 0, 3} - 3.3 * slope.normal +
                    deep * slope.normal +
                    Vec3{-cutter.flat_radius() * slope.along.z() / slope.along.x(), 0, 0};
            const ToolPath second = slope.passes(-1, 9, 0);
            double most = 0;
            Verdict settled = Verdict::Undecided;
            for (const double resolution : {0.8, 0.3, 0.1}) {
                VerificationTask before = slope.task(first, resolution);
                before.cutter = cutter;
                const TwoRuns runs{before, slope.task(second, resolution)};
                const Deviation& found = runs.after->on_part->deviation;
                EXPECT_GE(found.max_gouge_mm + found.gouge_bound_mm + 1e-9, most);
                most = std::max(most, found.max_gouge_mm);
                if (settled != Verdict::Undecided) {
                    EXPECT_EQ(runs.after->verdict, settled);
                }
                settled = runs.after->verdict;
            }
            EXPECT_NE(settled, Verdict::Undecided);
        }
}

}  // namespace
}  // namespace endmill
