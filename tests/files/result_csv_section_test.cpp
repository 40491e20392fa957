// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

const DrivePlanes turned{DriveFrame{Angle::degrees(90)}, {2, 4}};

using Planes = std::vector<PlaneSection>;

PlaneSection section_of(std::vector<SectionCurve> curves)
{
    PlaneSection section;
    section.curves = std::move(curves);
    return section;
}

TEST(SectionCsv, WritesReferencePointsWhereThePlanesStand)
{
    const Planes planes{section_of({{{{0, 1}, {3, 1.5}}, false}}), {}};
    EXPECT_EQ(sections_csv(planes, &turned),
              "plane,curve,point,s_mm,x_mm,y_mm,z_mm\n"
              "0,0,0,0,-2,0,1\n"
              "0,0,1,3,-2,3,1.5\n");
}

TEST(SectionCsv, LeavesPlacesEmptyThatAreNotKnown)
{
    const Planes planes{{}, section_of({{{{0, 1}, {3, 1.5}}, false}})};
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

// One piece is the header, and one the rows of each plane, so that a reader of the pieces
// knows how much is written.
TEST(SectionCsv, IsWrittenInPiecesOfOnePlaneEach)
{
    constexpr std::size_t count = 200;
    const Planes planes(count, section_of({{{{0, 1}, {3, 1.5}}, false}}));
    std::vector<std::string> pieces;
    write_sections_csv(planes, nullptr,
                       [&](std::string_view piece) { pieces.emplace_back(piece); });
    ASSERT_EQ(pieces.size(), 1 + count);
    std::string text;
    for (const std::string& piece : pieces)
        text += piece;
    EXPECT_EQ(text, sections_csv(planes, nullptr));
    for (std::size_t k = 0; k < count; ++k)
        EXPECT_TRUE(pieces[1 + k].starts_with(std::to_string(k) + ",0,0,0,")) << k;
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
    const Planes odd{section_of({{{{0, NAN}, {1, 0}}, false}})};
    EXPECT_THROW(sections_csv(odd, nullptr), DomainError);
    const Planes three{{}, {}, {}};
    EXPECT_THROW(sections_csv(three, &turned), DomainError);
}

}  // namespace
}  // namespace endmill
