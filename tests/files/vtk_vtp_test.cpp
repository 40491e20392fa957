// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/vtk.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "vtp_reader.h"
#include "wavy_path.h"

namespace endmill {
namespace {

void expect_vectors(const std::vector<double>& numbers, std::size_t i,
                    const Vec3& expected)
{
    for (int c = 0; c < 3; ++c)
        EXPECT_EQ(numbers[3 * i + c], expected[c]) << i;
}

TEST(ToolPathVtp, HoldsEveryPointExactly)
{
    const ToolPath path = wavy_path(3, 20);
    const VtpReader reader{tool_path_vtp(path)};
    EXPECT_EQ(reader.attribute("VTKFile", "byte_order"), "LittleEndian");
    EXPECT_EQ(reader.attribute("VTKFile", "header_type"), "UInt64");
    EXPECT_EQ(reader.attribute("Piece", "NumberOfPoints"),
              std::to_string(path.points.size()));
    const auto tips = reader.array<double>("tip_mm", "Float64");
    const auto contacts = reader.array<double>("contact", "Float64");
    const auto normals = reader.array<double>("normal", "Float64");
    const auto u = reader.array<double>("u", "Float64");
    const auto has_contact = reader.array<std::uint8_t>("has_contact", "UInt8");
    ASSERT_EQ(tips.size(), 3 * path.points.size());
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const PathPoint& point = path.points[i];
        const bool touches = point.contact() != nullptr;
        expect_vectors(tips, i, point.location.tip);
        expect_vectors(contacts, i,
                       touches ? point.contact()->contact.point : point.location.tip);
        expect_vectors(normals, i,
                       touches ? point.contact()->contact.normal : point.location.axis);
        EXPECT_EQ(u[i], touches ? point.contact()->u : 0);
        EXPECT_EQ(has_contact[i], touches ? 1 : 0);
    }
}

// Each move of the path is in exactly one polyline, whose cell data are its kind and
// pass.
TEST(ToolPathVtp, PolylinesCoverEveryMoveOnce)
{
    const ToolPath path = wavy_path(4, 6);
    const VtpReader reader{tool_path_vtp(path)};
    const auto connectivity = reader.array<std::int64_t>("connectivity", "Int64");
    const auto offsets = reader.array<std::int64_t>("offsets", "Int64");
    const auto pass = reader.array<std::int32_t>("pass", "Int32");
    const auto move = reader.array<std::uint8_t>("move", "UInt8");
    ASSERT_EQ(offsets.size(), pass.size());
    ASSERT_EQ(offsets.size(), move.size());
    EXPECT_EQ(reader.attribute("Piece", "NumberOfLines"), std::to_string(offsets.size()));

    std::int64_t covered = 0;
    std::int64_t begin = 0;
    for (std::size_t line = 0; line < offsets.size(); ++line) {
        for (std::int64_t k = begin + 1; k < offsets[line]; ++k) {
            EXPECT_EQ(connectivity[k], connectivity[k - 1] + 1);
            EXPECT_EQ(connectivity[k], ++covered);
            EXPECT_EQ(path.points[connectivity[k]].pass, pass[line]);
            EXPECT_EQ(static_cast<int>(path.points[connectivity[k]].move), move[line]);
        }
        begin = offsets[line];
    }
    EXPECT_EQ(covered + 1, std::ssize(path.points));
}

// The first pass continues in the second one without a link.
TEST(ToolPathVtp, NumbersThePiecesThatAreCutWithoutInterruption)
{
    ToolPath path;
    const auto add = [&](int pass, Move move) {
        const double x = static_cast<double>(path.points.size());
        path.points.push_back({pass, 0, move, 0, {{x, 0, 0}, Vec3::UnitZ()}});
    };
    add(0, Move::Plunge);
    add(0, Move::Cut);
    add(1, Move::Cut);
    add(2, Move::Retract);
    add(2, Move::Rapid);
    add(2, Move::Cut);
    add(2, Move::Cut);
    add(3, Move::Link);
    const VtpReader reader{tool_path_vtp(path)};
    EXPECT_EQ(reader.array<std::int32_t>("pass", "Int32"),
              (std::vector<std::int32_t>{0, 1, 2, 2, 2, 3}));
    EXPECT_EQ(reader.array<std::int32_t>("piece", "Int32"),
              (std::vector<std::int32_t>{0, 0, 1, 1, 1, 2}));
}

TEST(ToolPathVtp, AnEmptyPathIsAFileWithoutPoints)
{
    const VtpReader reader{tool_path_vtp({})};
    EXPECT_EQ(reader.attribute("Piece", "NumberOfPoints"), "0");
    EXPECT_TRUE(reader.array<double>("tip_mm", "Float64").empty());
    EXPECT_TRUE(reader.array<std::int64_t>("offsets", "Int64").empty());
}

TEST(ToolPathVtp, RefusesANumberThatIsNotFinite)
{
    ToolPath path = wavy_path(2, 5);
    SurfaceContact contact = *path.points[3].contact();
    contact.contact.normal.x() = std::numeric_limits<double>::infinity();
    path.points[3].known_contact = contact;
    EXPECT_THROW(tool_path_vtp(path), DomainError);
}

}  // namespace
}  // namespace endmill
