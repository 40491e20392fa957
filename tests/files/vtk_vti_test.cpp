// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/vtk.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/files/output_folder.h"
#include "random.h"
#include "small_xml.h"
#include "stock_files.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

using test::array_at;
using test::number_at;
using test::rough_stock;
using test::with_number_at;
using testing::HasSubstr;
using testing::StartsWith;

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
    expect_same(parse_stock(stock_vti(stock), "stock.vti").heights, stock);
    const HeightStock cell = block_stock({{0, 0, 0}, {0.1, 0.1, 0.7}}, 0.1);
    expect_same(parse_stock(stock_vti(cell), "stock.vti").heights, cell);
}

TEST(StockVti, IsReadFromAFile)
{
    const TemporaryFolder folder;
    const HeightStock stock = rough_stock();
    const auto path = folder.path() / "stock.vti";
    write_file(path, stock_vti(stock));
    expect_same(read_stock(path).heights, stock);
}

// The file as VTK reads it: the cells of the extent, the array at its offset, x fastest.
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

TEST(StockVti, RefusesInvalidHeights)
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
    // Counts that exceed any memory are refused before anything is allocated.
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

// A truncated file is refused. A file with a changed byte in the head is refused unless
// the byte makes another valid number of the origin.
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
            const StockGrid grid = parse_stock(damaged, "stock.vti").heights.grid();
            EXPECT_NE(grid, stock.grid()) << at;
            EXPECT_EQ(grid.columns, 12) << at;
            EXPECT_EQ(grid.pitch, 0.3) << at;
        }
    }
}

// A stock after cuts with a flat and a ball-end cutter.
KeptStock kept_stock()
{
    const Block box{{-1.1, 0.3, -2.7}, {2.35, 4.8, 9}};
    HeightStock stock = block_stock(box, 0.3);
    test::Random random{2};
    for (int row = 0; row < stock.grid().rows; ++row)
        for (int column = 0; column < stock.grid().columns; ++column)
            stock.set_height(column, row, random.uniform(-3, 9));
    return {
        stock,
        StockHistory{box,
                     {{Cutter::flat(3), false, {{0.1, 0, 4}, {1, 0.3, 4}}},
                      {Cutter{2, 0.7}, true, {{-0.0, 1e-7, 2}, {5, 5, 2}, {5, 6, 2}}}}}};
}

void expect_same(const StockHistory& found, const StockHistory& expected)
{
    EXPECT_EQ(found.block.low, expected.block.low);
    EXPECT_EQ(found.block.high, expected.block.high);
    ASSERT_EQ(found.runs.size(), expected.runs.size());
    for (std::size_t k = 0; k < found.runs.size(); ++k) {
        EXPECT_EQ(found.runs[k].cutter, expected.runs[k].cutter);
        EXPECT_EQ(found.runs[k].stands_at_first, expected.runs[k].stands_at_first);
        EXPECT_EQ(found.runs[k].tips, expected.runs[k].tips);
    }
}

std::string kept_file()
{
    const KeptStock kept = kept_stock();
    return stock_vti(kept.heights, kept.history);
}

// Positions of the arrays of the history: block, cutters, tips of runs, tips.
std::size_t history_at(const std::string& file)
{
    return array_at(file, 16) + 12 * 15 * 8;
}

TEST(StockVtiWithHistory, IsReadBackToTheLastBit)
{
    const KeptStock kept = kept_stock();
    const std::string file = kept_file();
    const KeptStock found = parse_stock(file, "stock.vti");
    expect_same(found.heights, kept.heights);
    ASSERT_TRUE(found.history);
    expect_same(*found.history, *kept.history);
    EXPECT_EQ(stock_vti(found.heights, found.history), file);
    EXPECT_FALSE(parse_stock(stock_vti(kept.heights), "stock.vti").history);
}

// The file as VTK reads it: every array is at its offset and has the length of its
// tuples.
TEST(StockVtiWithHistory, IsAnImageOfVtk)
{
    const std::string file = kept_file();
    const auto root = file.find("<VTKFile");
    const auto elements = SmallXml::parse(file.substr(root, file.find("\n_") - root) +
                                          file.substr(file.rfind("\n </AppendedData>")));
    std::size_t end = 0;
    int arrays = 0;
    for (const XmlElement& element : elements) {
        if (element.name != "DataArray")
            continue;
        ++arrays;
        const std::size_t at =
            array_at(file, std::stoul(element.attributes.at("offset")));
        std::uint64_t size = 0;
        std::memcpy(&size, file.data() + at - sizeof size, sizeof size);
        std::size_t expected = 12 * 15;
        if (element.attributes.contains("NumberOfTuples"))
            expected = std::stoul(element.attributes.at("NumberOfTuples"));
        if (element.attributes.contains("NumberOfComponents"))
            expected *= std::stoul(element.attributes.at("NumberOfComponents"));
        EXPECT_EQ(size, 8 * expected) << element.attributes.at("Name");
        end = std::max(end, at + size);
        if (element.attributes.at("Name") == "tips_mm") {
            EXPECT_EQ(number_at(file, at + 8 * 6), 0);
            EXPECT_EQ(number_at(file, at + 8 * 7), 1e-7);
        }
    }
    EXPECT_EQ(arrays, 6);
    EXPECT_EQ(end, file.rfind("\n </AppendedData>"));
}

