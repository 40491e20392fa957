// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/verification.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "finished_plane.h"
#include "revolved_surfaces.h"
#include "test_meshes.h"
#include "tip_path.h"

namespace endmill {
namespace {

const Vec3 oblique = Vec3{0.3, -0.4, 0.8}.normalized();

TEST(UprightRotation, TurnsTheAxisToZAndIsARotation)
{
    for (const Vec3& axis : {oblique, Vec3{-Vec3::UnitZ()}, Vec3{Vec3::UnitX()}}) {
        const Eigen::Matrix3d rotation = upright_rotation(axis);
        EXPECT_LT((rotation * axis - Vec3::UnitZ()).norm(), 1e-15);
        EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(),
                  1e-14);
        EXPECT_NEAR(rotation.determinant(), 1, 1e-14);
    }
    EXPECT_EQ(upright_rotation(Vec3::UnitZ()), Eigen::Matrix3d::Identity());
}

TEST(FixedAxis, IsThatOfAllPointsOrNone)
{
    ToolPath path = test::tip_path({{0, 0, 0}, {1, 0, 0}});
    EXPECT_EQ(fixed_axis(path), Vec3(0, 0, 1));
    path.points[1].location.axis = oblique;
    EXPECT_FALSE(fixed_axis(path));
    EXPECT_EQ(fixed_axis({}), Vec3(0, 0, 1));
}

TEST(Turned, MovesEveryPointAlike)
{
    const Eigen::Matrix3d rotation = upright_rotation(oblique);
    const Surface surface = nurbs_surface(test::cylinder(5, 3, 0, 2));
    const Part part = turned(Part{std::vector<Surface>{surface}}, rotation);
    const Surface& found = std::get<std::vector<Surface>>(part).front();
    for (const double v : {0.1, 0.7})
        EXPECT_LT(
            (found.tangents(0.3, v).point - rotation * surface.tangents(0.3, v).point)
                .norm(),
            1e-13);
    const Part mesh = turned(Part{test::flat_mesh(2, 1)}, rotation);
    EXPECT_LT((std::get<TriangleMesh>(mesh).points()[2] -
               rotation * test::flat_mesh(2, 1).points()[2])
                  .norm(),
              1e-15);
    ToolPath path = test::tip_path({{1, 2, 3}});
    path.points[0].location.axis = oblique;
    const ToolPath upright = turned(path, rotation);
    EXPECT_EQ(upright.points[0].location.axis, Vec3(0, 0, 1));
    EXPECT_LT((upright.points[0].location.tip - rotation * Vec3{1, 2, 3}).norm(), 1e-15);
}

// A ball of radius 5 leaves the scallop 5 - sqrt(25 - 1) between passes 2 mm apart, in any
// orientation of part and axis.
TEST(DeviationOfPath, DoesNotDependOnTheOrientation)
{
    const double scallop = 5 - std::sqrt(24.0);
    const DeviationLimits limits{0.01, 0.11};
    const ToolPath upright = test::finishing_path(2);
    for (const Vec3& axis : {Vec3{Vec3::UnitZ()}, oblique}) {
        const Eigen::Matrix3d rotation = upright_rotation(axis).transpose();
        ToolPath path = upright;
        for (PathPoint& point : path.points)
            point.location = {rotation * point.location.tip, axis};
        const Deviation found = deviation_of_path(turned(test::finished_plane, rotation),
                                                  path, Cutter::ball(5), {limits});
        EXPECT_NEAR(found.max_gouge_mm, 0, 1e-12);
        EXPECT_LE(found.max_scallop_mm, scallop + 1e-12);
        EXPECT_GE(found.max_scallop_mm + found.scallop_bound_mm, scallop - 1e-12);
        EXPECT_EQ(verdict(found, limits), Verdict::Clean);
    }
}

TEST(DeviationOfPath, HasAboutAHundredThousandFirstRays)
{
    const Deviation found = deviation_of_path(
        test::finished_plane, test::finishing_path(2), Cutter::ball(5), {{0.01, 0.11}});
    EXPECT_NEAR(found.pitch_mm, std::sqrt(20 * 12 / 1e5), 1e-9);
    // A tile has whole cells whose sides are at most the pitch.
    EXPECT_GE(found.left.size(), 100'000U);
    EXPECT_LE(found.left.size(), 125'000U);
}

// Without a proof cells are refined until the bounds decide. The proof replaces that.
TEST(DeviationOfPath, WithAProofHasItsBoundsAndTheSameFirstRays)
{
    const DeviationLimits limits{0.01, 0.11};
    const ToolPath path = test::finishing_path(2);
    const auto found = [&](LimitProof proof) {
        return deviation_of_path(test::finished_plane, path, Cutter::ball(5),
                                 {limits, proof});
    };
    const Deviation alone = found(LimitProof::None);
    const Deviation proved = found(LimitProof::Proved);
    EXPECT_EQ(proved.left, alone.left);
    EXPECT_LE(proved.rays, alone.rays);
    EXPECT_LE(proved.max_gouge_mm + proved.gouge_bound_mm, limits.tolerance);
    EXPECT_LE(proved.max_scallop_mm + proved.scallop_bound_mm, limits.scallop + 1e-15);
    const double scallop = 5 - std::sqrt(24.0);
    EXPECT_GE(proved.max_scallop_mm + proved.scallop_bound_mm, scallop - 1e-12);
    EXPECT_EQ(verdict(proved, limits), Verdict::Clean);
}

TEST(DeviationOfPath, RefusesAnAxisThatChanges)
{
    ToolPath path = test::finishing_path(2);
    path.points[1].location.axis = oblique;
    EXPECT_THROW(deviation_of_path(test::finished_plane, path, Cutter::ball(5), {}),
                 GeometryError);
}

}  // namespace
}  // namespace endmill
