// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/bezier_patch.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "test_surfaces.h"

namespace endmill {
namespace {

BezierPatch random_patch(unsigned seed)
{
    return BezierPatch{test::random_net(seed, {1, 1}, 8)};
}

// B_ij = (10 i, 10 j, i j).
BezierPatch tabulated_patch()
{
    std::vector<Vec3> net;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            net.emplace_back(10 * i, 10 * j, i * j);
    return BezierPatch{net};
}

// Hermite's cubics for a value and a slope at both ends, of which Ferguson's patch is
// made.
Eigen::Vector4d hermite(double t)
{
    const double s = 1 - t;
    return {s * s * (1 + 2 * t), t * t * (3 - 2 * t), t * s * s, -t * t * s};
}

Vec3 ferguson_point(const FergusonPatch& patch, double u, double v)
{
    const Eigen::Vector4d along_u = hermite(u);
    const Eigen::Vector4d along_v = hermite(v);
    Vec3 point = Vec3::Zero();
    for (int corner = 0; corner < 4; ++corner) {
        const int i = corner % 2;
        const int j = corner / 2;
        const auto& [place, du, dv, twist] = patch.corners[corner];
        point += along_u[i] * along_v[j] * place + along_u[i + 2] * along_v[j] * du +
                 along_u[i] * along_v[j + 2] * dv +
                 along_u[i + 2] * along_v[j + 2] * twist;
    }
    return point;
}

TEST(Ferguson, BezierFormIsTheSurfaceOfHermitesCubics)
{
    const FergusonPatch ferguson = ferguson_from_bezier(random_patch(1));
    const BezierPatch bezier = bezier_from_ferguson(ferguson);
    for (double u = 0; u <= 1; u += 0.125)
        for (double v = 0; v <= 1; v += 0.125)
            EXPECT_LT((bezier.jet(u, v).point - ferguson_point(ferguson, u, v)).norm(),
                      1e-12);
}

TEST(Ferguson, ConvertedBackIsTheSamePatch)
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        const BezierPatch patch = random_patch(seed);
        const BezierPatch back = bezier_from_ferguson(ferguson_from_bezier(patch));
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j)
                EXPECT_LT((back.control_point(i, j) - patch.control_point(i, j)).norm(),
                          1e-13);
    }
}

// The definitions in long double: r(0, 0) = B00, r_u = 3 (B10 - B00), r_uv = 9 (B00 - B10
// - B01 + B11), and likewise at the other corners.
TEST(Ferguson, IsAsAccurateAsStated)
{
    for (unsigned seed = 0; seed < 200; ++seed) {
        const BezierPatch patch = random_patch(seed);
        const FergusonPatch ferguson = ferguson_from_bezier(patch);
        const BezierPatch back = bezier_from_ferguson(ferguson);
        using Exact = Eigen::Matrix<long double, 3, 1>;
        const auto b = [&](int i, int j) {
            return Exact{patch.control_point(i, j).cast<long double>()};
        };
        double greatest = 0;
        double error = 0;
        double error_there_and_back = 0;
        for (int corner = 0; corner < 4; ++corner) {
            const int i = corner % 2 == 0 ? 0 : 3;
            const int j = corner / 2 == 0 ? 0 : 3;
            const int di = i == 0 ? 1 : -1;
            const int dj = j == 0 ? 1 : -1;
            const Exact du = 3 * di * (b(i + di, j) - b(i, j));
            const Exact dv = 3 * dj * (b(i, j + dj) - b(i, j));
            const Exact twist =
                9 * di * dj * (b(i, j) - b(i + di, j) - b(i, j + dj) + b(i + di, j + dj));
            const auto far = [](const Vec3& value, const Exact& exact) {
                return static_cast<double>(
                    (value.cast<long double>() - exact).lpNorm<Eigen::Infinity>());
            };
            const auto& [point, got_du, got_dv, got_twist] = ferguson.corners[corner];
            error = std::max({error, far(point, b(i, j)), far(got_du, du),
                              far(got_dv, dv), far(got_twist, twist)});
            for (int k = 0; k < 4; ++k) {
                const int s = i + (k % 2) * di;
                const int t = j + (k / 2) * dj;
                greatest = std::max(greatest,
                                    patch.control_point(s, t).lpNorm<Eigen::Infinity>());
                error_there_and_back = std::max(error_there_and_back,
                                                far(back.control_point(s, t), b(s, t)));
            }
        }
        EXPECT_LT(error, 1e-14 * greatest);
        EXPECT_LT(error_there_and_back, 2e-15 * greatest);
    }
}

