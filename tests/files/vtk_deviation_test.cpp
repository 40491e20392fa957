// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/vtk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "made_deviation.h"
#include "test_surfaces.h"
#include "vtp_reader.h"

namespace endmill {
namespace {

const Part slope = std::vector<Surface>{test::parallelogram({4, 0, 3}, {0, 2, 0})};

double wavy(const Vec3& point)
{
    return 0.1 * std::sin(3 * point.x()) * std::cos(2 * point.y());
}

TEST(DeviationVtp, HoldsTheMiddleOfEveryCell)
{
    const PartCharts charts = part_charts(slope);
    const Deviation deviation = made_deviation(charts, 0.3, wavy);
    const VtpReader reader{deviation_vtp(charts, deviation)};
    const auto places = reader.array<float>("point_mm", "Float32");
    const auto normals = reader.array<float>("normal", "Float32");
    const auto left = reader.array<float>("left_mm", "Float32");
    EXPECT_EQ(left, deviation.left);
    ASSERT_EQ(places.size(), 3 * left.size());
    ASSERT_EQ(normals.size(), 3 * left.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        const Vec3 place{places[3 * i], places[3 * i + 1], places[3 * i + 2]};
        EXPECT_NEAR(place.z(), 0.75 * place.x(), 1e-6);
        EXPECT_NEAR(left[i], wavy(place), 1e-6);
        EXPECT_NEAR(normals[3 * i], -0.6, 1e-6);
        EXPECT_NEAR(normals[3 * i + 2], 0.8, 1e-6);
    }
}

TEST(DeviationVtp, HasAVertexForEachPoint)
{
    const PartCharts charts = part_charts(slope);
    const Deviation deviation = made_deviation(charts, 0.3, wavy);
    const VtpReader reader{deviation_vtp(charts, deviation)};
    const auto connectivity = reader.array<std::int64_t>("connectivity", "Int64");
    const auto offsets = reader.array<std::int64_t>("offsets", "Int64");
    const std::string count = std::to_string(deviation.left.size());
    EXPECT_EQ(reader.attribute("Piece", "NumberOfPoints"), count);
    EXPECT_EQ(reader.attribute("Piece", "NumberOfVerts"), count);
    ASSERT_EQ(connectivity.size(), deviation.left.size());
    ASSERT_EQ(offsets.size(), deviation.left.size());
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        EXPECT_EQ(connectivity[i], static_cast<std::int64_t>(i));
        EXPECT_EQ(offsets[i], static_cast<std::int64_t>(i + 1));
    }
}

class ThinnedDeviation : public testing::TestWithParam<std::size_t> {};

TEST_P(ThinnedDeviation, KeepsBothExtremes)
{
    const PartCharts charts = part_charts(slope);
    Deviation deviation = made_deviation(charts, 0.1, wavy);
    deviation.left[77] = -0.5;
    deviation.left[78] = 0.7F;
    const std::size_t most = GetParam();
    const VtpReader reader{deviation_vtp(charts, deviation, most)};
    const auto left = reader.array<float>("left_mm", "Float32");
    EXPECT_LE(left.size(), most);
    EXPECT_GE(left.size(), std::min(most, deviation.left.size()) / 2);
    EXPECT_EQ(std::ranges::min(left), -0.5);
    EXPECT_EQ(std::ranges::max(left), 0.7F);
    // The points keep their order: each is found after the one before.
    auto at = deviation.left.begin();
    for (const float value : left) {
        at = std::find(at, deviation.left.end(), value);
        ASSERT_NE(at, deviation.left.end());
        ++at;
    }
}

INSTANTIATE_TEST_SUITE_P(ToAnyNumber, ThinnedDeviation,
                         testing::Values(2, 3, 100, 101, 999, 1000, 100'000));

TEST(DeviationVtp, LeavesOutCellsWithoutArea)
{
    const PartCharts charts = part_charts(slope);
    Deviation deviation = made_deviation(charts, 0.3, wavy);
    deviation.area[5] = 0;
    deviation.area[6] = 0;
    const VtpReader reader{deviation_vtp(charts, deviation)};
    std::vector<float> expected = deviation.left;
    expected.erase(expected.begin() + 5, expected.begin() + 7);
    EXPECT_EQ(reader.array<float>("left_mm", "Float32"), expected);
}

TEST(DeviationVtp, IsTheSameForAnyNumberOfThreads)
{
    const PartCharts charts = part_charts(slope);
    const Deviation deviation = made_deviation(charts, 0.02, wavy);
    const std::string file = deviation_vtp(charts, deviation, 5000);
    set_thread_count(1);
    EXPECT_TRUE(deviation_vtp(charts, deviation, 5000) == file);
    set_thread_count(2);
}

TEST(DeviationVtp, OfNothingIsAFileWithoutPoints)
{
    const Part part = std::vector<Surface>{};
    const VtpReader reader{deviation_vtp(part_charts(part), {})};
    EXPECT_EQ(reader.attribute("Piece", "NumberOfPoints"), "0");
    EXPECT_TRUE(reader.array<float>("left_mm", "Float32").empty());
}

TEST(DeviationVtp, RefusesNonFiniteNumbersAndFewerThanTwoPoints)
{
    const PartCharts charts = part_charts(slope);
    Deviation deviation = made_deviation(charts, 0.5, wavy);
    EXPECT_THROW(deviation_vtp(charts, deviation, 1), DomainError);
    deviation.left[3] = std::numeric_limits<float>::infinity();
    EXPECT_THROW(deviation_vtp(charts, deviation), DomainError);
}

// The code and the text of the error of reading a file.
std::string fault_of(const std::string& content, const ReadLimits& limits = {})
{
    try {
        parse_deviation_points(content, "d.vtp", limits);
    } catch (const Error& error) {
        return error.code() + " " + error.what();
    }
    return "none";
}

std::string written()
{
    const PartCharts charts = part_charts(slope);
    return deviation_vtp(charts, made_deviation(charts, 0.3, wavy));
}

TEST(DeviationPoints, ReadBackAsTheIndependentReaderReadsThem)
{
    const std::string file = written();
    const VtpReader reader{file};
    const DeviationPoints points = parse_deviation_points(file, "d.vtp");
    EXPECT_EQ(points.point_mm, reader.array<float>("point_mm", "Float32"));
    EXPECT_EQ(points.left_mm, reader.array<float>("left_mm", "Float32"));
    EXPECT_FALSE(points.left_mm.empty());
}

TEST(DeviationPoints, RefuseAFileOfEveryOtherLength)
{
    const std::string file = written();
    for (std::size_t length = 0; length < file.size(); length += 97)
        EXPECT_NE(fault_of(file.substr(0, length)), "none") << length;
    EXPECT_EQ(fault_of(file + "x").substr(0, 10), "E_VTP_SIZE");
}

TEST(DeviationPoints, RefuseCountsThatLie)
{
    std::string file = written();
    const std::string key = "NumberOfPoints=\"";
    const std::size_t at = file.find(key) + key.size();
    for (const char* count : {"9", "99999999999999999999", "1099511627776", "-1", "x"}) {
        std::string lie = file;
        lie.replace(at, lie.find('"', at) - at, count);
        EXPECT_EQ(fault_of(lie).substr(0, 5), "E_VTP") << count;
    }
}

TEST(DeviationPoints, RefuseNumbersThatAreNotFinite)
{
    std::string file = written();
    const float infinite = std::numeric_limits<float>::infinity();
    const std::size_t at = file.find("\"raw\">\n_") + 8 + 8 + 40;
    file.replace(at, sizeof infinite, reinterpret_cast<const char*>(&infinite),
                 sizeof infinite);
    EXPECT_EQ(fault_of(file).substr(0, 11), "E_NONFINITE");
}

TEST(DeviationPoints, RefuseOtherFilesAndTooLittleMemory)
{
    EXPECT_EQ(fault_of("<?xml version=\"1.0\"?><VTKFile/>").substr(0, 5), "E_VTP");
    EXPECT_EQ(fault_of("").substr(0, 5), "E_VTP");
    EXPECT_EQ(fault_of(written(), {1e6, 1e-9}).substr(0, 7), "E_LIMIT");
}

}  // namespace
}  // namespace endmill
