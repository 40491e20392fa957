// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using Planes = std::vector<std::vector<SectionCurve>>;

const DrivePlanes turned{DriveFrame{Angle::degrees(90)}, {2, 4}};

TEST(SectionCsv, WritesReferencePointsWhereThePlanesStand)
{
    const Planes planes{{{{{0, 1}, {3, 1.5}}, false}}, {}};
    EXPECT_EQ(sections_csv(planes, &turned),
              "plane,curve,point,s_mm,x_mm,y_mm,z_mm\n"
              "0,0,0,0,-2,0,1\n"
              "0,0,1,3,-2,3,1.5\n");
}

TEST(SectionCsv, LeavesPlacesEmptyThatAreNotKnown)
{
    const Planes planes{{}, {{{{0, 1}, {3, 1.5}}, false}}};
    EXPECT_EQ(sections_csv(planes, nullptr),
              "plane,curve,point,s_mm,x_mm,y_mm,z_mm\n"
              "1,0,0,0,,,1\n"
              "1,0,1,3,,,1.5\n");
}

TEST(SectionCsv, WritesTheTrimmedCurves)
{
    Trimmed plane;
    plane.curves.resize(1);
    plane.curves[0].points = {{{5, 6}, {0, 0}, {0, 0}, TrimmedKind::Vertex},
                              {{7, 8}, {0, 1}, {0, 3}, TrimmedKind::Crossing}};
    EXPECT_EQ(trimmed_csv(std::span{&plane, 1}, nullptr),
              "plane,curve,point,s_mm,x_mm,y_mm,z_mm\n"
              "0,0,0,5,,,6\n"
              "0,0,1,7,,,8\n");
}

TEST(SectionCsv, WritesRemovedStretchesAndOnRequestTheRule)
{
    const std::vector<std::vector<CutOut>> planes{
        {},
        {{0, 3, 9, CutCause::Fold, SectionPoint{1.5, 2}, "P4"},
         {1, 0, 4, CutCause::Closed, std::nullopt, "closed"}}};
    EXPECT_EQ(loops_csv(planes, LoopColumns::Cause),
              "plane,curve,s_mm,z_mm,first_point,last_point,cause\n"
              "1,0,1.5,2,3,9,fold\n"
              "1,1,,,0,4,closed\n");
    EXPECT_EQ(loops_csv(planes, LoopColumns::CauseAndRule),
              "plane,curve,s_mm,z_mm,first_point,last_point,cause,rule\n"
              "1,0,1.5,2,3,9,fold,P4\n"
              "1,1,,,0,4,closed,closed\n");
}

TEST(SectionCsv, RefusesNonFiniteNumbersAndPlanesWithoutAPosition)
{
    const Planes odd{{{{{0, NAN}, {1, 0}}, false}}};
    EXPECT_THROW(sections_csv(odd, nullptr), DomainError);
    const Planes three{{}, {}, {}};
    EXPECT_THROW(sections_csv(three, &turned), DomainError);
}

}  // namespace
}  // namespace endmill
