// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/contact_search.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/surface/nurbs.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// Each centre lies on the normal of a surface point, at less than the radius of
// curvature. The search has to return that point.
TEST(ContactSearch, FindsThePointUnderTheCentre)
{
    std::vector<Surface> part;
    part.push_back(test::saddle(30, 20, {3, 2}));
    const ContactSearch search{part};
    std::mt19937 random{3};
    std::uniform_real_distribution<double> u{0, 3};
    std::uniform_real_distribution<double> v{0, 2};
    for (int k = 0; k < 300; ++k) {
        const SurfaceTangents at = part[0].tangents(u(random), v(random));
        const Vec3 normal = unit_normal(at);
        const BallFoot foot = search.foot(at.point + 5 * normal, {}, 5, 1e-3);
        EXPECT_LT((foot.point - at.point).norm(), 1e-9);
        EXPECT_LT((foot.normal - normal).norm(), 1e-9);
        EXPECT_NEAR(foot.distance, 5, 1e-12);
        // The search also starts from another place, to which the centre does not belong.
        const BallFoot found =
            search.foot(at.point + 5 * normal, FootPlace{0, 0, 0}, 5, 1e-3);
        EXPECT_LT((found.point - at.point).norm(), 1e-9);
    }
}

TEST(ContactSearch, ReportsACentreBehindThePart)
{
    const std::vector<Surface> part{test::plane(20, 10)};
    const BallFoot foot = ContactSearch{part}.foot({5, 5, -2}, {}, 5, 1e-3);
    EXPECT_NEAR(foot.distance, -2, 1e-12);
    EXPECT_LT((foot.normal - Vec3::UnitZ()).norm(), 1e-12);
}

TEST(ContactSearch, OfACentreOnThePartHasTheSurfacesNormal)
{
    const std::vector<Surface> part{test::plane(20, 10)};
    const BallFoot foot = ContactSearch{part}.foot({5, 5, 0}, {}, 5, 1e-3);
    EXPECT_NEAR(foot.distance, 0, 1e-12);
    EXPECT_LT((foot.normal - Vec3::UnitZ()).norm(), 1e-12);
}

TEST(ContactSearch, StaysOnTheBorder)
{
    const std::vector<Surface> part{test::plane(20, 10)};
    const ContactSearch search{part};
    const BallFoot edge = search.foot({23, 5, 4}, {}, 5, 1e-3);
    EXPECT_LT((edge.point - Vec3{20, 5, 0}).norm(), 1e-11);
    EXPECT_NEAR(edge.distance, 5, 1e-12);
    const BallFoot corner = search.foot({-1, -2, 2}, {}, 3, 1e-3);
    EXPECT_LT(corner.point.norm(), 1e-11);
    EXPECT_LT((corner.normal - Vec3{-1, -2, 2} / 3).norm(), 1e-11);
}

TEST(ContactSearch, TakesTheNearestOfSeveralSurfaces)
{
    const std::vector<Surface> part{
        test::plane(20, 10),
        test::parallelogram({0, 10, 0},
                            {-20, 0, 0})};  // beside it, with the opposite orientation
    const ContactSearch search{part};
    EXPECT_EQ(search.surfaces(), 2u);
    EXPECT_EQ(search.foot({-8, 4, 5}, FootPlace{0, 0.5, 0.5}, 5, 1e-3).at.surface, 1u);
    EXPECT_EQ(search.foot({8, 4, 5}, {}, 5, 1e-3).at.surface, 0u);
}

TEST(ContactSearch, CurvatureIsThatOfTheSectionAcross)
{
    const std::vector<Surface> part{nurbs_surface(test::cylinder(20, 40, 0.5, 2.6))};
    const ContactSearch search{part};
    const BallFoot foot = search.foot({10, 3, 30}, {}, 5, 1e3);
    EXPECT_NEAR(search.curvature(foot.at, {0, 1, 0}).value(), 1 / 20.0, 1e-12);
    EXPECT_NEAR(search.curvature(foot.at, {1, 0, 0}).value(), 0, 1e-12);
    // By Euler's formula, at 45 degrees to the principal directions.
    const Vec3 around = Vec3{0, foot.normal.z(), -foot.normal.y()};
    EXPECT_NEAR(search.curvature(foot.at, around + Vec3::UnitX()).value(), 1 / 40.0,
                1e-12);
}

TEST(ContactSearch, NeedsASurface)
{
    EXPECT_THROW((ContactSearch{std::span<const Surface>{}}), DomainError);
}

}  // namespace
}  // namespace endmill
