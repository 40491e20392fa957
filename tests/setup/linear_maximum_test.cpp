// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/linear_maximum.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "random.h"

namespace endmill {
namespace {

// The largest objective over all corners: every three planes, tested against all others.
double by_corners(const LinearMaximum& problem)
{
    const Eigen::Index own = problem.rows.rows();
    Eigen::MatrixXd rows{own + 6, 3};
    Eigen::VectorXd limits{own + 6};
    rows << problem.rows, Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
    limits << problem.limits, Eigen::VectorXd::Constant(6, problem.box);
    double most = -1e300;
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
        for (Eigen::Index j = 0; j < i; ++j)
            for (Eigen::Index k = 0; k < j; ++k) {
                Eigen::Matrix3d planes;
                planes << rows.row(i), rows.row(j), rows.row(k);
                if (std::abs(planes.determinant()) < 1e-9)
                    continue;
                const Eigen::Vector3d at =
                    planes.inverse() * Eigen::Vector3d{limits[i], limits[j], limits[k]};
                if (((rows * at - limits).array() <= 1e-7).all())
                    most = std::max(most, problem.objective.dot(at));
            }
    return most;
}

TEST(LinearMaximum, IsTheBestCorner)
{
    test::Random random{7};
    for (int round = 0; round < 300; ++round) {
        const int count = 1 + round % 12;
        LinearMaximum problem{
            Eigen::MatrixXd{count, 3}, Eigen::VectorXd{count},
            Eigen::Vector3d{random.uniform(-1, 1), random.uniform(-1, 1), 0.0},
            /*box=*/50};
        for (int i = 0; i < count; ++i) {
            for (int k = 0; k < 3; ++k)
                problem.rows(i, k) = random.uniform(-1, 1);
            problem.limits[i] = random.uniform(-1, 20);
        }
        const double expected = by_corners(problem);
        const auto found = linear_maximum(problem);
        ASSERT_EQ(found.has_value(), expected > -1e299) << round;
        if (found) {
            EXPECT_NEAR(problem.objective.dot(*found), expected, 1e-8) << round;
            EXPECT_LE((problem.rows * *found - problem.limits).maxCoeff(), 1e-8);
        }
    }
}

// Many planes through one corner, and pairs of opposite planes that touch.
TEST(LinearMaximum, EndsAtDegenerateCorners)
{
    LinearMaximum problem{Eigen::MatrixXd{40, 3}, Eigen::VectorXd::Zero(40),
                          Eigen::Vector3d::UnitZ()};
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.1 * (i / 2);
        problem.rows.row(i) << std::cos(angle), std::sin(angle), 0.5;
        if (i % 2 == 1)
            problem.rows.row(i) *= -1;
    }
    const auto found = linear_maximum(problem);
    ASSERT_TRUE(found);
    EXPECT_NEAR((*found)[2], 0, 1e-6);
}

TEST(LinearMaximum, IsAtTheBoxWithoutRows)
{
    const LinearMaximum problem{Eigen::MatrixXd{0, 2}, Eigen::VectorXd{0},
                                Eigen::Vector2d{1, -1}, 3};
    EXPECT_EQ(*linear_maximum(problem), (Eigen::VectorXd{{3.0, -3.0}}));
}

TEST(LinearMaximum, HasNoPointBetweenContradictions)
{
    LinearMaximum problem{Eigen::MatrixXd{2, 1}, Eigen::VectorXd{2},
                          Eigen::VectorXd::Ones(1)};
    problem.rows << 1, -1;
    problem.limits << 1, -2;  // x <= 1 and x >= 2
    EXPECT_FALSE(linear_maximum(problem));
}

}  // namespace
}  // namespace endmill
