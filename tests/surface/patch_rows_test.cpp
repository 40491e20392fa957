// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/patch_rows.h"

#include <vector>

#include <gtest/gtest.h>

#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

constexpr double coordinate_rounding = 1e-12;

SurfaceTangents tangents_in(const TangentRow& row, Eigen::Index i)
{
    return {row.row(i).segment<3>(0), row.row(i).segment<3>(3), row.row(i).segment<3>(6)};
}

TEST(PatchRows, AreTheTangentsOfEachPlaceOfAnyPatch)
{
    const std::vector u{0.0, 0.125, 0.4, 0.7, 1.0};
    for (const bool rational : {false, true})
        for (const int degree_u : {1, 2, 3, 4, 25})
            for (const int degree_v : {1, 3, 7}) {
                const BezierPatch patch =
                    test::random_patch(5, degree_u, degree_v, rational);
                const PatchRows rows{degree_u, u};
                EXPECT_EQ(rows.degree(), degree_u);
                for (const double v : {0.0, 0.3, 1.0}) {
                    const TangentRow row = rows.at(patch, v);
                    ASSERT_EQ(row.rows(), 5);
                    for (Eigen::Index i = 0; i < 5; ++i) {
                        const SurfaceTangents one = tangents_in(row, i);
                        const SurfaceTangents other =
                            patch.tangents(u[static_cast<std::size_t>(i)], v);
                        const double size = 1 + other.du.norm() + other.dv.norm();
                        EXPECT_LE((one.point - other.point).norm(), coordinate_rounding);
                        EXPECT_LE((one.du - other.du).norm(), coordinate_rounding * size);
                        EXPECT_LE((one.dv - other.dv).norm(), coordinate_rounding * size);
                    }
                }
            }
}

// z = x^2 y over 0 <= x <= 2, 1 <= y <= 3, where x = 2 u and y = 1 + 2 v.
TEST(PatchRows, AreThoseOfAPolynomialInClosedForm)
{
    const Surface surface = test::graph(test::monomial(2, 1, 1), {{0, 2}, {1, 3}});
    const std::vector u{0.0, 0.1, 0.55, 1.0};
    const PatchRows rows{3, u};
    for (const double v : {0.0, 0.25, 0.9}) {
        const TangentRow row = rows.at(surface.patch(0, 0), v);
        for (Eigen::Index i = 0; i < row.rows(); ++i) {
            const double x = 2 * u[static_cast<std::size_t>(i)];
            const double y = 1 + 2 * v;
            const SurfaceTangents at = tangents_in(row, i);
            EXPECT_LE((at.point - Vec3{x, y, x * x * y}).norm(), coordinate_rounding);
            EXPECT_LE((at.du - Vec3{2, 0, 4 * x * y}).norm(), 10 * coordinate_rounding);
            EXPECT_LE((at.dv - Vec3{0, 2, 2 * x * x}).norm(), 10 * coordinate_rounding);
        }
    }
}

TEST(PatchRows, OfNoPlacesAreEmpty)
{
    const std::vector<double> none;
    const BezierPatch patch = test::random_patch(1, 3, 3, false);
    EXPECT_EQ((PatchRows{3, none}.at(patch, 0.5).rows()), 0);
}

}  // namespace
}  // namespace endmill
