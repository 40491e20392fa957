// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/adaptive_fit.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/setup/detail/axis_node.h"
#include "random_maps.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class ManyCaps : public testing::Test {
protected:
    ManyCaps()
    {
        for (const std::size_t cell : cones_.cells())
            centres_.push_back(grid_.centres[cell]);
        for (std::size_t k = 0; k < cones_.size(); ++k)
            numbers_.push_back(k);
    }

    ConeFitting fitting(RotaryFamily family, SetupObjective objective,
                        const ConeSet* cones = nullptr) const
    {
        return {cones, centres_, {family, objective, 0.1}, RangeLimits{family, {}}};
    }

    test::Random random_{42};
    SphereGrid grid_ = sphere_grid("hex:4");
    VisibilityMap map_ = test::random_caps(200, grid_.centres, random_);
    MinimalCones cones_{grid_, map_};
    std::vector<Vec3> centres_;
    std::vector<std::size_t> numbers_;
};

TEST_F(ManyCaps, AreFittedFromThreeOfThemAsAllAtOnce)
{
    const ConeSet all = cones_.selected(numbers_);
    const std::vector<std::size_t> three{0, cones_.size() / 2, cones_.size() - 1};
    using enum SetupObjective;
    for (const SetupObjective objective : {FlooredArea, TotalRange, Tilt})
        for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
            AxisFitter every{fitting(family, objective, &all)};
            AdaptiveFitter some{cones_, fitting(family, objective)};
            for (int trial = 0; trial < 10; ++trial) {
                const Vec3 axis = test::random_direction(random_);
                some.begin_with(three);
                const auto fit = some.best(axis, {infinity});
                const auto expected = every.best(axis, {infinity});
                ASSERT_TRUE(fit && expected);
                EXPECT_NEAR(fit->objective, expected->objective,
                            1e-12 * expected->objective);
                EXPECT_LT(some.set().size(), cones_.size());
                EXPECT_FALSE(some.best(axis, {expected->objective * (1 - 1e-12)}));
            }
        }
}

// The ranges meet all cones, the bound knows three of them and those that it adds.
TEST_F(ManyCaps, HaveNodesWithBoundsBelowEveryFit)
{
    const ConeSet all = cones_.selected(numbers_);
    const std::vector<std::size_t> three{0, cones_.size() / 2, cones_.size() - 1};
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        AxisFitter every{fitting(family, SetupObjective::FlooredArea, &all)};
        AdaptiveFitter some{cones_, fitting(family, SetupObjective::FlooredArea)};
        NodeBounder bounder{some.fitting()};
        const std::vector<AxisNode> roots = root_nodes(every.fitting());
        for (std::size_t k = 0; k < roots.size(); k += 29) {
            AxisNode node = part(roots[k], 3);
            while (radius(node) > 0.04)
                node = part(node, 3);
            some.begin_with(three);
            bounder.bound(node, infinity, [&](std::span<const std::uint32_t> cells) {
                return some.grow(cells);
            });
            EXPECT_GT(some.set().size(), three.size());
            for (const Vec3& axis : {centre(node), node.corners[0], node.corners[1]})
                EXPECT_LE(node.bound, every.best(axis, {infinity})->objective);
        }
    }
}

}  // namespace
}  // namespace endmill
