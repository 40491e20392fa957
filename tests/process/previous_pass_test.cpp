// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/previous_pass.h"

#include <cmath>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

PreviousPassCurve random_curve(test::Random& random)
{
    return PreviousPassCurve{{random.uniform(-1.4, 1.4), random.uniform(-1.3, 1.3),
                              random.uniform(0.02, 1.9), 1}};
}

double value(const PassCondition& condition, const PassPoint& point)
{
    return condition.base + condition.turn * point.cosine + condition.front * point.tau;
}

// Compared with small steps along the curve.
TEST(PreviousPass, ConditionsChangeAtTheSignChanges)
{
    test::Random random{61};
    constexpr int looks = 400;
    int changes_seen = 0;
    for (int n = 0; n < 1500; ++n) {
        const PreviousPassCurve curve = random_curve(random);
        if (curve.first > 0.99)
            continue;
        const PassCondition condition{random.uniform(-1, 1), random.uniform(-1, 1),
                                      n % 5 == 0 ? 0 : random.uniform(-1, 1)};
        const SignChanges changes = sign_changes(curve, condition);
        changes_seen += changes.count;
        for (int k = 0; k < looks; ++k) {
            const double p = curve.first + (1 - curve.first) * (k + 0.5) / looks;
            int passed = 0;
            while (passed < changes.count && changes.at[passed] < p)
                ++passed;
            EXPECT_EQ(value(condition, pass_point(curve, p)) > 0,
                      changes.is_positive == (passed % 2 == 0));
        }
        for (int k = 0; k < changes.count; ++k)
            EXPECT_NEAR(value(condition, pass_point(curve, changes.at[k])), 0, 1e-12);
    }
    EXPECT_GT(changes_seen, 300);
}

TEST(PreviousPass, HasThePointsOfItsParameters)
{
    test::Random random{62};
    for (int n = 0; n < 500; ++n) {
        const PreviousPassCurve curve = random_curve(random);
        if (curve.first > 0.99)
            continue;
        const double p = curve.first + (1 - curve.first) * random.uniform(0.05, 0.95);
        const PassPoint point = pass_point(curve, p);
        EXPECT_NEAR(std::hypot(point.sine, point.cosine), 1, 1e-14);
        EXPECT_NEAR(pass_parameter(curve, point.sine / (1 + point.cosine)), p, 1e-9);
    }
}

}  // namespace
}  // namespace endmill
