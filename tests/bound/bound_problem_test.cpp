// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/bound_problem.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(PlaneHalfWidth, IsHalfTheChordOfTheBallAtTheScallopHeight)
{
    BoundProblem problem{BallCutter{7.5}, 0.5};
    EXPECT_NEAR(2 * plane_half_width(problem), 5.38516480713450, 1e-13);
    const double strays[] = {0.01, 0.05, 0.5};
    for (const double stray : strays) {
        problem.stray = stray;
        const double chord = 2 * std::sqrt(std::pow(7.5 + stray, 2) - 49);
        EXPECT_NEAR(2 * plane_half_width(problem), chord, 1e-12);
    }
}

TEST(BoundProblem, IsCheckedForItsDomain)
{
    const BallCutter ball{2};
    EXPECT_NO_THROW(require_valid({ball, 0.5}));
    EXPECT_THROW(require_valid({ball, 0}), DomainError);
    EXPECT_THROW(require_valid({ball, 2}), DomainError);
    EXPECT_THROW(require_valid({ball, std::nan("")}), DomainError);
    EXPECT_THROW(require_valid({ball, 0.5, -0.1}), DomainError);
    EXPECT_THROW(require_valid({ball, 0.5, 2.1}), DomainError);
    BoundProblem none{ball, 0.5};
    none.most_pieces = 0;
    EXPECT_THROW(require_valid(none), DomainError);
}

}  // namespace
}  // namespace endmill
