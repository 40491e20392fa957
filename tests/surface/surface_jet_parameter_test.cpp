// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/surface_jet.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

static_assert(Parameter::U != Parameter::V);
static_assert(Interval{2, 2}.low == Interval{2, 2}.high);

TEST(Interval, LengthIsHighLessLow)
{
    for (const Interval interval : {Interval{-3, 5}, {0, 0}, {1e300, 1.5e300}})
        EXPECT_EQ(interval.low + interval.length(), interval.high);
}

TEST(SurfacePoint, NamesUBeforeV)
{
    const auto [u, v] = SurfacePoint{1, 2};
    EXPECT_EQ(u, 1);
    EXPECT_EQ(v, 2);
}

TEST(PlaceText, IsAPlaceAndItsPointInRoundedNumbers)
{
    EXPECT_EQ(place_text({1.5, 0}, {30, -0.1, 12}), "u = 1.5, v = 0 (30, -0.1, 12 mm)");
    EXPECT_EQ(place_text({1.0 / 3, -0.0}, Vec3::Zero()),
              "u = 0.3333, v = 0 (0, 0, 0 mm)");
    EXPECT_EQ(place_text({1.4999999982219319, -0.0}, {-5.334e-8, 86.046138984, 1}),
              "u = 1.5, v = 0 (0, 86.046, 1 mm)");
}

}  // namespace
}  // namespace endmill
