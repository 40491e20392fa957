// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/mesh_source.h"

#include <limits>

#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string mesh_source_complaint(const Vec3& coordinates, double mm_per_unit = 1,
                                  double max_extent_mm = 1e6)
{
    const MeshSource source{"", "f", {.max_extent_mm = max_extent_mm}, mm_per_unit};
    return complaint_of([&] { point_mm(source, coordinates, FilePlace::byte(96)); });
}

TEST(FilePlace, IsALineOrAByte)
{
    EXPECT_EQ(FilePlace::line(7).text(), "7");
    EXPECT_EQ(FilePlace::byte(0).text(), "@0");
}

TEST(PointMm, ConvertsCoordinatesWithinTheLimit)
{
    const MeshSource inch{"", "f", {}, 25.4};
    EXPECT_EQ(point_mm(inch, {1, -2, 0}, FilePlace::line(1)), Vec3(25.4, -50.8, 0));
    EXPECT_EQ(mesh_source_complaint({1e6, -1e6, 0}), "accepted");
    EXPECT_EQ(mesh_source_complaint({1e7, 0, 0}, 1, 1e7), "accepted");
}

TEST(PointMm, RefusesCoordinatesThatAreNotFiniteOrBeyondTheLimit)
{
    EXPECT_EQ(mesh_source_complaint({0, std::numeric_limits<double>::quiet_NaN(), 0}),
              "E_NONFINITE f@96: coordinate NaN; expected a finite number");
    EXPECT_EQ(mesh_source_complaint({0, 0, -infinity}, 1, infinity),
              "E_NONFINITE f@96: coordinate -infinity; expected a finite number");
    EXPECT_EQ(
        mesh_source_complaint({1000001, 0, 0}),
        "E_RANGE f@96: coordinate 1000001; expected at most 1e+06 mm (--max-extent)");
    EXPECT_EQ(mesh_source_complaint({0, -50000, 0}, 25.4),
              "E_RANGE f@96: coordinate -50000 (-1270000 mm); "
              "expected at most 1e+06 mm (--max-extent)");
    EXPECT_EQ(mesh_source_complaint({0, 1e308, 0}, 25.4, infinity),
              "E_RANGE f@96: coordinate 1e+308 (infinity mm); "
              "expected at most infinity mm (--max-extent)");
}

TEST(ScanPointMm, NamesTheLine)
{
    const MeshSource source{"\n1 2 3\n4 5 inf\n", "f"};
    TextScanner words{source.content, {"f", "E_TEXT"}};
    words.next_line();
    EXPECT_EQ(scan_point_mm(words, source), Vec3(1, 2, 3));
    words.next_line();
    EXPECT_EQ(complaint_of([&] { scan_point_mm(words, source); }),
              "E_NONFINITE f:3: coordinate infinity; expected a finite number");
}

TEST(PointNumber, IsOneOfThePoints)
{
    const MeshSource source{"", "f"};
    const auto complaint_about_number = [&](std::int64_t number, std::size_t points) {
        return complaint_of(
            [&] { point_number(source, number, points, FilePlace::line(9)); });
    };
    EXPECT_EQ(point_number(source, 3, 4, FilePlace::line(9)), 3);
    EXPECT_EQ(complaint_about_number(4, 4), "E_INDEX f:9: index 4; expected 0 to 3");
    EXPECT_EQ(complaint_about_number(-1, 4), "E_INDEX f:9: index -1; expected 0 to 3");
    EXPECT_EQ(complaint_about_number(std::numeric_limits<std::int64_t>::max(), 4),
              "E_INDEX f:9: index 9223372036854775807; expected 0 to 3");
    EXPECT_EQ(complaint_about_number(0, 0),
              "E_INDEX f:9: index 0; expected no index: there are no points");
}

// Around 2^31 and 2^32.
TEST(RequireNumbers, HasRoomForThirtyOneBits)
{
    const MeshSource source{"", "f"};
    for (const std::uint64_t count : {0U, 0x7ffffffeU, 0x7fffffffU})
        EXPECT_NO_THROW(require_numbers(source, count));
    for (const std::uint64_t count :
         {0x80000000ULL, 0x80000001ULL, 0xffffffffULL, 0x100000000ULL, 0x100000001ULL})
        EXPECT_EQ(complaint_of([&] { require_numbers(source, count); }),
                  "E_LIMIT f: " + std::to_string(count) +
                      " points or triangles; the limit is 2147483647");
}

}  // namespace
}  // namespace endmill
