// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/verification.h"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "finished_plane.h"
#include "test_meshes.h"
#include "test_surfaces.h"
#include "tip_path.h"

namespace endmill {
namespace {

using test::finishing_path;
using test::task_of;

const Part& plane = test::finished_plane;

TEST(DefaultBlock, IsThePartWidenedByTheRadius)
{
    const ToolPath path = test::tip_path({{0, 0, 0}, {20, 0, -2}});
    const Block block = default_block(&plane, path, Cutter::ball(5));
    EXPECT_LT((block.low - Vec3{-5, -5, -3}).norm(), 1e-6);
    EXPECT_LT((block.high - Vec3{25, 17, 1}).norm(), 1e-6);
}

TEST(DefaultBlock, WithoutAPartIsTheBoxOfTheCuttingTips)
{
    ToolPath path = test::tip_path({{0, 0, 0}, {20, 10, -2}, {20, 10, 50}});
    path.points[2].move = Move::Retract;
    const Block block = default_block(nullptr, path, Cutter::ball(5));
    EXPECT_EQ(block.low, Vec3(-5, -5, -3));
    EXPECT_EQ(block.high, Vec3(25, 15, 0));
    for (PathPoint& point : path.points)
        point.move = Move::Rapid;
    EXPECT_THROW(default_block(nullptr, path, Cutter::ball(5)), GeometryError);
}

TEST(VerifyPath, FindsACleanPathCleanAndItsVolumes)
{
    const ToolPath path = finishing_path(2);
    const Verification found = verify_path(task_of(path, &plane));
    EXPECT_EQ(found.verdict, Verdict::Clean);
    ASSERT_TRUE(found.on_part);
    EXPECT_NEAR(found.on_part->deviation.max_scallop_mm, 0.101020514434,
                found.on_part->deviation.scallop_bound_mm + 1e-12);
    const double sum =
        std::accumulate(found.removal.removed.begin(), found.removal.removed.end(), 0.0);
    EXPECT_NEAR(sum / found.removal.total, 1, 1e-12);
    const HeightStock before =
        block_stock(default_block(&plane, path, Cutter::ball(5)), 0.25);
    EXPECT_NEAR(stock_volume(before) - stock_volume(found.heights()), found.removal.total,
                1e-9 * found.removal.total);
}

TEST(VerifyPath, RemovesOnlyTheRemainingStockOfAnEarlierRun)
{
    const ToolPath finishing = finishing_path(2);
    ToolPath roughing = finishing;
    for (PathPoint& point : roughing.points)
        point.location.tip.z() += 0.4;
    VerificationTask task = task_of(finishing, &plane);
    task.path = &roughing;
    const Verification rough = verify_path(task);
    EXPECT_EQ(rough.verdict, Verdict::Uncut);
    task.path = &finishing;
    const Verification whole = verify_path(task);
    const KeptStock left{rough.heights()};
    task.stock = &left;
    const Verification rest = verify_path(task);
    EXPECT_EQ(rest.verdict, Verdict::Clean);
    EXPECT_NEAR(rough.removal.total + rest.removal.total, whole.removal.total,
                1e-9 * whole.removal.total);
}

TEST(VerifyPath, CallsARapidThatCutsAGouge)
{
    ToolPath path = finishing_path(2);
    path.points[3].move = Move::Rapid;
    const Verification found = verify_path(task_of(path, &plane));
    EXPECT_EQ(found.verdict, Verdict::Gouged);
    EXPECT_EQ(found.removal.rapid_cuts.count, 1U);
    EXPECT_EQ(found.removal.rapid_cuts.first, 3U);
}

TEST(VerifyPath, CallsAHolderInTheMaterialAGouge)
{
    const ToolPath path = finishing_path(2);
    VerificationTask task = task_of(path, &plane);
    task.body = {{30, 0.5, 40}};  // half a millimetre above the tip, twice as wide
    const Verification found = verify_path(task);
    EXPECT_EQ(found.verdict, Verdict::Gouged);
    EXPECT_GT(found.removal.collisions.count, 0U);
}

TEST(VerifyPath, WithoutAPartReportsTheRemovalOnly)
{
    const ToolPath path = finishing_path(2);
    const Verification found = verify_path(task_of(path, nullptr));
    EXPECT_FALSE(found.on_part);
    EXPECT_EQ(found.verdict, Verdict::NotJudged);
}

TEST(VerifyPath, NamesThePointThatGouges)
{
    ToolPath path = finishing_path(2);
    path.points.insert(path.points.begin(), path.points.front());
    path.points[0].location.tip.z() = 9;
    path.points[0].move = Move::Rapid;
    path.points[6].location.tip.z() = -0.2;
    const Verification found = verify_path(task_of(path, &plane));
    EXPECT_EQ(found.verdict, Verdict::Gouged);
    ASSERT_TRUE(found.on_part->deviation.deepest);
    // The deepest place lies on the move to the lowered point or on the next move.
    EXPECT_GE(found.on_part->deviation.deepest->sweep, 6);
    EXPECT_LE(found.on_part->deviation.deepest->sweep, 7);
}

TEST(VerifyPath, ReportsTheDistanceOfAPathBesideThePart)
{
    const ToolPath path = test::tip_path({{40, 0, 0}, {40, 12, 0}});
    try {
        verify_path(task_of(path, &plane));
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string{error.what()}.find("mm apart"), std::string::npos);
    }
}

TEST(VerifyPath, ReportsAPathThatOnlyComesNear)
{
    const auto message = [](const ToolPath& path) {
        try {
            verify_path(task_of(path, &plane));
        } catch (const GeometryError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    ToolPath rapid = test::tip_path({{2, 2, 2}});
    rapid.points[0].move = Move::Rapid;
    EXPECT_NE(message(rapid).find("no move"), std::string::npos);
    // The path lies beside the border, nearer than the subdivision of the part resolves.
    const std::string near = message(test::tip_path({{-5.01, 0, 0}, {-5.01, 12, 0}}));
    EXPECT_NE(near.find("cuts nothing"), std::string::npos);
    EXPECT_EQ(near.find(" 0 mm"), std::string::npos);
}

// A cut between two rapids is bounded by its start and end, a plunge by its end.
TEST(DefaultBlock, ReachesFromWhereCutsBegin)
{
    ToolPath path = test::tip_path({{0, 3, 9}, {0, 3, 1}, {100, 3, 2}, {100, 3, 9}});
    path.points[0].move = path.points[1].move = path.points[3].move = Move::Rapid;
    const Block block = default_block(nullptr, path, Cutter::ball(5));
    EXPECT_EQ(block.low, (Vec3{-5, -2, 0}));
    EXPECT_EQ(block.high, (Vec3{105, 8, 2}));
    path = test::tip_path({{0, 3, 9}, {0, 3, -4}}, Move::Plunge);
    path.points[0].move = Move::Rapid;
    EXPECT_EQ(default_block(nullptr, path, Cutter::ball(5)).low, (Vec3{-5, -2, -5}));
    EXPECT_EQ(default_block(&plane, path, Cutter::ball(5)).low.z(), -5);
}

// The estimate covers rays and stock, and the proposed resolution fits.
TEST(VerifyPath, ProposesAResolutionThatFitsTheMemory)
{
    const ToolPath path = finishing_path(2);
    VerificationTask task = task_of(path, &plane);
    task.resolution = 1e-3;
    task.max_memory_gib = 0.02;
    std::string what;
    try {
        verify_path(task);
    } catch (const LimitError& error) {
        what = error.what();
    }
    const std::string word = "a resolution of ";
    const auto proposal = what.rfind(word);
    ASSERT_NE(proposal, std::string::npos) << what;
    task.resolution = std::stod(what.substr(proposal + word.size()));
    EXPECT_EQ(verify_path(task).verdict, Verdict::Clean) << what;
    const double cells = static_cast<double>(verify_path(task).heights().grid().columns) *
                         verify_path(task).heights().grid().rows;
    EXPECT_LT((cells * 8 + verify_path(task).on_part->deviation.rays * 16),
              0.02 * 0x1p30);
}

TEST(VerifyPath, RefusesAResolutionThatDoesNotFitTheMemory)
{
    const ToolPath path = finishing_path(2);
    VerificationTask task = task_of(path, &plane);
    task.resolution = 1e-4;
    task.max_memory_gib = 0.1;
    EXPECT_THROW(verify_path(task), LimitError);
    task.resolution = 0;
    EXPECT_THROW(verify_path(task), DomainError);
}

// The mesh is the same plane as the surface.
TEST(VerifyPath, GivesAMeshTheVerdictOfTheSurface)
{
    const Part mesh = test::grid_mesh(2, 2, [](int i, int j) {
        return Vec3{10.0 * i, 6.0 * j, 0};
    });
    const ToolPath path = finishing_path(2);
    EXPECT_EQ(verify_path(task_of(path, &mesh)).verdict, Verdict::Clean);
}

}  // namespace
}  // namespace endmill
