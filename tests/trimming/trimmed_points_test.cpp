// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/trimmed_points.h"

#include <gtest/gtest.h>

#include "trimmed_curves.h"

namespace endmill {
namespace {

const std::vector curves{test::open_curve({{0, 0}, {4, 2}}),
                         test::open_curve({{0, 2}, {1, 9}, {4, 0}})};

TEST(TrimmedPoints, NameTheirSegments)
{
    const PlanePoints plane{curves};
    const TrimmedPoints points{plane};
    const TrimmedPoint vertex = points.vertex(3);
    EXPECT_EQ(vertex.at, SectionPoint(1, 9));
    EXPECT_EQ(vertex.on, (SegmentNumber{1, 1}));
    const TrimmedPoint crossing = points.crossing(0, 3);  // z = s / 2 and z = 12 - 3 s
    EXPECT_NEAR(crossing.at[0], 24 / 7.0, 1e-15);
    EXPECT_EQ(crossing.across, (SegmentNumber{1, 1}));
    EXPECT_EQ(crossing.kind, TrimmedKind::Crossing);
    const TrimmedPoint link = points.link(0, 3);
    EXPECT_EQ(link.at, SectionPoint(1, 0.5));
    EXPECT_EQ(link.across, (SegmentNumber{1, 1}));
    EXPECT_EQ(link.kind, TrimmedKind::Link);
}

TEST(TrimmedPoints, AreOneWhereTheyAreEqualAndAVertexRatherThanACrossing)
{
    const PlanePoints plane{curves};
    const TrimmedPoints points{plane};
    TrimmedPoint crossing = points.crossing(0, 3);
    const TrimmedPoint vertex = points.vertex(1);
    crossing.at = vertex.at;
    TrimmedCurve curve;
    for (const TrimmedPoint& point : {crossing, vertex, crossing, points.vertex(0)})
        append(curve, point);
    ASSERT_EQ(curve.points.size(), 2u);
    EXPECT_EQ(curve.points[0].kind, TrimmedKind::Vertex);
}

}  // namespace
}  // namespace endmill
