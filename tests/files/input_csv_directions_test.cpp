// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/input_csv.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::HasSubstr;

std::string input_csv_directions_complaint(const std::string& text)
{
    return complaint_of([&] { parse_directions(text, "f"); });
}

TEST(DirectionsCsv, AreUnitVectorsByAzimuthAndPolarAngle)
{
    const std::vector<Vec3> read = parse_directions(
        "polar_deg,azimuth_deg\n0,77\n90,0\n90,-270\n60,45\n180,0\n90,36000\n", "f");
    ASSERT_EQ(read.size(), 6U);
    const double half = std::sqrt(3.0 / 8);  // sin 60 cos 45
    const std::vector<Vec3> expected{{0, 0, 1},         {1, 0, 0},  {0, 1, 0},
                                     {half, half, 0.5}, {0, 0, -1}, {1, 0, 0}};
    for (std::size_t i = 0; i < read.size(); ++i)
        EXPECT_LT((read[i] - expected[i]).norm(), 1e-15) << i;
}

TEST(DirectionsCsv, NameTheWrongLine)
{
    EXPECT_THAT(input_csv_directions_complaint("azimuth_deg,polar_deg\n"),
                HasSubstr("no row"));
    EXPECT_THAT(input_csv_directions_complaint("azimuth_deg,polar_deg\n1,181\n"),
                HasSubstr("f:2: polar_deg is \"181\"; expected a number from 0 to 180"));
    EXPECT_THAT(input_csv_directions_complaint("azimuth_deg,polar_deg\n1,2\nnan,2\n"),
                HasSubstr("f:3: azimuth_deg is \"nan\""));
    EXPECT_THAT(input_csv_directions_complaint("azimuth_deg,polar_deg\n1,\n"),
                HasSubstr("polar_deg is empty"));
    EXPECT_THAT(input_csv_directions_complaint("azimuth_de,polar_deg\n1,2\n"),
                HasSubstr("did you mean \"azimuth_deg\"?"));
}

}  // namespace
}  // namespace endmill
