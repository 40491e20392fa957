// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/cover_boundary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/bound/detail/closed_bound.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

using std::numbers::pi;

double inflow(const std::vector<BoundaryFlow>& boundary, double angle)
{
    const Eigen::Vector2d along{std::cos(angle), std::sin(angle)};
    double sum = 0;
    for (const BoundaryFlow& piece : boundary)
        sum += std::max(0.0, piece.flow.dot(along));
    return sum;
}

double total_area(const std::vector<CoveredPiece>& pieces)
{
    double sum = 0;
    for (const CoveredPiece& piece : pieces)
        sum += piece.area;
    return sum;
}

struct Contact {
    test::SidedSurfaces surfaces;
    BoundProblem problem;
    BoundedPart part;
    ContactFrame frame;

    Contact(test::SidedSurfaces all, const BoundProblem& wanted, const SurfacePoint& at)
        : surfaces{std::move(all)},
          problem{wanted},
          part{surfaces.part()},
          frame{*contact_frame(part, problem, contact_place(part, 0, at))}
    {
    }
};

TEST(CoverRays, OnAPlaneSweepTheWidthOfTheDiscInEveryDirection)
{
    const Contact contact{test::dataset("plane"), test::usual_problem(), {1.3, 0.8}};
    const CoverRays rays{contact.part, contact.problem, contact.frame, 72};
    ASSERT_TRUE(rays.is_complete());
    const double width = 2 * plane_half_width(contact.problem);
    for (int k = 0; k < 50; ++k)
        EXPECT_NEAR(inflow(rays.boundary(), 0.13 * k), width, 1e-3 * width);
    EXPECT_NEAR(total_area(rays.covered()), pi * width * width / 4, 1e-9);
    EXPECT_NEAR(rays.elongation(), 1, 1e-12);
}

// With one over the widest arc as density, the inflow on a sphere is sin(alpha) / alpha in
// every direction: the disc's flat diameter is shorter than the arc.
TEST(CoverRays, OnASphereSweepTheFlatDiameterOfTheDisc)
{
    const Contact contact{test::dataset("sphere"), test::usual_problem(), {0.45, 0.6}};
    const CoverRays rays{contact.part, contact.problem, contact.frame, 720};
    constexpr double alpha = 0.0935654826249534;
    for (int k = 0; k < 50; ++k)
        EXPECT_NEAR(inflow(rays.boundary(), 0.13 * k) / (2 * 25 * alpha),
                    0.998541555287601, 1e-5);
    EXPECT_NEAR(total_area(rays.covered()), 2 * pi * 625 * (1 - std::cos(alpha)), 1e-4);
}

TEST(CoverRays, OnASteepPlaneSweepWhatTheFlankCovers)
{
    for (const double degrees : {60.0, 75.0, 80.0}) {
        const double slope = degrees * pi / 180;
        const Contact contact{
            test::SidedSurfaces{{test::parallelogram(
                {60, 0, 0}, {0, 100 * std::cos(slope), 100 * std::sin(slope)})}},
            test::usual_problem(),
            {0.5, 0.5}};
        const CoverRays rays{contact.part, contact.problem, contact.frame, 720};
        const ClosedDensity plane =
            plane_density(contact.problem, Angle::degrees(degrees));
        double greatest = 0;
        for (int k = 0; k < 720; ++k)
            greatest = std::max(greatest, inflow(rays.boundary(), 2 * pi * k / 720));
        EXPECT_NEAR(greatest * plane.density_per_mm, 1, 1e-4);
        EXPECT_NEAR(total_area(rays.covered()) * plane.density_per_mm, plane.disc_mm,
                    1e-3 * plane.disc_mm);
        EXPECT_EQ(rays.elongation() > 1.01, degrees > 70);
    }
}

TEST(CoverRays, EndAtTheBorderOfTheSurface)
{
    const BoundProblem problem = test::usual_problem();
    const double a = plane_half_width(problem);
    // The contact is `inside` mm from the border x = 0.
    for (const double inside : {0.0, 0.5, 2.0, 2.6}) {
        const Contact contact{
            test::SidedSurfaces{{test::plane(100, 100)}}, problem, {inside / 100, 0.5}};
        const CoverRays rays{contact.part, problem, contact.frame, 72};
        ASSERT_TRUE(rays.is_complete());
        double along_border = 0;
        double away = 0;
        for (const BoundaryFlow& piece : rays.boundary()) {
            const Vec3 flow =
                piece.flow.x() * contact.frame.e1 + piece.flow.y() * contact.frame.e2;
            along_border += std::max(0.0, flow.y());
            away += std::max(0.0, flow.x());
        }
        EXPECT_NEAR(along_border, a + inside, 2e-3 * a) << inside;
        EXPECT_NEAR(away, 2 * a, 2e-3 * a) << inside;
    }
}

TEST(CoverRays, ContainWhatTheyHavePassed)
{
    const Contact contact{
        test::SidedSurfaces{{test::plane(100, 100)}}, test::usual_problem(), {0.5, 0.5}};
    const CoverRays rays{contact.part, contact.problem, contact.frame, 72};
    EXPECT_TRUE(rays.contains({0.5, 0.5}));
    EXPECT_TRUE(rays.contains({0.526, 0.5}));
    EXPECT_TRUE(rays.contains({0.5, 0.474}));
    EXPECT_FALSE(rays.contains({0.54, 0.5}));
    EXPECT_FALSE(rays.contains({0.53, 0.53}));
}

TEST(CoverRays, OfTipsArePartsOfThoseOfContacts)
{
    const SurfacePoint at{1.4, 1.6};
    const Contact contact{test::dataset("saddle"), test::usual_problem(), at};
    BoundProblem tips = contact.problem;
    tips.length = BoundedLength::Tip;
    const CoverRays of_contact{contact.part, contact.problem, contact.frame, 72};
    const CoverRays of_tip{contact.part, tips, contact.frame, 72};
    for (std::size_t k = 0; k < 72; ++k) {
        const Eigen::Vector2d c = of_contact.boundary()[k].flow;
        const Eigen::Vector2d t = of_tip.boundary()[k].flow;
        EXPECT_NEAR(c.x(), (1 + 7.5 * contact.frame.k.least) * t.x(), 1e-12);
        EXPECT_NEAR(c.y(), (1 + 7.5 * contact.frame.k.greatest) * t.y(), 1e-12);
    }
}

}  // namespace
}  // namespace endmill
