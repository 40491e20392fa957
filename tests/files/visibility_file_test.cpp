// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/visibility_file.h"

#include <algorithm>
#include <cstring>
#include <set>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/visibility/sphere_grid.h"
#include "temporary_folder.h"
#include "test_meshes.h"

namespace endmill {
namespace {

std::string bytes_of(const StoredVisibility& stored)
{
    std::string bytes;
    write_visibility(stored, [&](std::string_view piece) { bytes += piece; });
    return bytes;
}

StoredVisibility some_visibility()
{
    const TriangleMesh part = test::torus_mesh(9, 5);
    StoredVisibility stored{.grid = "hex:2",
                            .incidence = Angle::degrees(80),
                            .kind = VisibilityKind::Global,
                            .tool = "ball:10",
                            .part_checksum = part_checksum(part),
                            .visibility = {}};
    stored.visibility = part_visibility(part, sphere_grid("hex:2").centres,
                                        {.incidence = stored.incidence});
    stored.visibility.dropped = {3, 17, 88};
    return stored;
}

TEST(VisibilityFile, ComesBackTheSame)
{
    const StoredVisibility stored = some_visibility();
    const std::string bytes = bytes_of(stored);
    const StoredVisibility back = parse_visibility(bytes, "f.bsm");
    EXPECT_EQ(back.grid, stored.grid);
    EXPECT_EQ(back.incidence.radians(), stored.incidence.radians());
    EXPECT_EQ(back.kind, stored.kind);
    EXPECT_EQ(back.tool, stored.tool);
    EXPECT_EQ(back.part_checksum, stored.part_checksum);
    EXPECT_EQ(back.visibility.dropped, stored.visibility.dropped);
    ASSERT_EQ(back.visibility.map.cells(), 48U);
    for (std::size_t cell = 0; cell < 48; ++cell)
        EXPECT_TRUE(std::ranges::equal(back.visibility.map.column(cell),
                                       stored.visibility.map.column(cell)));
    EXPECT_EQ(bytes_of(back), bytes);
}

// A cell along which all facets are accessible is a column of zeros, as in [KangSuh].
TEST(VisibilityFile, HasZeroForAccessible)
{
    StoredVisibility stored{.grid = "hex:1", .tool = {}, .visibility = {{70, 12}, {}}};
    std::ranges::fill(stored.visibility.map.column(1), ~std::uint64_t{0});
    stored.visibility.map.column(1)[1] = 0b111111;
    const std::string bytes = bytes_of(stored);
    const std::size_t columns = 64 + 8;
    EXPECT_EQ(bytes.size(), columns + 12 * 16 + 8);
    EXPECT_EQ(bytes.substr(columns, 9), std::string(8, '\xff') + '\x3f');
    EXPECT_EQ(bytes.substr(columns + 16, 16), std::string(16, '\0'));
}

TEST(VisibilityFile, MayBeEmpty)
{
    StoredVisibility stored{.grid = "hex:1", .tool = {}, .visibility = {{0, 12}, {}}};
    EXPECT_EQ(parse_visibility(bytes_of(stored), "f").visibility.map.cells(), 12U);
    stored.visibility.map = {0, 13};
    EXPECT_THROW(bytes_of(stored), DomainError);
    stored.grid = "other";
    EXPECT_THROW(bytes_of(stored), DomainError);
    stored = {
        .grid = "hex:1", .tool = std::string(1001, 't'), .visibility = {{0, 12}, {}}};
    EXPECT_THROW(bytes_of(stored), DomainError);
}

TEST(VisibilityFile, IsRefusedIfAnyByteDiffers)
{
    const std::string bytes = bytes_of(some_visibility());
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        std::string damaged = bytes;
        damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
        EXPECT_THROW(parse_visibility(damaged, "f.bsm"), FormatError) << at;
    }
}

TEST(VisibilityFile, IsRefusedIfItEndsEarlyOrLate)
{
    const std::string bytes = bytes_of(some_visibility());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_THROW(parse_visibility(bytes.substr(0, size), "f.bsm"), FormatError)
            << size;
    EXPECT_THROW(parse_visibility(bytes + '\0', "f.bsm"), FormatError);
}

template <typename Number>
std::string with(std::string bytes, std::size_t at, Number number)
{
    std::memcpy(bytes.data() + at, &number, sizeof number);
    return bytes;
}

// The place that the error message states.
std::string place(const std::string& damaged)
{
    try {
        parse_visibility(damaged, "f.bsm");
    } catch (const FormatError& error) {
        EXPECT_EQ(error.code(), "E_BSM");
        return error.place();
    }
    return "none";
}

// The file with a checksum that matches its content.
std::string summed(const std::string& bytes)
{
    const std::size_t end = bytes.size() - 8;
    return with(bytes, end, visibility_checksum(std::string_view{bytes}.substr(0, end)));
}

TEST(VisibilityFile, StatesTheByteOfAContradiction)
{
    const std::string bytes = bytes_of(some_visibility());
    EXPECT_EQ(place(summed(bytes)), "none");
    const std::size_t dropped = 64 + 16;  // after 12 bytes of names
    EXPECT_EQ(place(summed(with(bytes, 64 + 13, 'x'))), "@77");
    EXPECT_EQ(place(summed(with(bytes, dropped, std::uint32_t{90}))), "@80");
    EXPECT_EQ(place(summed(with(bytes, dropped, std::uint32_t{17}))), "@84");
    EXPECT_EQ(place(summed(with(bytes, dropped + 12, 'x'))), "@92");
    EXPECT_EQ(place(summed(with(bytes, dropped + 16 + 15, '\xff'))), "@104");
}

TEST(VisibilityFile, StatesTheByteOfAWrongHeader)
{
    const std::string bytes = bytes_of(some_visibility());
    EXPECT_EQ(place(with(bytes, 0, 'X')), "@0");
    EXPECT_EQ(place(bytes.substr(0, 40)), "@40");
    EXPECT_EQ(place(with(bytes, 8, std::uint32_t{2})), "@8");
    EXPECT_EQ(place(with(bytes, 12, std::uint32_t{2})), "@12");
    EXPECT_EQ(place(with(bytes, 16, ~std::uint64_t{0})), "@16");
    EXPECT_EQ(place(with(bytes, 24, std::uint64_t{1} << 61)), "@24");
    EXPECT_EQ(place(with(bytes, 32, 2.0)), "@32");
    EXPECT_EQ(place(with(bytes, 32, double(NAN))), "@32");
    EXPECT_EQ(place(with(bytes, 48, ~std::uint32_t{0})), "@48");
    EXPECT_EQ(place(with(bytes, 52, ~std::uint32_t{0})), "@52");
    EXPECT_EQ(place(with(bytes, 56, ~std::uint32_t{0})), "@56");
    EXPECT_EQ(place(with(bytes, 60, std::uint32_t{1})), "@60");
    EXPECT_EQ(place(with(bytes, 64, 'H')), "@64");
    EXPECT_EQ(place(with(bytes, 68, '1')), "@24");
    // The same number of words, but more facets or another grid.
    EXPECT_EQ(place(with(bytes, 16, std::uint64_t{91})),
              "@" + std::to_string(bytes.size() - 8));
    EXPECT_EQ(place(with(bytes, bytes.size() - 9, '\x1')),
              "@" + std::to_string(bytes.size() - 8));
    EXPECT_EQ(place(with(bytes, 16, std::uint64_t{1000})),
              "@" + std::to_string(bytes.size()));
}

TEST(VisibilityFile, KeepsToTheMemoryLimit)
{
    const std::string bytes = bytes_of(some_visibility());
    EXPECT_THROW(parse_visibility(bytes, "f.bsm", {.max_memory_gib = 1e-7}), LimitError);
}

TEST(ReadVisibility, RefusesAnotherPartsFile)
{
    const TemporaryFolder folder;
    const auto path = folder.path() / "v.bsm";
    folder.put("v.bsm", bytes_of(some_visibility()));
    EXPECT_EQ(read_visibility(path, test::torus_mesh(9, 5)).grid, "hex:2");
    EXPECT_THROW(read_visibility(path, test::torus_mesh(9, 6)), FormatError);
    EXPECT_THROW(read_visibility(path, test::torus_mesh(9, 5, 3.0000001)), FormatError);
    EXPECT_THROW(read_visibility(folder.path() / "none", {}), FormatError);
}

TEST(PartChecksum, ChangesWithEachCoordinateAndCorner)
{
    const TriangleMesh part = test::box_mesh({0, 0, 0}, {1, 2, 3});
    std::vector<std::uint64_t> sums{part_checksum(part)};
    for (int k = 0; k < 24; ++k) {
        std::vector<Vec3> points = test::points_of(part);
        points[k / 3][k % 3] = std::nextafter(points[k / 3][k % 3], 9);
        sums.push_back(part_checksum({points, test::triangles_of(part)}));
    }
    for (int k = 0; k < 36; ++k) {
        std::vector<Triangle> triangles = test::triangles_of(part);
        triangles[k / 3][k % 3] = (triangles[k / 3][k % 3] + 1) % 8;
        sums.push_back(part_checksum({test::points_of(part), triangles}));
    }
    std::ranges::sort(sums);
    EXPECT_TRUE(std::ranges::adjacent_find(sums) == sums.end());
    EXPECT_EQ(part_checksum(test::box_mesh({-0.0, -0.0, -0.0}, {1, 2, 3})),
              part_checksum(part));
}

std::uint64_t checksum_of(const std::vector<std::uint64_t>& words)
{
    return visibility_checksum(
        {reinterpret_cast<const char*>(words.data()), 8 * words.size()});
}

TEST(VisibilityChecksum, DependsOnEachBitOfEachWordAndOnTheirOrderAndNumber)
{
    const std::vector<std::uint64_t> words{0, 1, 2, 0, 0};
    std::set<std::uint64_t> sums{checksum_of(words)};
    for (std::size_t k = 0; k < words.size(); ++k)
        for (int bit = 0; bit < 64; ++bit) {
            std::vector<std::uint64_t> changed = words;
            changed[k] ^= std::uint64_t{1} << bit;
            sums.insert(checksum_of(changed));
        }
    sums.insert(checksum_of({1, 0, 2, 0, 0}));
    sums.insert(checksum_of({0, 1, 2, 0}));
    sums.insert(checksum_of({0, 1, 2, 0, 0, 0}));
    sums.insert(checksum_of({}));
    EXPECT_EQ(sums.size(), 1 + 5 * 64 + 4U);
}

TEST(VisibilityChecksum, NeedsWholeWords)
{
    EXPECT_THROW(visibility_checksum("1234567"), DomainError);
    EXPECT_THROW(visibility_checksum("123456789"), DomainError);
}

}  // namespace
}  // namespace endmill
