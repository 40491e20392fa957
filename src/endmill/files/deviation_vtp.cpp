// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/vtk.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string_view>
#include <vector>

#include "endmill/core/detail/appended_arrays.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/deviation/detail/deviation_cells.h"

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
    const std::string count = std::to_string(cells.size());
    std::string file{preamble};
    file += " <PolyData>\n  <Piece NumberOfPoints=\"" + count + "\" NumberOfVerts=\"" +
            count + "\">\n";
    file += "   <Points>\n" + arrays.append("point_mm", 3, points.place);
    file += "   </Points>\n   <PointData Scalars=\"left_mm\" Normals=\"normal\">\n";
    file += arrays.append("left_mm", 1, points.left);
    file += arrays.append("normal", 3, points.normal);
    file += "   </PointData>\n   <Verts>\n";
    file += arrays.append("connectivity", 1, counted_from(0, cells.size()));
    file += arrays.append("offsets", 1, counted_from(1, cells.size()));
    file += "   </Verts>\n  </Piece>\n </PolyData>\n <AppendedData encoding=\"raw\">\n_";
    file += arrays.bytes();
    file += "\n </AppendedData>\n</VTKFile>\n";
    return file;
}

}  // namespace endmill
