// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/surface_tree.h"

#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "revolved_surfaces.h"

namespace endmill {
namespace {

constexpr double tolerance = 0.002;

// A quarter of a torus's upper side, divided into the outer and the inner half.
std::vector<Surface> torus_quarter()
{
    return {nurbs_surface(
        test::torus(20, 5, {0, std::numbers::pi / 2, 0, std::numbers::pi, 2}))};
}

Vec3 somewhere(test::Random& random)
{
    return {random.uniform(0, 26), random.uniform(0, 26), random.uniform(-4, 12)};
}

// Closed form of the distance from the quarter, for places above it.
double distance_from_torus(const Vec3& place)
{
    const double beside = place.head<2>().norm() - 20;
    return std::abs(std::hypot(beside, place.z()) - 5);
}

TEST(SurfaceTree, DistancesFromATorusAreWithinTheChordError)
{
    const std::vector<Surface> torus = torus_quarter();
    const SurfaceTree pieces{torus, tolerance};
    ASSERT_LE(pieces.chord_error(), tolerance);
    test::Random random{1};
    for (int i = 0; i < 300; ++i) {
        Vec3 place = somewhere(random);
        place.z() = std::abs(place.z());
        const NearestPoint found = *pieces.nearest(place, {});
        EXPECT_NEAR(found.distance, distance_from_torus(place),
                    pieces.chord_error() + 1e-12);
        EXPECT_NEAR(found.distance, (found.point - place).norm(), 1e-12);
    }
}

TEST(SurfaceTree, ResultDoesNotDependOnTheHint)
{
    const std::vector<Surface> torus = torus_quarter();
    const SurfaceTree fresh{torus, tolerance};
    const SurfaceTree pieces{torus, tolerance};
    test::Random random{2};
    std::optional<std::size_t> hint;
    for (int i = 0; i < 300; ++i) {
        const Vec3 place = somewhere(random);
        const NearestPoint plain = *fresh.nearest(place, {});
        const NearestPoint hinted = *pieces.nearest(place, hint);
        EXPECT_EQ(plain.distance, hinted.distance);
        EXPECT_EQ(plain.triangle, hinted.triangle);
        EXPECT_EQ(plain.point, hinted.point);
        hint = hinted.triangle;  // the hint comes from a place far from the next one
    }
}

TEST(SurfaceTree, SupportsAnyNumberOfThreads)
{
    const std::vector<Surface> torus = torus_quarter();
    const SurfaceTree pieces{torus, tolerance};
    std::vector<double> errors(500);
    parallel_for(errors.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double angle = 0.003 * static_cast<double>(i);
            const Vec3 place{22 * std::cos(angle), 22 * std::sin(angle), 9};
            errors[i] = pieces.nearest(place, {})->distance - distance_from_torus(place);
        }
    });
    for (const double error : errors)
        EXPECT_NEAR(error, 0, pieces.chord_error() + 1e-12);
}

TEST(SurfaceTree, OfAPlaneHasTheDistancesOfThePlane)
{
    const std::vector<Vec3> net{{0, 0, 1}, {7, 0, 1}, {0, 5, 1}, {7, 5, 1}};
    const std::vector<Surface> plane{Surface{{0, 1}, {0, 1}, {BezierPatch{1, 1, net}}}};
    const SurfaceTree pieces{plane, 1e-6};
    EXPECT_EQ(pieces.chord_error(), 0);
    EXPECT_NEAR(pieces.nearest({3, 3, 4}, {})->distance, 3, 1e-12);
    EXPECT_NEAR(pieces.nearest({3, 3, 4}, {}, 3.001)->distance, 3, 1e-12);
    EXPECT_FALSE(pieces.nearest({3, 3, 4}, {}, 2.999));
    EXPECT_NEAR(pieces.nearest({-4, 2, 4}, {})->distance, 5, 1e-12);
    EXPECT_NEAR(pieces.nearest({3, 3, 1}, {})->distance, 0, 1e-12);
}

TEST(SurfaceTree, RefuseAToleranceFarTooFine)
{
    const std::vector<Surface> torus = torus_quarter();
    EXPECT_THROW((SurfaceTree{torus, 1e-9}), LimitError);
}

}  // namespace
}  // namespace endmill
