// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/raised_cells.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

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

// Rays and marching triangles share no code but the flow of a piece.
TEST(RaisedCells, GiveTheBoundaryThatTheRaysGive)
{
    for (const char* const name : {"saddle", "net_rot24_7D", "sphere", "wavy"}) {
        const test::SidedSurfaces part = test::dataset(name);
        const BoundedPart bounded = part.part();
        const BoundProblem problem = test::usual_problem();
        const RaisedCells cells{bounded, problem, 1};
        const Interval u = part.surfaces[0].range(Parameter::U);
        const Interval v = part.surfaces[0].range(Parameter::V);
        for (const double share : {0.02, 0.21, 0.47, 0.73, 1.0}) {
            const SurfacePoint at{std::lerp(u.low, u.high, share),
                                  std::lerp(v.low, v.high, 0.37)};
            const ContactFrame frame =
                *contact_frame(bounded, problem, contact_place(bounded, 0, at));
            const CoverRays rays{bounded, problem, frame, 288};
            ASSERT_TRUE(rays.is_complete());
            EXPECT_TRUE(cells.has_only(frame, rays)) << name << share;
            const auto by_cells = cells.boundary(frame);
            for (int k = 0; k < 12; ++k) {
                const double by_rays = inflow(rays.boundary(), 0.5 * k);
                EXPECT_NEAR(inflow(by_cells, 0.5 * k), by_rays, 0.004 * by_rays + 0.002)
                    << name << " " << share;
            }
            const double area = total_area(rays.covered());
            EXPECT_NEAR(total_area(cells.covered(frame)), area, 0.01 * area)
                << name << " " << share;
        }
    }
}

// A plane in two surfaces, and the same plane in one.
TEST(RaisedCells, FindTheSetOnASecondSurface)
{
    const BoundProblem problem = test::usual_problem();
    Surface right = test::polynomial_surface(
        {test::monomial(1, 0, 1), test::monomial(0, 1, 1), test::Polynomial::Zero()},
        {{30, 60}, {0, 40}});
    const test::SidedSurfaces two{{test::plane(30, 40), std::move(right)}};
    const test::SidedSurfaces one{{test::plane(60, 40)}};
    const BoundedPart in_two = two.part();
    const BoundedPart in_one = one.part();
    const RaisedCells cells{in_two, problem, 1};
    const ContactFrame frame =
        *contact_frame(in_two, problem, contact_place(in_two, 0, {0.97, 0.5}));
    const CoverRays rays{in_two, problem, frame, 72};
    EXPECT_FALSE(cells.has_only(frame, rays));
    const ContactFrame whole =
        *contact_frame(in_one, problem, contact_place(in_one, 0, {0.485, 0.5}));
    const CoverRays whole_rays{in_one, problem, whole, 288};
    for (int k = 0; k < 12; ++k) {
        const double wanted = inflow(whole_rays.boundary(), 0.5 * k);
        EXPECT_NEAR(inflow(cells.boundary(frame), 0.5 * k), wanted, 0.004 * wanted);
    }
}

// On the torus, around which u is closed, contacts at the seam cover the same as elsewhere.
TEST(RaisedCells, FindTheSetAcrossTheSeamOfAClosedSurface)
{
    const test::SidedSurfaces torus = test::dataset("torus");
    const BoundedPart part = torus.part();
    const BoundProblem problem = test::usual_problem();
    const RaisedCells cells{part, problem, 1};
    const auto set = [&](double u) {
        const ContactFrame frame =
            *contact_frame(part, problem, contact_place(part, 0, {u, 0.9}));
        const CoverRays rays{part, problem, frame, 144};
        EXPECT_EQ(cells.has_only(frame, rays), u != 0) << u;
        return u == 0 ? cells.boundary(frame) : rays.boundary();
    };
    const auto at_seam = set(0);
    const auto elsewhere = set(2);
    for (int k = 0; k < 12; ++k)
        EXPECT_NEAR(inflow(at_seam, 0.5 * k), inflow(elsewhere, 0.5 * k), 0.02);
}

}  // namespace
}  // namespace endmill
