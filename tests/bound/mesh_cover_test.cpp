// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/mesh_cover.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "bound_surfaces.h"
#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

std::vector<FacetPiece> pieces_of(const TriangleMesh& mesh, double longest_edge)
{
    return facet_pieces(mesh, facets_at_points(mesh), longest_edge);
}

// The sum of the flows in direction t.
double inflow(const std::vector<MeshFlow>& flows, const Vec3& t)
{
    double sum = 0;
    for (const MeshFlow& flow : flows)
        sum += std::max(0.0, flow.flow.dot(t));
    return sum;
}

double covered_area(const MeshCover& cover, const std::vector<FacetPiece>& pieces,
                    const Vec3& centre)
{
    double area = 0;
    cover.visit_covered(centre, [&](std::uint32_t piece, double share) {
        area += share * pieces[piece].area();
    });
    return area;
}

TEST(FacetPieces, KeepTheAreaOfTheFacetsThatFaceTheTool)
{
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {10, 4, 3});
    for (const double longest : {100.0, 3.0, 0.5}) {
        double area = 0;
        for (const FacetPiece& piece : pieces_of(box, longest)) {
            area += piece.area();
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_LE((piece.corners[(k + 1) % 3] - piece.corners[k]).norm(),
                          longest);
                EXPECT_EQ(piece.corners[k].z(), 3);
                // the walls of the box are beyond creases
                EXPECT_EQ(piece.normals[k], Vec3::UnitZ());
            }
        }
        EXPECT_NEAR(area, 40, 1e-9);
    }
}

TEST(FacetPieces, HaveTheNormalsOfASmoothPart)
{
    // a cylinder of radius 20 about the y axis
    const TriangleMesh mesh = test::grid_mesh(40, 3, [](int i, int j) {
        const double angle = (i - 20) * 0.02;
        return Vec3{20 * std::sin(angle), 3.0 * j, 20 * std::cos(angle)};
    });
    for (const FacetPiece& piece : pieces_of(mesh, 1)) {
        const Vec3 middle = piece.middle();
        if (std::abs(middle.x()) > 6)  // the border has facets on one side only
            continue;
        EXPECT_LT((piece.normal() - Vec3{middle.x(), 0, middle.z()}.normalized()).norm(),
                  2e-3);
    }
}

// On a plane the boundary is a circle: the inflow is its diameter, the area that of the disc.
TEST(MeshCover, OfAPlaneIsADisc)
{
    const TriangleMesh mesh = test::flat_mesh(30, 30);
    test::Random random{1};
    const BoundProblem problem = test::usual_problem();
    const double half = plane_half_width(problem);
    for (const double longest : {2.0, 0.6}) {
        const std::vector<FacetPiece> pieces = pieces_of(mesh, longest);
        const MeshCover cover{pieces, problem};
        for (int k = 0; k < 20; ++k) {
            const double x = random.uniform(10, 20);
            const Vec3 centre{x, random.uniform(10, 20), 7.5};
            const double angle = random.uniform(0, 6);
            EXPECT_NEAR(
                inflow(cover.boundary(centre), {std::cos(angle), std::sin(angle), 0}),
                2 * half, 3e-3 * half);
            EXPECT_NEAR(covered_area(cover, pieces, centre),
                        std::numbers::pi * half * half, 1e-2 * half * half);
        }
    }
}

// The inflow is the area that a small move newly covers, also where the flank covers.
TEST(MeshCover, TheInflowIsTheAreaThatASmallMoveNewlyCovers)
{
    // waves with slopes of up to 68 degrees
    constexpr double step = 0.08;
    const auto wave = [](int i, int j) {
        const double x = step * i;
        const double y = step * j;
        return Vec3{x, y, 3 * std::sin(0.8 * x) + 0.5 * std::cos(0.5 * y)};
    };
    const TriangleMesh mesh = test::grid_mesh(300, 300, wave);
    const std::vector<FacetPiece> pieces = pieces_of(mesh, 0.12);
    const BoundProblem problem{BallCutter{2}, 0.2};
    const MeshCover cover{pieces, problem};
    test::Random random{2};
    double all_gained = 0;
    double all_flow = 0;
    for (int k = 0; k < 60; ++k) {
        const int i = static_cast<int>(random.uniform(100, 200));
        const int j = static_cast<int>(random.uniform(100, 200));
        const Vec3 centre = wave(i, j) + Vec3{0, 0, 2.5};
        const double angle = random.uniform(0, 6);
        const Vec3 t{std::cos(angle), std::sin(angle), 0};
        std::vector<double> before(pieces.size());
        cover.visit_covered(centre - 0.02 * t, [&](std::uint32_t piece, double share) {
            before[piece] = share;
        });
        double gained = 0;
        cover.visit_covered(centre + 0.02 * t, [&](std::uint32_t piece, double share) {
            gained += std::max(0.0, share - before[piece]) * pieces[piece].area();
        });
        const double flow = inflow(cover.boundary(centre), t);
        // A piece may gain and lose at once, so that single places differ more.
        EXPECT_NEAR(gained / 0.04, flow, 0.1 * flow + 0.05);
        all_gained += gained / 0.04;
        all_flow += flow;
    }
    EXPECT_NEAR(all_gained, all_flow, 0.02 * all_flow);
}

}  // namespace
}  // namespace endmill
