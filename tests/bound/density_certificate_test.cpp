// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/density_certificate.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "bound_surfaces.h"
#include "endmill/bound/detail/density_search.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// A density that is far too large is divided where it must be; afterwards rays find no
// inflow above 1.
TEST(CertifiedDensity, HasNoInflowAboveOneAtRandomPlaces)
{
    const test::SidedSurfaces saddle{{test::saddle(64, 8)}};
    const BoundProblem problem = test::usual_problem();
    constexpr double spacing = 3;
    const DensityGrid grid{saddle.part(), spacing};
    const std::vector<double> start(grid.nodes(), 0.19);
    const CertifiedDensity found =
        certified_density(saddle.part(), problem, start, {spacing});
    EXPECT_GT(found.greatest_inflow, 1);
    EXPECT_EQ(found.given_up, 0);
    const DensitySearch search{saddle.part(), problem, {spacing, 1000}};
    EXPECT_LE(std::ranges::max(search.inflows_at_random(found.at_nodes, 3000, 5)),
              1.0005);
    EXPECT_GE(std::ranges::max(search.inflows_at_random(found.at_nodes, 3000, 5)), 0.9);
    set_thread_count(1);
    EXPECT_EQ(found.integral,
              certified_density(saddle.part(), problem, start, {spacing}).integral);
    set_thread_count(2);
}

TEST(CertifiedDensity, IsRefusedWhereTheBallCoversASecondSurface)
{
    std::vector<Surface> strips;
    for (int k = 0; k < 4; ++k)
        strips.push_back(
            test::graph(test::monomial(1, 0, 0.0), {{4.0 * k, 4.0 * k + 4}, {-10, 10}}));
    const test::SidedSurfaces part{strips};
    const DensityGrid grid{part.part(), 2};
    const std::vector<double> start(grid.nodes(), 0.18);
    EXPECT_THROW(certified_density(part.part(), test::usual_problem(), start, {2}),
                 GeometryError);
}

}  // namespace
}  // namespace endmill
