// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/box_search.h"

#include <cmath>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

SearchBox cube(Eigen::Index dimension, double low, double high)
{
    return {VectorXd::Constant(dimension, low), VectorXd::Constant(dimension, high)};
}

double rosenbrock(const VectorXd& x)
{
    return 1 + 100 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1 - x[0], 2);
}

TEST(BoxSearch, FindsTheBottomOfRosenbrocksValley)
{
    for (const Vector2d& start : {Vector2d{-1.2, 1}, {2, -2}, {0, 0}}) {
        const BoxMinimum found = minimize_in_box(rosenbrock, cube(2, -3, 3), start, 0.1);
        EXPECT_NEAR(found.value, 1, 1e-14);
        EXPECT_LT((found.at - Vector2d{1, 1}).norm(), 1e-7);
    }
}

// A quadratic function with its minimum 2 at `bottom`, rotated axes and unequal widths.
double bowl(const VectorXd& x, const VectorXd& bottom)
{
    double square = 2;
    double sum = 0;
    for (Eigen::Index k = 0; k < x.size(); ++k) {
        sum += x[k] - bottom[k];
        square += double(k + 1) * sum * sum;
    }
    return square;
}

TEST(BoxSearch, KeepsTheAccuracyItStatesOnBowlsOfTwoAndFourDimensions)
{
    test::Random random{1};
    for (const Eigen::Index dimension : {2, 4})
        for (int k = 0; k < 50; ++k) {
            VectorXd bottom{dimension};
            VectorXd start{dimension};
            for (Eigen::Index axis = 0; axis < dimension; ++axis) {
                bottom[axis] = random.uniform(-0.9, 0.9);
                start[axis] = random.uniform(-1, 1);
            }
            const BoxMinimum found =
                minimize_in_box([&](const VectorXd& x) { return bowl(x, bottom); },
                                cube(dimension, -1, 1), start, 0.05);
            EXPECT_LE(std::abs(found.value - 2), 2e-14) << dimension << ' ' << k;
            EXPECT_LT((found.at - bottom).lpNorm<Eigen::Infinity>(), 1e-7);
        }
}

TEST(BoxSearch, ReturnsThePlaceOfItsValue)
{
    const BoxMinimum found =
        minimize_in_box(rosenbrock, cube(2, -3, 3), Vector2d{-1, -1}, 0.2);
    EXPECT_EQ(rosenbrock(found.at), found.value);
}

TEST(BoxSearch, StopsAtTheCornerThatASlopePointsTo)
{
    const auto slope = [](const VectorXd& x) { return 5 + x[0] - 2 * x[1]; };
    for (const Vector2d& start : {Vector2d{0.5, 0.5}, {0, 1}, {1, 0}, {0, 0}, {1, 1}}) {
        const BoxMinimum found = minimize_in_box(slope, cube(2, 0, 1), start, 0.03);
        EXPECT_NEAR(found.at[0], 0, 1e-10);
        EXPECT_NEAR(found.at[1], 1, 1e-10);
        EXPECT_NEAR(found.value, 3, 1e-10);
    }
}

TEST(BoxSearch, FollowsASideToItsLowestPlace)
{
    const auto valley = [](const VectorXd& x) {
        return 1 + x[0] + std::pow(x[1] - 0.3, 2);
    };
    const BoxMinimum found =
        minimize_in_box(valley, cube(2, 0, 1), Vector2d{0.9, 0.9}, 0.03);
    EXPECT_EQ(found.at[0], 0);
    EXPECT_NEAR(found.at[1], 0.3, 1e-7);
}

TEST(BoxSearch, NeverLeavesTheBox)
{
    bool has_left = false;
    const SearchBox box{Vector2d{-1, 2}, Vector2d{3, 2.5}};
    const auto watched = [&](const VectorXd& x) {
        has_left |= (x.array() < box.low.array()).any();
        has_left |= (x.array() > box.high.array()).any();
        return std::sin(5 * x[0]) * std::cos(7 * x[1]);
    };
    test::Random random{2};
    for (int k = 0; k < 20; ++k) {
        const Vector2d start{random.uniform(-1, 3), random.uniform(2, 2.5)};
        const BoxMinimum found = minimize_in_box(watched, box, start, 0.1);
        EXPECT_LE(found.value, watched(start));
    }
    EXPECT_FALSE(has_left);
}

TEST(BoxSearch, AStepWiderThanTheBoxStillFindsTheMinimum)
{
    const auto bottom = [](const VectorXd& x) {
        return 1 + std::pow(x[0] - 0.4, 2) + std::pow(x[1] - 0.6, 2);
    };
    for (const Vector2d& start : {Vector2d{0, 0}, {1, 1}, {0.2, 0.7}}) {
        const BoxMinimum found = minimize_in_box(bottom, cube(2, 0, 1), start, 3);
        EXPECT_NEAR(found.value, 1, 1e-14) << start.transpose();
    }
}

TEST(BoxSearch, AFlatFunctionAndAnEmptyBoxKeepTheStart)
{
    const auto flat = [](const VectorXd&) { return 7.0; };
    EXPECT_EQ(minimize_in_box(flat, cube(2, 0, 1), Vector2d{0.5, 0.5}, 0.1).value, 7);
    const BoxMinimum point =
        minimize_in_box(rosenbrock, cube(2, 0.5, 0.5), Vector2d{0.5, 0.5}, 0.1);
    EXPECT_EQ(point.at, Vector2d(0.5, 0.5));
    EXPECT_EQ(point.value, rosenbrock(Vector2d{0.5, 0.5}));
}

TEST(BoxSearch, AvoidsInfiniteValues)
{
    const double infinity = std::numeric_limits<double>::infinity();
    const auto walled = [&](const VectorXd& x) {
        return x[0] < 0.2 ? infinity : std::pow(x[0] - 0.25, 2) + x[1] * x[1] + 1;
    };
    const BoxMinimum found =
        minimize_in_box(walled, cube(2, -1, 1), Vector2d{0.9, 0.7}, 0.05);
    EXPECT_NEAR(found.value, 1, 1e-14);
}

}  // namespace
}  // namespace endmill
