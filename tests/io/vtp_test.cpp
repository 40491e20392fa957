// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/vtp.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "small_xml.h"
#include "wavy_path.h"

namespace endmill {
namespace {

// Reads the file as VTK's description of its XML formats says: the elements name offsets
// into the bytes after '_', where each array follows its size in bytes.
class VtpReader {
public:
    explicit VtpReader(const std::string& file)
    {
        const std::string opening = "<AppendedData encoding=\"raw\">\n_";
        const std::string closing = "\n </AppendedData>";
        const auto begin = file.find(opening) + opening.size();
        const auto end = file.rfind(closing);
        bytes_ = file.substr(begin, end - begin);
        const auto root = file.find("<VTKFile");
        elements_ = SmallXml::parse(file.substr(root, begin - root) + file.substr(end));
    }

    std::string attribute(const std::string& element, const std::string& key) const
    {
        for (const XmlElement& candidate : elements_)
            if (candidate.name == element)
                return candidate.attributes.at(key);
        throw std::runtime_error{"no element " + element};
    }

    template <class Number>
    std::vector<Number> array(const std::string& name, const std::string& type) const
    {
        for (const XmlElement& element : elements_) {
            if (element.name != "DataArray" || element.attributes.at("Name") != name)
                continue;
            EXPECT_EQ(element.attributes.at("type"), type);
            const std::size_t offset = std::stoul(element.attributes.at("offset"));
            std::uint64_t size = 0;
            std::memcpy(&size, bytes_.data() + offset, sizeof size);
            EXPECT_LE(offset + sizeof size + size, bytes_.size());
            std::vector<Number> numbers(size / sizeof(Number));
            if (size > 0)
                std::memcpy(numbers.data(), bytes_.data() + offset + sizeof size, size);
            return numbers;
        }
        throw std::runtime_error{"no array " + name};
    }

private:
    std::string bytes_;
    std::vector<XmlElement> elements_;
};

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
        const bool touches = point.contact.has_value();
        expect_vectors(tips, i, point.location.tip);
        expect_vectors(contacts, i,
                       touches ? point.contact->contact.point : point.location.tip);
        expect_vectors(normals, i,
                       touches ? point.contact->contact.normal : point.location.axis);
        EXPECT_EQ(u[i], touches ? point.contact->u : 0);
        EXPECT_EQ(has_contact[i], touches ? 1 : 0);
    }
}

// Each move of the path must lie in exactly one polyline, which says its kind and pass.
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
    path.points[3].contact->contact.normal.x() = std::numeric_limits<double>::infinity();
    EXPECT_THROW(tool_path_vtp(path), DomainError);
}

}  // namespace
}  // namespace endmill
