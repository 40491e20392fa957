// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/direction_count.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(DirectionCount, CountsFromOneAndMayHaveNoListener)
{
    std::vector<std::size_t> heard;
    const std::function<void(std::size_t)> report = [&](std::size_t done) {
        heard.push_back(done);
    };
    DirectionCount count{report};
    for (int k = 0; k < 3; ++k)
        count.one_more();
    EXPECT_EQ(heard, (std::vector<std::size_t>{1, 2, 3}));
    const std::function<void(std::size_t)> nobody;
    DirectionCount silent{nobody};
    silent.one_more();
}

TEST(RequireUnitDirections, RefusesOtherLengths)
{
    using Directions = std::vector<Vec3>;
    require_unit_directions(Directions{{0.6, 0, 0.8}, {0, -1 + 1e-10, 0}});
    EXPECT_THROW(require_unit_directions(Directions{{0, 0, 0}}), DomainError);
    EXPECT_THROW(require_unit_directions(Directions{{0, 0, 1}, {0, 1.000001, 0}}),
                 DomainError);
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(require_unit_directions(Directions{{0, nothing, 0}}), DomainError);
}

}  // namespace
}  // namespace endmill
