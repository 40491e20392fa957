// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/io/vti.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/io/output_folder.h"
#include "random.h"
#include "small_xml.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

HeightStock rough_stock()
{
    HeightStock stock = block_stock({{-1.1, 0.3, -2.7}, {2.35, 4.8, 1}}, 0.3);
    test::Random random{1};
    for (int row = 0; row < stock.grid().rows; ++row)
        for (int column = 0; column < stock.grid().columns; ++column)
            stock.set_height(column, row, random.uniform(-3, 9));
    return stock;
}

// Where in the file the array behind `offset` begins, after its size.
std::size_t array_at(const std::string& file, std::size_t offset)
{
    const std::string opening = "<AppendedData encoding=\"raw\">\n_";
    return file.find(opening) + opening.size() + offset + sizeof(std::uint64_t);
}

double number_at(const std::string& file, std::size_t at)
{
    double value = 0;
    std::memcpy(&value, file.data() + at, sizeof value);
    return value;
}

std::string with_number_at(std::string file, std::size_t at, double value)
{
    std::memcpy(file.data() + at, &value, sizeof value);
    return file;
}

std::string complaint(const std::string& file, const ReadLimits& limits = {})
{
    return complaint_of([&] { parse_stock(file, "stock.vti", limits); });
}

void expect_same(const HeightStock& found, const HeightStock& expected)
{
    ASSERT_EQ(found.grid(), expected.grid());
    for (int row = 0; row < found.grid().rows; ++row)
        for (int column = 0; column < found.grid().columns; ++column)
            EXPECT_EQ(found.height(column, row), expected.height(column, row));
}

TEST(StockVti, IsReadBackToTheLastBit)
{
    const HeightStock stock = rough_stock();
    expect_same(parse_stock(stock_vti(stock), "stock.vti"), stock);
    const HeightStock cell = block_stock({{0, 0, 0}, {0.1, 0.1, 0.7}}, 0.1);
    expect_same(parse_stock(stock_vti(cell), "stock.vti"), cell);
}

TEST(StockVti, IsReadFromAFile)
{
    const TemporaryFolder folder;
    const HeightStock stock = rough_stock();
    const auto path = folder.path() / "stock.vti";
    write_file(path, stock_vti(stock));
    expect_same(read_stock(path), stock);
}

// As VTK reads it: the cells of the extent, the array behind its offset, x first.
TEST(StockVti, IsAnImageOfVtk)
{
    const HeightStock stock = rough_stock();
    const std::string file = stock_vti(stock);
    const auto root = file.find("<VTKFile");
    const auto elements = SmallXml::parse(file.substr(root, file.find("\n_") - root) +
                                          file.substr(file.rfind("\n </AppendedData>")));
    for (const XmlElement& element : elements) {
        if (element.name == "VTKFile") {
            EXPECT_EQ(element.attributes.at("type"), "ImageData");
            EXPECT_EQ(element.attributes.at("byte_order"), "LittleEndian");
            EXPECT_EQ(element.attributes.at("header_type"), "UInt64");
        }
        if (element.name == "ImageData") {
            EXPECT_EQ(element.attributes.at("WholeExtent"), "0 12 0 15 0 0");
            EXPECT_EQ(element.attributes.at("Spacing"), "0.3 0.3 0.3");
        }
        if (element.name != "DataArray")
            continue;
        const std::size_t at =
            array_at(file, std::stoul(element.attributes.at("offset")));
        if (element.attributes.at("Name") == "bottom_z_mm") {
            EXPECT_EQ(number_at(file, at), -2.7);
        } else {
            EXPECT_EQ(element.attributes.at("Name"), "height_mm");
            EXPECT_EQ(number_at(file, at + 8 * (12 * 7 + 5)), stock.height(5, 7));
        }
    }
    EXPECT_EQ(elements.size(), 8U);
}

TEST(StockVti, RefusesHeightsThatAreNone)
{
    const std::string file = stock_vti(rough_stock());
    const std::size_t at = array_at(file, 16) + 8 * 20;
    EXPECT_THAT(complaint(with_number_at(file, at, std::nan(""))),
                StartsWith("E_NONFINITE stock.vti@" + std::to_string(at)));
    EXPECT_THAT(complaint(with_number_at(file, at, -2.8)), StartsWith("E_RANGE"));
    EXPECT_THAT(complaint(with_number_at(file, at, 2e6)), StartsWith("E_RANGE"));
    EXPECT_THAT(complaint(with_number_at(file, array_at(file, 0), -2.6)),
                StartsWith("E_VTI"));
}

