// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/vtk.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <string_view>
#include <vector>

#include "endmill/core/detail/appended_arrays.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/deviation/detail/deviation_cells.h"
#include "endmill/files/read_file.h"

// A part has many more cells than a viewer can show. If there are too many, consecutive
// cells are grouped into runs of equal length and each run is represented by its two
// extreme cells. Averages would hide the deepest gouge, which is what the file is for.

namespace endmill {
namespace {

constexpr std::string_view preamble =
    "<?xml version=\"1.0\"?>\n"
    "<!-- Deviation of a part: points in mm; left_mm along the normal, negative where "
    "too much is gone. -->\n"
    "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
    "header_type=\"UInt64\">\n";

constexpr std::string_view tail = "\n </AppendedData>\n</VTKFile>\n";
constexpr std::string_view count_key = "NumberOfPoints=\"";
constexpr std::size_t count_place = 400;  // the head states the count before this byte

// The arrays of the file in their order.
enum class Array { Point, Left, Normal, Connectivity, Offsets, End };

// Bytes before an array of a file with `count` points. In front of each array stands its size.
std::uint64_t offset_of(Array array, std::uint64_t count)
{
    constexpr std::array<std::uint64_t, 5> bytes_a_point{
        3 * sizeof(float), sizeof(float), 3 * sizeof(float), sizeof(std::int64_t),
        sizeof(std::int64_t)};
    std::uint64_t offset = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(array); ++k)
        offset += sizeof(std::uint64_t) + bytes_a_point.at(k) * count;
    return offset;
}

std::uint64_t array_bytes(std::uint64_t count)
{
    return offset_of(Array::End, count);
}

// The XML in front of the arrays.
std::string head_of(std::uint64_t count)
{
    const auto element = [count](Array array, std::string_view type,
                                 std::string_view name, int components) {
        return "    <DataArray type=\"" + std::string{type} + "\" Name=\"" +
               std::string{name} + "\" NumberOfComponents=\"" +
               std::to_string(components) + "\" format=\"appended\" offset=\"" +
               std::to_string(offset_of(array, count)) + "\"/>\n";
    };
    const std::string points = std::to_string(count);
    return std::string{preamble} + " <PolyData>\n  <Piece " + std::string{count_key} +
           points + "\" NumberOfVerts=\"" + points + "\">\n   <Points>\n" +
           element(Array::Point, "Float32", "point_mm", 3) +
           "   </Points>\n   <PointData Scalars=\"left_mm\" Normals=\"normal\">\n" +
           element(Array::Left, "Float32", "left_mm", 1) +
           element(Array::Normal, "Float32", "normal", 3) +
           "   </PointData>\n   <Verts>\n" +
           element(Array::Connectivity, "Int64", "connectivity", 1) +
           element(Array::Offsets, "Int64", "offsets", 1) +
           "   </Verts>\n  </Piece>\n </PolyData>\n <AppendedData encoding=\"raw\">\n_";
}

// The number of points that the head states; it is not to be trusted yet.
std::uint64_t named_count(std::string_view content, const std::string& file)
{
    constexpr std::uint64_t most = std::uint64_t{1} << 40;
    const std::string_view head = content.substr(0, count_place);
    const std::size_t at = head.find(count_key);
    std::uint64_t count = most;
    if (at != std::string_view::npos) {
        const char* first = head.data() + at + count_key.size();
        std::from_chars(first, head.data() + head.size(), count);
    }
    if (!content.starts_with(preamble) || count >= most)
        throw FormatError{
            "E_VTP", {file, "", "content is no deviation.vtp", "one that endmill wrote"}};
    return count;
}

// `count` numbers behind the size of their array.
std::vector<float> floats_at(std::string_view content, std::size_t at, std::size_t count,
                             const std::string& file)
{
    std::vector<float> numbers(count);
    if (count > 0)
        std::memcpy(numbers.data(), content.data() + at + sizeof(std::uint64_t),
                    count * sizeof(float));
    for (const float number : numbers)
        if (!std::isfinite(number))
            throw FormatError{"E_NONFINITE",
                              {file, "", "a number that is not finite", "numbers of mm"}};
    return numbers;
}

// The cells that become points: all cells with an area if they are at most `most_points`.
// Otherwise the cells are divided into runs of equal length, and each run keeps the cell
// with the least and the cell with the greatest deviation, in the order of the cells.
std::vector<std::size_t> thinned(const Deviation& deviation, std::size_t most_points)
{
    const auto cells = static_cast<std::size_t>(
        std::ranges::count_if(deviation.area, [](float area) { return area > 0; }));
    const std::size_t runs = most_points / 2;
    const std::size_t in_run = cells <= most_points ? 1 : (cells + runs - 1) / runs;
    const std::vector<float>& left = deviation.left;
    std::vector<std::size_t> kept;
    kept.reserve(std::min(cells, most_points));
    std::size_t least = 0;
    std::size_t most = 0;
    std::size_t seen = 0;       // cells of the current run so far
    std::size_t ahead = cells;  // cells with an area that follow
    for (std::size_t i = 0; i < left.size(); ++i) {
        if (!(deviation.area[i] > 0))
            continue;
        const bool is_first = seen == 0;
        least = is_first || left[i] < left[least] ? i : least;
        most = is_first || left[i] >= left[most] ? i : most;
        ++seen;
        --ahead;
        if (seen < in_run && ahead > 0)
            continue;
        seen = 0;
        kept.push_back(std::min(least, most));
        if (least != most)
            kept.push_back(std::max(least, most));
    }
    return kept;
}

// The point data of the file.
struct PointArrays {
    std::vector<float> place;  // three a point, like the normals
    std::vector<float> normal;
    std::vector<float> left;
};

// Stores a vector as three floats.
void store(const Vec3& vector, std::vector<float>& numbers, std::size_t point)
{
    for (int c = 0; c < 3; ++c) {
        const auto number = static_cast<float>(vector[c]);
        require(std::isfinite(number), "deviation_vtp: a number is not finite");
        numbers[3 * point + static_cast<std::size_t>(c)] = number;
    }
}

// The data of the chosen cells. Each thread writes to the places of its own cells.
PointArrays points_of(const PartCharts& charts, const Deviation& deviation,
                      const std::vector<std::size_t>& cells)
{
    PointArrays points;
    points.place.resize(3 * cells.size());
    points.normal.resize(3 * cells.size());
    points.left.resize(cells.size());
    parallel_for(cells.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const PartRay ray = deviation_cell(charts, deviation, cells[i]).ray;
            store(ray.point, points.place, i);
            store(ray.normal, points.normal, i);
            points.left[i] = deviation.left[cells[i]];
        }
    });
    return points;
}

