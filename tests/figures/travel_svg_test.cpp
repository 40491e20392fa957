// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/travel_svg.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(DirectionTravelSvg, NamesItsCurvesAndAxes)
{
    const std::vector<DirectionTravel> travel{{Angle::degrees(0), 100, 120},
                                              {Angle::degrees(90), 110, 90}};
    const std::string text = direction_travel_svg(travel, {"Part A", {"ball:15"}});
    for (const char* label : {"Part A", "ball:15", "by contacts", "by tips", "length, mm",
                              "direction of passes, degrees"})
        EXPECT_THAT(text, testing::HasSubstr(label));
}

TEST(DirectionTravelSvg, RefusesFallingDirectionsAndNonFiniteLengths)
{
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(
        direction_travel_svg(std::vector<DirectionTravel>{{Angle::degrees(9), 1, 1},
                                                          {Angle::degrees(0), 1, 1}},
                             {}),
        DomainError);
    EXPECT_THROW(direction_travel_svg(
                     std::vector<DirectionTravel>{{Angle::degrees(0), infinity, 1}}, {}),
                 DomainError);
}

}  // namespace
}  // namespace endmill