TEST(StockVti, RefusesAFileOfAnotherLength)
{
    const std::string file = stock_vti(rough_stock());
    EXPECT_THAT(complaint(file.substr(0, file.size() - 200)), StartsWith("E_VTI_SIZE"));
    EXPECT_THAT(complaint(file + "x"), StartsWith("E_VTI_SIZE"));
    // Counts that nobody has memory for are not believed.
    std::string huge = replaced(file, "WholeExtent=\"0 12 0 15",
                                "WholeExtent=\"0 2147483647 0 2147483647");
    huge = replaced(huge, "Piece Extent=\"0 12 0 15",
                    "Piece Extent=\"0 2147483647 0 2147483647");
    ASSERT_FALSE(huge.empty());
    ReadLimits limits;
    limits.max_extent_mm = 1e12;
    EXPECT_THAT(complaint(huge, limits), StartsWith("E_VTI_SIZE"));
    EXPECT_THAT(complaint(huge), StartsWith("E_RANGE"));
}

TEST(StockVti, RefusesAnotherHead)
{
    const std::string file = stock_vti(rough_stock());
    const auto with = [&](const std::string& from, const std::string& to) {
        const std::string text = replaced(file, from, to);
        EXPECT_FALSE(text.empty()) << from;
        return complaint(text);
    };
    EXPECT_THAT(with("LittleEndian", "BigEndian"), StartsWith("E_VTI "));
    EXPECT_THAT(with("Float64", "Float32"), StartsWith("E_VTI "));
    EXPECT_THAT(with("0.3 0.3 0.3", "0.3 0.4 0.3"), StartsWith("E_VTI "));
    EXPECT_THAT(with("Spacing=\"0.3", "Spacing=\"0"), StartsWith("E_RANGE"));
    EXPECT_THAT(with("Spacing=\"0.3", "Spacing=\"-1"), StartsWith("E_RANGE"));
    EXPECT_THAT(with("Spacing=\"0.3", "Spacing=\"nan"), StartsWith("E_VTI "));
    EXPECT_THAT(with("Spacing=\"0.3", "Spacing=\"1e300"), StartsWith("E_RANGE"));
    EXPECT_THAT(with("WholeExtent=\"0 12", "WholeExtent=\"0 -1"), StartsWith("E_VTI "));
    EXPECT_THAT(with("WholeExtent=\"0 12", "WholeExtent=\"0 99999999999"),
                StartsWith("E_VTI "));
    EXPECT_THAT(with("WholeExtent", "WholeExtend"), StartsWith("E_VTI "));
    EXPECT_THAT(complaint("solid cube"), StartsWith("E_FORMAT"));
    EXPECT_THAT(complaint("<?xml version=\"1.0\"?>\n<VTKFile"), StartsWith("E_VTI"));
}

// What is cut off anywhere is refused. A changed byte of the head is refused too, unless
// it makes another number of the origin: nothing is read that a stock cannot be.
TEST(StockVti, SurvivesDamage)
{
    const HeightStock stock = rough_stock();
    const std::string file = stock_vti(stock);
    for (std::size_t length = 1; length < file.size(); length += 13)
        EXPECT_NE(complaint(file.substr(0, length)), "accepted") << length;
    for (std::size_t at = 0; at < array_at(file, 16); ++at) {
        std::string damaged = file;
        damaged[at] = static_cast<char>(damaged[at] ^ 1);
        if (complaint(damaged) == "accepted") {
            const StockGrid grid = parse_stock(damaged, "stock.vti").grid();
            EXPECT_NE(grid, stock.grid()) << at;
            EXPECT_EQ(grid.columns, 12) << at;
            EXPECT_EQ(grid.pitch, 0.3) << at;
        }
    }
}

TEST(StockVti, KeepsToTheMemoryLimit)
{
    ReadLimits limits;
    limits.max_memory_gib = 1e-6;
    EXPECT_THAT(complaint(stock_vti(rough_stock()), limits), StartsWith("E_LIMIT"));
}

}  // namespace
}  // namespace endmill
