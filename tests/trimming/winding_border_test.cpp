// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/winding_border.h"

#include <gtest/gtest.h>

#include "trimmed_curves.h"

namespace endmill {
namespace {

std::vector<WindingBorder> borders(const std::vector<SectionCurve>& curves)
{
    return winding_borders(PlanePoints{curves}, curves);
}

void expect_place(const BorderPlace& place, TrimmedKind kind, int on, int across)
{
    EXPECT_EQ(place.kind, kind);
    EXPECT_EQ(place.on, on);
    EXPECT_EQ(place.across, across);
}

TEST(WindingBorder, GoesOverTheCrossingOfALoop)
{
    const auto found =
        borders({test::open_curve({{-6, 6}, {2, -2}, {0, -1}, {-2, -2}, {6, 6}})});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].is_closed);
    ASSERT_EQ(found[0].places.size(), 3U);
    expect_place(found[0].places[0], TrimmedKind::Vertex, 0, 0);
    expect_place(found[0].places[1], TrimmedKind::Crossing, 0, 3);
    expect_place(found[0].places[2], TrimmedKind::Vertex, 4, 4);
}

// The curve continues to s = 6 and returns to its end at s = 4.
TEST(WindingBorder, EndsStraightBelowTheEndOfACurve)
{
    const auto found = borders({test::open_curve({{0, 0}, {4, 0}, {6, 2}, {4, 4}})});
    ASSERT_EQ(found.size(), 1U);
    ASSERT_EQ(found[0].places.size(), 2U);
    expect_place(found[0].places[0], TrimmedKind::Vertex, 0, 0);
    expect_place(found[0].places[1], TrimmedKind::Vertex, 1, 1);
}

TEST(WindingBorder, OfAClosedCurveRepeatsNoPlace)
{
    const auto found =
        borders({SectionCurve{{{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}}, true}});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].is_closed);
    EXPECT_EQ(found[0].places.size(), 4U);
}

TEST(WindingBorder, WithoutCurvesIsEmpty)
{
    EXPECT_TRUE(borders({}).empty());
    EXPECT_TRUE(borders({test::open_curve({{1, 1}, {1, 1}})}).empty());
}

}  // namespace
}  // namespace endmill