TEST(StockVtiWithHistory, RefusesInvalidRuns)
{
    const std::string file = kept_file();
    const std::size_t block = history_at(file) + 8;
    const std::size_t cutters = block + 6 * 8 + 8;
    const std::size_t runs = cutters + 4 * 8 + 8;
    const std::size_t tips = runs + 4 * 8 + 8;
    const auto with_count = [&](std::size_t at, std::int64_t count) {
        std::string damaged = file;
        std::memcpy(damaged.data() + at, &count, sizeof count);
        return complaint(damaged);
    };
    EXPECT_THAT(complaint(with_number_at(file, tips + 8, std::nan(""))),
                StartsWith("E_NONFINITE stock.vti@" + std::to_string(tips + 8)));
    EXPECT_THAT(complaint(with_number_at(file, tips, 2e6)), StartsWith("E_RANGE"));
    EXPECT_THAT(complaint(with_number_at(file, cutters, 0)), StartsWith("E_RANGE"));
    EXPECT_THAT(complaint(with_number_at(file, cutters + 8, 3.1)), StartsWith("E_RANGE"));
    EXPECT_THAT(complaint(with_number_at(file, cutters + 8, -1)), StartsWith("E_RANGE"));
    EXPECT_THAT(with_count(runs, 1), StartsWith("E_VTI "));
    EXPECT_THAT(with_count(runs, 0), StartsWith("E_VTI "));
    EXPECT_THAT(with_count(runs, 6), StartsWith("E_VTI "));
    EXPECT_THAT(with_count(runs, -1), StartsWith("E_VTI "));
    EXPECT_THAT(with_count(runs + 8, 2), StartsWith("E_VTI "));
    EXPECT_THAT(with_count(tips - 8, 7), StartsWith("E_VTI "));
    // A block that differs from that of the heights, or is lower than they are.
    EXPECT_THAT(complaint(with_number_at(file, block, -1.2)), StartsWith("E_VTI "));
    EXPECT_THAT(complaint(with_number_at(file, block + 5 * 8, 1)), StartsWith("E_VTI "));
    EXPECT_THAT(complaint(with_number_at(file, block, 3)), StartsWith("E_RANGE"));
    EXPECT_THAT(complaint(with_number_at(file, block, -1e6)), StartsWith("E_VTI "));
}

TEST(StockVtiWithHistory, RefusesCountsThatContradictTheFile)
{
    const std::string file = kept_file();
    const auto with = [&](const std::string& from, const std::string& to) {
        const std::string text = replaced(file, from, to);
        EXPECT_FALSE(text.empty()) << from;
        return complaint(text);
    };
    const std::string runs =
        "Name=\"run_tips\" NumberOfComponents=\"2\" NumberOfTuples=\"";
    const std::string tips =
        "Name=\"tips_mm\" NumberOfComponents=\"3\" NumberOfTuples=\"";
    EXPECT_THAT(with(tips + "5", tips + "6"), StartsWith("E_VTI_SIZE"));
    EXPECT_THAT(with(tips + "5", tips + "1"), StartsWith("E_VTI "));
    EXPECT_THAT(with(tips + "5", tips + "9223372036854775807"), StartsWith("E_VTI "));
    EXPECT_THAT(with(tips + "5", tips + "1099511627776"), StartsWith("E_VTI_SIZE"));
    EXPECT_THAT(with(tips + "5", tips + "-5"), StartsWith("E_VTI "));
    EXPECT_THAT(with(runs + "2", runs + "1"), StartsWith("E_VTI "));
    EXPECT_THAT(with(runs + "2", runs + "0"), StartsWith("E_VTI "));
    EXPECT_THAT(with("block_mm", "blokk_mm"), StartsWith("E_VTI "));
    EXPECT_THAT(with("tips_mm", "tipz_mm"), StartsWith("E_VTI "));
}

TEST(StockVtiWithHistory, SurvivesDamage)
{
    const std::string file = kept_file();
    for (std::size_t length = 1; length < file.size(); length += 13)
        EXPECT_NE(complaint(file.substr(0, length)), "accepted") << length;
    test::Random random{8};
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = file;
        const auto at = static_cast<std::size_t>(
            random.uniform(0, static_cast<double>(file.size()) - 0.5));
        damaged[at] = static_cast<char>(random.uniform(-128, 127));
        if (complaint(damaged) != "accepted")
            continue;
        const KeptStock found = parse_stock(damaged, "stock.vti");
        EXPECT_EQ(stock_vti(found.heights, found.history), damaged) << at;
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