TEST(Ferguson, BezierFormIsAsAccurateAsStated)
{
    test::Random random{5};
    const auto vector = [&] {
        const double x = random.uniform(-50, 50);
        const double y = random.uniform(-50, 50);
        return Vec3{x, y, random.uniform(-50, 50)};
    };
    for (int trial = 0; trial < 200; ++trial) {
        FergusonPatch ferguson;
        double greatest = 0;
        for (auto& corner : ferguson.corners) {
            corner = {vector(), vector(), vector(), vector()};
            for (const Vec3& v : {corner.point, corner.du, corner.dv, corner.twist})
                greatest = std::max(greatest, v.lpNorm<Eigen::Infinity>());
        }
        const BezierPatch patch = bezier_from_ferguson(ferguson);
        for (int c = 0; c < 4; ++c) {
            const int i = c % 2 == 0 ? 0 : 3;
            const int j = c / 2 == 0 ? 0 : 3;
            const int di = i == 0 ? 1 : -1;
            const int dj = j == 0 ? 1 : -1;
            const auto& [point, du, dv, twist] = ferguson.corners[c];
            const Eigen::Matrix<long double, 3, 1> exact =
                point.cast<long double>() + di * du.cast<long double>() / 3 +
                dj * dv.cast<long double>() / 3 + di * dj * twist.cast<long double>() / 9;
            const Eigen::Matrix<long double, 3, 1> off =
                patch.control_point(i + di, j + dj).cast<long double>() - exact;
            EXPECT_LT(static_cast<double>(off.lpNorm<Eigen::Infinity>()),
                      1e-15 * greatest);
        }
    }
}

TEST(Ferguson, TabulatedPatchHasEqualTwists)  // the vectors were computed with 50 digits
{
    for (const auto& corner : ferguson_from_bezier(tabulated_patch()).corners)
        EXPECT_LT((corner.twist - Vec3{0, 0, 9}).norm(), 1e-13);
}

TEST(Ferguson,
     WithoutTwistsTheTabulatedPatchIsAnother)  // the vectors were computed with 50 digits
{
    FergusonPatch flat = ferguson_from_bezier(tabulated_patch());
    for (auto& corner : flat.corners)
        corner.twist.setZero();
    const BezierPatch patch = bezier_from_ferguson(flat);
    EXPECT_LT((patch.jet(0.3, 0.7).point - Vec3{9, 21, 1.953504}).norm(), 1e-13);
    EXPECT_NEAR(patch.control_point(1, 1).z(), 0, 1e-15);
    EXPECT_NEAR(patch.control_point(1, 2).z(), 3, 1e-15);
    EXPECT_NEAR(patch.control_point(2, 1).z(), 3, 1e-15);
    EXPECT_NEAR(patch.control_point(2, 2).z(), 3, 1e-15);
}

TEST(Ferguson, TwistIsNineTimesTheParallelogramThatTheNetMissesAtACorner)
{
    const BezierPatch patch = random_patch(2);
    const auto b = [&](int i, int j) { return patch.control_point(i, j); };
    const Vec3 expected = 9 * (b(0, 0) - b(1, 0) - b(0, 1) + b(1, 1));
    EXPECT_LT((ferguson_from_bezier(patch).corners[0].twist - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace endmill