// `count` consecutive numbers from `first` on.
std::vector<std::int64_t> counted_from(std::int64_t first, std::size_t count)
{
    std::vector<std::int64_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), first);
    return numbers;
}

}  // namespace

std::string deviation_vtp(const PartCharts& charts, const Deviation& deviation,
                          std::size_t most_points)
{
    require(most_points >= 2, "deviation_vtp: need most_points >= 2");
    require_whole(deviation);
    const std::vector<std::size_t> cells = thinned(deviation, most_points);
    const PointArrays points = points_of(charts, deviation, cells);

    AppendedArrays arrays;
    arrays.append("point_mm", 3, points.place);
    arrays.append("left_mm", 1, points.left);
    arrays.append("normal", 3, points.normal);
    arrays.append("connectivity", 1, counted_from(0, cells.size()));
    arrays.append("offsets", 1, counted_from(1, cells.size()));
    std::string file = head_of(cells.size());
    file += arrays.bytes();
    file += tail;
    return file;
}

DeviationPoints read_deviation_points(const std::filesystem::path& path,
                                      const ReadLimits& limits)
{
    return parse_deviation_points(read_file(path, limits), shown_path(path), limits);
}

// The file is read only if this library wrote it: its head must be the one that belongs to its
// number of points, and its length the one that follows.
DeviationPoints parse_deviation_points(std::string_view content, const std::string& file,
                                       const ReadLimits& limits)
{
    const std::size_t count = named_count(content, file);
    const std::string head = head_of(count);
    if (!content.starts_with(head))
        throw FormatError{
            "E_VTP",
            {file, "", "another head than that of deviation.vtp", "one of endmill"}};
    const double expected = static_cast<double>(head.size() + tail.size()) +
                            static_cast<double>(array_bytes(count));
    if (static_cast<double>(content.size()) != expected || !content.ends_with(tail))
        throw FormatError{
            "E_VTP_SIZE",
            {file, "",
             "the head says " + std::to_string(count) + " points, the file has " +
                 std::to_string(content.size()) + " bytes",
             to_text(expected) + " bytes"}};
    require_memory(file, 2 * expected, limits);
    DeviationPoints points;
    points.point_mm =
        floats_at(content, head.size() + offset_of(Array::Point, count), 3 * count, file);
    points.left_mm =
        floats_at(content, head.size() + offset_of(Array::Left, count), count, file);
    return points;
}

}  // namespace endmill
