// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged mesh files: a reader returns a valid mesh or throws one of endmill's own
// errors, and its memory is proportional to the size of the file.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <numbers>

#include <gtest/gtest.h>
#include <malloc.h>

#include "endmill/core/error.h"
#include "endmill/core/orientation.h"
#include "endmill/files/mesh_file.h"
#include "endmill/files/part_file.h"
#include "ply_samples.h"
#include "random.h"
#include "temporary_folder.h"
#include "test_meshes.h"

namespace {

// Bytes that are allocated now, and the maximum since the last reset.
std::size_t bytes_in_use = 0;
std::size_t most_bytes_in_use = 0;

void* counted_allocation(std::size_t size)
{
    void* const place = std::malloc(size);
    if (place == nullptr)
        throw std::bad_alloc{};
    bytes_in_use += malloc_usable_size(place);
    most_bytes_in_use = std::max(most_bytes_in_use, bytes_in_use);
    return place;
}

void counted_release(void* place)
{
    bytes_in_use -= place != nullptr ? malloc_usable_size(place) : 0;
    std::free(place);
}

}  // namespace

void* operator new(std::size_t size)
{
    return counted_allocation(size);
}
// The address sanitizer has its own operators, which must not be mixed with these.
void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept
{
    try {
        return counted_allocation(size);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}
void operator delete(void* place) noexcept
{
    counted_release(place);
}
void operator delete(void* place, std::size_t /*size*/) noexcept
{
    counted_release(place);
}

namespace endmill {
namespace {

struct Sample {
    const char* name;
    std::string path;
    std::string content;
};

std::vector<Sample> samples()
{
    const TriangleMesh box = test::box_mesh({0, 0, 0}, {1, 2, 3});
    return {{"StlBinary", "f.stl", mesh_text(box, MeshFormat::Stl)},
            {"StlAscii", "f.stl", mesh_text(box, MeshFormat::StlAscii)},
            {"Obj", "f.obj",
             mesh_text(box, MeshFormat::Obj) + "vt 0 1\nf 1/1 3//-2 4/1/1 2\ng end\n"},
            {"PlyAscii", "f.ply", ascii_ply},
            {"PlyLittleEndian", "f.ply", binary_ply(false)},
            {"PlyBigEndian", "f.ply", binary_ply(true)},
            {"Off", "f.off", mesh_text(box, MeshFormat::Off)}};
}

// A file damaged in one to four places.
std::string damaged(std::string content, test::Random& random)
{
    const auto below = [&](std::size_t count) {
        return static_cast<std::size_t>(random.uniform(0, static_cast<double>(count)));
    };
    constexpr std::string_view inserted = "0123456789-+.eE \n\t#/\0\xff\x7fnaif";
    for (std::size_t rest = 1 + below(4); rest > 0 && !content.empty(); --rest) {
        const std::size_t at = below(content.size());
        const std::size_t length =
            1 + below(std::min<std::size_t>(content.size() - at, 40));
        switch (below(6)) {
            case 0:
                content[at] = static_cast<char>(content[at] ^ (1U << below(8)));
                break;
            case 1:
                content[at] = inserted[below(inserted.size())];
                break;
            case 2:
                content.insert(at, 1, inserted[below(inserted.size())]);
                break;
            case 3:
                content.insert(at, content.substr(at, length));
                break;
            case 4:
                content.erase(at, length);
                break;
            default:
                content.resize(at);
        }
    }
    return content;
}

void expect_sound(const MeshFile& file)
{
    EXPECT_FALSE(file.mesh.triangles().empty());
    for (const Vec3& point : file.mesh.points())
        EXPECT_TRUE(point.allFinite() && point.lpNorm<Eigen::Infinity>() <= 1e6);
    for (std::size_t i = 0; i < file.mesh.triangles().size(); ++i) {
        const auto [a, b, c] = file.mesh.corners(i);
        EXPECT_FALSE(are_collinear(a, b, c));
    }
}

// Peak memory of reading `content`, without the content itself.
std::size_t memory_of_reading(const std::string& content, const std::string& path)
{
    std::string copy = content;
    const std::size_t before = bytes_in_use;
    most_bytes_in_use = before;
    try {
        expect_sound(parse_mesh(std::move(copy), path));
    } catch (const FormatError& error) {
        EXPECT_EQ(std::string{error.what()}.find('\n'), std::string::npos);
    } catch (const LimitError&) {
    }
    return most_bytes_in_use - before;
}

// Allowed memory: the shortest face of a format has a few bytes in the file; its triangle
// and three points take some hundred bytes in memory.
std::size_t memory_bound(std::size_t file_bytes)
{
    return 100 * file_bytes + 100000;
}

class DamagedMesh : public testing::TestWithParam<Sample> {};

TEST_P(DamagedMesh, IsReadCorrectlyOrRefused)
{
    test::Random random{20};
    for (int i = 0; i < 300; ++i) {
        const std::string content = damaged(GetParam().content, random);
        EXPECT_LT(memory_of_reading(content, GetParam().path),
                  memory_bound(content.size()))
            << content;
    }
}

INSTANTIATE_TEST_SUITE_P(OfEveryFormat, DamagedMesh, testing::ValuesIn(samples()),
                         [](const auto& sample) { return sample.param.name; });

TEST(LyingMesh, GetsNoMemoryForFalseCounts)
{
    const std::string points = "property char x\nproperty char y\nproperty char z\n";
    const std::string faces = "\nproperty list uchar int vertex_index\nend_header\n";
    const std::vector<Sample> lies{
        {"", "f.off", "OFF\n2147483647 1 0\n0 0 0\n"},
        {"", "f.off", "OFF\n3 2147483647 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"", "f.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"},
        {"", "f.ply",
         "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\n" + points +
             "element face 1" + faces + "some bytes"},
        {"", "f.ply",
         "ply\nformat ascii 1.0\nelement vertex 1\n" + points +
             "element face 4000000000" + faces + "0 0 0\n"},
        {"", "f.ply",
         "ply\nformat binary_big_endian 1.0\nelement vertex 0\n" + points +
             "element face 1\nproperty list uint int vertex_index\nend_header\n" +
             "\xff\xff\xff\xff" + std::string(16, '\0')},
        {"", "f.stl", std::string(80, ' ') + "\xff\xff\xff\xff" + std::string(50, '\0')}};
    for (const Sample& lie : lies)
        EXPECT_LT(memory_of_reading(lie.content, lie.path), 20000U) << lie.content;
}

// A file whose mesh takes far more memory than the file has bytes.
struct Greedy {
    const char* name;
    std::string path;
    std::string content;
};

TriangleMesh many_tetrahedra()
{
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    for (int k = 0; k < 12'000; k += 4) {
        for (const Vec3& corner :
             {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
            points.emplace_back(corner + Vec3{0, double(k), double(k % 3)});
        for (const Triangle& t : {Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
            triangles.push_back({k + t[0], k + t[1], k + t[2]});
    }
    return {std::move(points), std::move(triangles)};
}

std::string flat_height_grid(int lines)
{
    std::string axis = "[0";
    std::string row = "[0";
    for (int k = 1; k < lines; ++k) {
        axis += "," + std::to_string(k);
        row += ",0";
    }
    std::string rows = row + "]";
    for (int k = 1; k < lines; ++k)
        rows += "," + row + "]";
    return R"({"format":"endmill-surface/1","type":"height-grid","x":)" + axis +
           R"(],"y":)" + axis + R"(],"z":[)" + rows + "]}";
}

std::string ply_of_one_polygon(std::int32_t corners)
{
    const std::string count = std::to_string(corners);
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex " + count +
                       "\nproperty double x\nproperty double y\nproperty double z\n"
                       "element face 1\nproperty list int int vertex_index\nend_header\n";
    for (std::int32_t k = 0; k < corners; ++k) {
        append_number(text, std::cos(2 * std::numbers::pi * k / corners), false);
        append_number(text, std::sin(2 * std::numbers::pi * k / corners), false);
        append_number(text, 0.0, false);
    }
    append_number(text, corners, false);
    for (std::int32_t k = 0; k < corners; ++k)
        append_number(text, k, false);
    return text;
}

class GreedyFile : public testing::TestWithParam<Greedy> {};

TEST_P(GreedyFile, RespectsTheMemoryLimit)
{
    constexpr double bytes_per_gib = 1024.0 * 1024 * 1024;
    const TemporaryFolder folder;
    const auto path = folder.put(GetParam().path, GetParam().content);
    const auto memory_within = [&](double limit) {
        const std::size_t before = bytes_in_use;
        most_bytes_in_use = before;
        read_part(path, {.limits = {.max_memory_gib = limit / bytes_per_gib}});
        return static_cast<double>(most_bytes_in_use - before);
    };
    const double needed = memory_within(bytes_per_gib);
    for (double limit = 0.2 * needed; limit < 0.9 * needed; limit *= 1.05)
        EXPECT_THROW(memory_within(limit), LimitError) << limit << " of " << needed;
    EXPECT_NO_THROW(memory_within(2.5 * needed)) << needed;
}

INSTANTIATE_TEST_SUITE_P(
    OfEveryKind, GreedyFile,
    testing::Values(
        Greedy{"Bodies", "f.off", mesh_text(many_tetrahedra(), MeshFormat::Off)},
        Greedy{"BodiesOfCorners", "f.stl", mesh_text(many_tetrahedra(), MeshFormat::Stl)},
        Greedy{"HeightGrid", "f.json", flat_height_grid(60)},
        Greedy{"Polygon", "f.ply", ply_of_one_polygon(20'000)}),
    [](const auto& sample) { return sample.param.name; });

}  // namespace
}  // namespace endmill
