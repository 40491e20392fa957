// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/sampling_levels.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "revolved_surfaces.h"
#include "test_surfaces.h"

namespace endmill {
namespace {

// A trough of curvature k and width w mm needs n parts with k (w/n)^2 / 8 <= tolerance.
TEST(SamplingLevels, OfATroughAreThoseOfItsSagitta)
{
    const Surface trough = test::parabolic_cylinder(0.04, 20, 30);
    for (const double tolerance : {0.6, 0.1, 0.01, 0.001}) {
        const SamplingLevels levels{trough, tolerance};
        const double parts = std::sqrt(0.04 * 40 * 40 / 8 / tolerance);
        EXPECT_EQ(levels.patch(0, 0).u, std::ceil(std::log2(parts)));
        EXPECT_EQ(levels.patch(0, 0).v, 0);
        EXPECT_NEAR(levels.chord_error_mm(),
                    0.04 * 1600 / 8 / std::exp2(2 * levels.patch(0, 0).u), 1e-12);
    }
}

TEST(SamplingLevels, OfASideAreTheFinerOnes)
{
    const Surface valley{{0, 1, 2},
                         {0, 1},
                         {test::plane(10, 10).patch(0, 0),
                          test::parabolic_cylinder(0.2, 20, 30).patch(0, 0)}};
    const SamplingLevels levels{transposed(valley), 0.01};
    EXPECT_EQ(levels.side(Parameter::U, 0, 0), 0);
    EXPECT_EQ(levels.side(Parameter::U, 0, 1), levels.patch(0, 1).u);
    EXPECT_EQ(levels.side(Parameter::V, 0, 1), levels.patch(0, 1).v);
    EXPECT_GT(levels.triangles(), 2);
}

TEST(SamplingLevels, MeetingSidesTakeTheGreaterLevel)
{
    const std::vector<Surface> two{
        test::graph(test::monomial(0, 0, 0), {{-10, 0}, {0, 10}}),
        test::graph(test::monomial(2, 1, 0.02), {{0, 10}, {0, 10}})};
    std::vector<SamplingLevels> levels{SamplingLevels{two[0], 0.01},
                                       SamplingLevels{two[1], 0.01}};
    levels[1].raise_side(Parameter::V, 0, 0, 5);
    ASSERT_TRUE(match_meeting_sides(two, levels));
    EXPECT_EQ(levels[0].side(Parameter::V, 1, 0), 5);
    EXPECT_EQ(levels[0].side(Parameter::V, 0, 0), 0);
}

TEST(SamplingLevels, DividingASurfaceWithoutGapsGivesItself)
{
    EXPECT_EQ(parted_at_gaps(test::random_surface(1, {3, 2})).size(), 1U);
}

TEST(SamplingLevels, RefuseAToleranceThatIsRounding)
{
    EXPECT_THROW((SamplingLevels{test::saddle(20, 10), 1e-15}), LimitError);
}

TEST(GridCellError, OfATwistedCellIsItsClosedForm)
{
    // z = x y over the unit square against the planes of its two triangles
    const Surface twist = test::graph(test::monomial(1, 1, 1), {{0, 1}, {0, 1}});
    double expected = 0;
    for (const double s : {0.125, 0.375, 0.625, 0.875})
        for (const double t : {0.125, 0.375, 0.625, 0.875})
            expected = std::max(expected, std::abs(s * t - std::min(s, t)));
    EXPECT_NEAR(grid_cell_error(twist, {0, 0}, {1, 1}), expected, 1e-15);
}

}  // namespace
}  // namespace endmill
