// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/contact_height.h"

#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// z = f(x, y) = 0.1 x^2 + 0.05 x y - 0.02 y^3 + 0.3 x over (u, v), with x = 2 u and y = v
// + 0.1 u^2.
SurfaceJet bent(double u, double v)
{
    const double x = 2 * u;
    const double y = v + 0.1 * u * u;
    const double fx = 0.2 * x + 0.05 * y + 0.3;
    const double fy = 0.05 * x - 0.06 * y * y;
    const double fyy = -0.12 * y;
    const double yu = 0.2 * u;
    return {{x, y, 0.1 * x * x + 0.05 * x * y - 0.02 * y * y * y + 0.3 * x},
            {2, yu, 2 * fx + yu * fy},
            {0, 1, fy},
            {0, 0.2, 4 * 0.2 + 2 * 2 * yu * 0.05 + yu * yu * fyy + 0.2 * fy},
            {0, 0, 2 * 0.05 + yu * fyy},
            {0, 0, fyy}};
}

const Cutter cutters[] = {Cutter::ball(5), Cutter{5, 2}, Cutter::flat(5)};
const Eigen::Vector2d axis{1.2, -0.4};

TEST(ContactHeight, IsTheHeightOfTheProfileOverThePoint)
{
    for (const Cutter& cutter : cutters)
        for (const auto& [u, v] : {std::pair{1.5, 2.0}, {0.5, 0.1}, {-1.0, 1.0}}) {
            const SurfaceJet jet = bent(u, v);
            const auto found = contact_height(jet, cutter, axis);
            ASSERT_TRUE(found);
            const double rho = (jet.point.head<2>() - axis).norm();
            EXPECT_NEAR(found->value,
                        jet.point.z() + cutter.corner_radius() - cutter.profile(rho),
                        1e-14);
            EXPECT_NEAR(found->rim, (rho * rho - 25) / 2, 1e-13);
        }
}

TEST(ContactHeight, DerivativesAreThoseOfTheHeight)
{
    constexpr double h = 1e-5;  // central differences: error about h^2 and 1e-16 / h
    for (const Cutter& cutter : cutters)
        for (const auto& [at_u, at_v] : {std::pair{1.7, 2.0}, {2.0, -1.5}, {-0.7, 1.0}}) {
            const double u = at_u;
            const double v = at_v;
            const auto at = [&](double du, double dv, const Eigen::Vector2d& by) {
                return *contact_height(bent(u + du, v + dv), cutter, axis + by);
            };
            const Eigen::Vector2d still = Eigen::Vector2d::Zero();
            const ContactHeight here = at(0, 0, still);
            for (const int k : {0, 1}) {
                const Eigen::Vector2d way = h * Eigen::Vector2d::Unit(k);
                const ContactHeight more = at(way.x(), way.y(), still);
                const ContactHeight less = at(-way.x(), -way.y(), still);
                EXPECT_NEAR(here.gradient[k], (more.value - less.value) / (2 * h), 1e-8);
                EXPECT_NEAR(here.rim_gradient[k], (more.rim - less.rim) / (2 * h), 1e-8);
                EXPECT_LT(
                    (here.hessian.col(k) - (more.gradient - less.gradient) / (2 * h))
                        .norm(),
                    1e-8);
                EXPECT_LT((here.rim_hessian.col(k) -
                           (more.rim_gradient - less.rim_gradient) / (2 * h))
                              .norm(),
                          1e-8);
                EXPECT_NEAR(here.slope[k],
                            (at(0, 0, way).value - at(0, 0, -way).value) / (2 * h), 1e-8);
            }
        }
}

TEST(ContactHeight, IsSmoothOverTheTipOfABall)
{
    const auto tip = contact_height(bent(0.6, -0.436), Cutter::ball(5), axis);
    ASSERT_TRUE(tip);
    EXPECT_TRUE(tip->hessian.allFinite());
    EXPECT_NEAR(tip->gradient.x(), bent(0.6, -0.436).du.z(), 1e-12);
}

TEST(ContactHeight, IsNoneBesideTheCutter)
{
    SurfaceJet jet = bent(0, 0);
    jet.point = {axis.x() + 3, axis.y() + 4, 0};  // on the rim
    EXPECT_TRUE(contact_height(jet, Cutter::flat(5), axis));
    EXPECT_FALSE(contact_height(jet, Cutter::ball(5), axis));
    EXPECT_FALSE(contact_height(jet, Cutter(5, 2), axis));
    jet.point.x() += 1e-6;
    EXPECT_FALSE(contact_height(jet, Cutter::flat(5), axis));
}

}  // namespace
}  // namespace endmill
