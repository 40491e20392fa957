// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/dexel_file.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/files/output_folder.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string complaint(const std::string& file, const ReadLimits& limits = {})
{
    return complaint_of([&] { parse_dexels(file, "stock.dexels", limits); });
}

// A linear run of a cutter of finite length and a run of a machine, over rays of which some
// have no interval and some have two.
KeptDexels kept_stock()
{
    const Block block{{-1, 2, 3}, {2, 4, 5}};
    EarlierTurningRun linear{CuttingBody{Cutter{3, 1}, 12}, true, {}};
    linear.poses = {{{0, 0, 9}, {0, 0, 1}}, {{1, 2, 3}, {0.6, 0, 0.8}}};
    EarlierTurningRun turned{CuttingBody{Cutter::ball(2)}, false, {}};
    MachineMotion motion;
    motion.interpolation = Interpolation::Tcp;
    motion.setup.machine.configuration = configuration_from_word("W/caxyBz/T");
    motion.setup.machine.table_offset = {1, 2, 3};
    motion.setup.machine.axis_offset = {0, 12, -8};
    motion.setup.part_to_machine << 0, 1, 0, -1, 0, 0, 0, 0, 1;
    motion.setup.clamp = {5, -6, 7};
    motion.positions = {{{0.1, -6.5}, {1, 2, 3}}, {{0.2, -6.6}, {1, 2.5, 3}}};
    for (const AxisPositions& at : motion.positions)
        turned.poses.push_back(tool_location(motion.setup, at));
    turned.machine = motion;
    KeptDexels kept{DexelStock{block, 1}, {block, {linear, turned}}};
    DexelField& field = kept.dexels.field(2);
    std::vector<Dexel> dexels(static_cast<std::size_t>(field.columns()) * field.rows());
    dexels[0] = {{{0, 100}, {200, 300}}, {{1, 99}}};
    dexels[2] = {{{7, kept.dexels.units(2)}}, {}};
    field.assign(dexels);
    return kept;
}

std::string file_of(const KeptDexels& kept)
{
    return dexel_file(kept.dexels, kept.history);
}

TEST(DexelFile, IsReadBackToTheLastBit)
{
    const KeptDexels kept = kept_stock();
    const std::string file = file_of(kept);
    const KeptDexels found = parse_dexels(file, "stock.dexels");
    EXPECT_EQ(file_of(found), file);
    EXPECT_EQ(found.dexels.pitch(), 1);
    ASSERT_EQ(found.dexels.field(2).upper(0, 0).size(), 2U);
    EXPECT_EQ(found.dexels.field(2).upper(0, 0)[1], (DexelInterval{200, 300}));
    EXPECT_TRUE(found.dexels.field(2).lower(2, 0).empty());
    ASSERT_EQ(found.history.runs.size(), 2U);
    const auto& [linear, turned] =
        std::pair{found.history.runs[0], found.history.runs[1]};
    EXPECT_EQ(linear.cutter.length(), 12);
    EXPECT_TRUE(linear.stands_at_first);
    EXPECT_EQ(linear.poses[1].axis, (Vec3{0.6, 0, 0.8}));
    EXPECT_EQ(turned.cutter.length(), std::numeric_limits<double>::infinity());
    ASSERT_TRUE(turned.machine);
    EXPECT_EQ(turned.machine->interpolation, Interpolation::Tcp);
    EXPECT_EQ(turned.machine->positions, kept.history.runs[1].machine->positions);
    EXPECT_EQ(turned.poses[1].tip, kept.history.runs[1].poses[1].tip);
}

TEST(DexelFile, IsReadFromAFile)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "stock.dexels";
    write_file(path, file_of(kept_stock()));
    EXPECT_EQ(file_of(read_dexels(path)), file_of(kept_stock()));
}

TEST(DexelFile, OtherContentIsRefused)
{
    EXPECT_THAT(complaint(""), StartsWith("E_FORMAT stock.dexels"));
    EXPECT_THAT(complaint("solid stock"), HasSubstr("a stock.dexels of endmill"));
    std::string other = file_of(kept_stock());
    other[8] = 2;
    EXPECT_THAT(complaint(other), StartsWith("E_DEXELS stock.dexels@8: version 2"));
}

TEST(DexelFile, AFileOfAnotherLengthIsRefused)
{
    const std::string file = file_of(kept_stock());
    for (std::size_t length = 0; length < file.size(); ++length)
        EXPECT_THAT(complaint(file.substr(0, length)), StartsWith("E_"));
    EXPECT_THAT(complaint(file + "x"), HasSubstr("bytes behind the last dexel"));
}

// Whatever byte changes: the file is refused, or it is read as what it says.
TEST(DexelFile, ADamagedByteIsRefusedOrIsAnotherStock)
{
    const std::string file = file_of(kept_stock());
    for (std::size_t at = 0; at < file.size(); ++at)
        for (const int change : {1, 0x80, 0xff}) {
            std::string damaged = file;
            damaged[at] = static_cast<char>(damaged[at] ^ change);
            try {
                EXPECT_EQ(file_of(parse_dexels(damaged, "stock.dexels")), damaged) << at;
            } catch (const FormatError& error) {
                EXPECT_EQ(error.file(), "stock.dexels");
            } catch (const LimitError&) {
            }
        }
}

std::string with_number(std::string file, std::size_t at, double value)
{
    std::memcpy(file.data() + at, &value, sizeof value);
    return file;
}

TEST(DexelFile, NumbersOutOfRangeAreRefusedWithTheirPlace)
{
    const std::string file = file_of(kept_stock());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THAT(complaint(with_number(file, 16, nan)),
                StartsWith("E_NONFINITE stock.dexels@16"));
    EXPECT_THAT(complaint(with_number(file, 16, 1e9)), StartsWith("E_RANGE"));
    EXPECT_THAT(complaint(with_number(file, 16, 3)),
                HasSubstr("a block without material"));
    EXPECT_THAT(complaint(with_number(file, 64, -1)), HasSubstr("a pitch of -1"));
    // The first run: radius, corner radius, cutting length.
    EXPECT_THAT(complaint(with_number(file, 80, -1)), HasSubstr("a cutter of radius -1"));
    EXPECT_THAT(complaint(with_number(file, 96, 0.5)),
                HasSubstr("a cutting length of 0.5"));
    EXPECT_THAT(complaint(with_number(file, 96, nan)),
                HasSubstr("a cutting length that is not finite"));
    EXPECT_THAT(complaint(with_number(file, 96, -infinity)),
                HasSubstr("a cutting length that is not finite"));
    // A cutter may cut over its whole length, without an end.
    const std::string endless = with_number(file, 96, infinity);
    EXPECT_EQ(file_of(parse_dexels(endless, "stock.dexels")), endless);
    // x of the axis of the first pose.
    EXPECT_THAT(complaint(with_number(file, 152, 0.5)),
                HasSubstr("a tool axis of length"));
}

TEST(DexelFile, TooLargeAStockIsRefusedBeforeMemoryIsTaken)
{
    const std::string file = file_of(kept_stock());
    EXPECT_THAT(complaint(with_number(file, 64, 1e-5)), HasSubstr("a file that ends"));
    EXPECT_THAT(complaint(with_number(file, 64, 1e-300)),
                HasSubstr("the number of rays that the pitch gives"));
    ReadLimits limits;
    limits.max_memory_gib = 1e-7;
    EXPECT_THAT(complaint(file, limits), StartsWith("E_LIMIT"));
}

}  // namespace
}  // namespace endmill
