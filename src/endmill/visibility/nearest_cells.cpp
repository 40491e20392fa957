// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/visibility/detail/direction_count.h"

// How the nearest cells are found.
//
// 1. The cells are sorted by their distance from the tool axis. Dot products with the axis are
//    spread about evenly over -1 to 1, so that they are distributed to as many classes as there
//    are cells, and only the few of a class are compared.
// 2. The facets are processed in groups of 64, one word of each column. Cells are taken in
//    their order, until each facet of the group has its cell. Facets of a group mostly have
//    similar cones, so that their cells are among the first: on average a
//    twentieth of the cells is looked at for a convex part. A group that the tool axis
//    reaches as a whole costs nothing.
// 3. The words of a group lie far apart in the map. They are copied side by side once for some
//    tool axes, which then find them in the cache.

namespace endmill {
namespace {

// Dot products that differ by less are equal. Their rounding is 1e-16, and dot products
// of different distances differ by 1e-6 or more.
constexpr double equal_dots = 1e-12;

// Words of a column that are copied at once: a cache line.
constexpr std::size_t words_at_once = 8;

// Tool axes that share a copy: a sixteenth of all, within these limits. With more of them fewer
// threads find work, with fewer the copies take a notable share of the time.
constexpr std::size_t least_together = 64;
constexpr std::size_t most_together = 256;

struct NearCell {
    double dot;  // of the centre and the tool axis
    std::uint32_t cell;
};

std::size_t class_of(double dot, std::size_t classes)
{
    const double place = (1 - dot) * (static_cast<double>(classes) / 2);
    return place <= 0 ? 0 : std::min(static_cast<std::size_t>(place), classes - 1);
}

// Sorted by dot product, the largest first, then by number.
std::vector<NearCell> by_dot(std::span<const Vec3> centres, const Vec3& axis)
{
    const std::size_t classes = centres.size();
    std::vector<double> dots(centres.size());
    std::vector<std::uint32_t> next(classes + 1);
    for (std::size_t i = 0; i < centres.size(); ++i) {
        dots[i] = axis.dot(centres[i]);
        ++next[class_of(dots[i], classes) + 1];
    }
    for (std::size_t i = 0; i < classes; ++i)
        next[i + 1] += next[i];
    std::vector<NearCell> cells(centres.size());
    for (std::size_t i = 0; i < centres.size(); ++i)
        cells[next[class_of(dots[i], classes)]++] = {dots[i],
                                                     static_cast<std::uint32_t>(i)};
    auto begin = cells.begin();
    for (std::size_t i = 0; i < classes; ++i) {
        const auto end = cells.begin() + next[i];
        std::sort(begin, end, [](const NearCell& a, const NearCell& b) {
            return a.dot != b.dot ? a.dot > b.dot : a.cell < b.cell;
        });
        begin = end;
    }
    return cells;
}

// All cells, the nearest to the axis first. Of cells that are equally near, each as its
// predecessor, the lowest comes first.
std::vector<std::uint32_t> cells_by_nearness(std::span<const Vec3> centres,
                                             const Vec3& axis)
{
    const std::vector<NearCell> near = by_dot(centres, axis);
    std::vector<std::uint32_t> cells(near.size());
    std::size_t begin = 0;
    for (std::size_t i = 0; i < near.size(); ++i) {
        cells[i] = near[i].cell;
        if (i + 1 < near.size() && near[i].dot - near[i + 1].dot <= equal_dots)
            continue;
        std::sort(cells.begin() + static_cast<std::ptrdiff_t>(begin),
                  cells.begin() + static_cast<std::ptrdiff_t>(i + 1));
        begin = i + 1;
    }
    return cells;
}

// A group of 64 facets: a bit for each of them, by cell.
struct FacetGroup {
    std::vector<std::uint64_t> columns;
    std::uint64_t reached = 0;  // the facets that some cell reaches
};

// The groups of the words from `first` on.
std::vector<FacetGroup> facet_groups(const VisibilityMap& map, std::size_t first)
{
    std::vector<FacetGroup> groups(std::min(words_at_once, map.words() - first));
    for (FacetGroup& group : groups)
        group.columns.resize(map.cells());
    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        const std::span<const std::uint64_t> column = map.column(cell);
        for (std::size_t i = 0; i < groups.size(); ++i) {
            groups[i].columns[cell] = column[first + i];
            groups[i].reached |= column[first + i];
        }
    }
    return groups;
}

// The cells at one tool axis: all by nearness, and those found to be the nearest of a facet.
class CellsAtPose {
public:
    CellsAtPose(std::span<const Vec3> centres, std::size_t pose)
        : pose_{pose},
          cells_{cells_by_nearness(centres, centres[pose])},
          is_found_(cells_.size())
    {
    }

    void take(const FacetGroup& group)
    {
        const std::uint64_t* columns = group.columns.data();
        std::uint64_t wanted = group.reached & ~columns[pose_];
        for (const std::uint32_t* cell = cells_.data(); wanted != 0; ++cell) {
            while ((columns[*cell] & wanted) == 0)
                ++cell;
            is_found_[static_cast<std::size_t>(cell - cells_.data())] = 1;
            wanted &= ~columns[*cell];
        }
    }

    std::vector<std::uint32_t> found() const
    {
        std::vector<std::uint32_t> found;
        for (std::size_t place = 0; place < cells_.size(); ++place) {
            if (is_found_[place] != 0)
                found.push_back(cells_[place]);
        }
        return found;
    }

private:
    std::size_t pose_;
    std::vector<std::uint32_t> cells_;
    std::vector<char> is_found_;  // in the order of cells_
};

// Nearest cells at the tool axes from `begin` to `end`.
std::vector<CellsAtPose> cells_at_poses(const VisibilityMap& map,
                                        std::span<const Vec3> centres, std::size_t begin,
                                        std::size_t end)
{
    std::vector<CellsAtPose> poses;
    poses.reserve(end - begin);
    for (std::size_t pose = begin; pose < end; ++pose)
        poses.emplace_back(centres, pose);
    for (std::size_t first = 0; first < map.words(); first += words_at_once) {
        for (const FacetGroup& group : facet_groups(map, first)) {
            for (CellsAtPose& pose : poses)
                pose.take(group);
        }
    }
    return poses;
}

// Words of a row of bits over the cells.
std::size_t row_words(std::span<const Vec3> centres)
{
    return (centres.size() + 63) / 64;
}

}  // namespace

std::vector<std::uint32_t> nearest_cells(const VisibilityMap& map,
                                         std::span<const Vec3> centres, std::size_t pose)
{
    require(centres.size() == map.cells() && pose < map.cells(),
            "nearest_cells: need a centre for each cell, and a pose that is a cell");
    return cells_at_poses(map, centres, pose, pose + 1).front().found();
}

void for_each_nearest_cells(const VisibilityMap& map, std::span<const Vec3> centres,
                            const NearestCellsVisit& visit)
{
    require(centres.size() == map.cells(),
            "for_each_nearest_cells: need a centre for each cell");
    const std::size_t together =
        std::clamp(centres.size() / 16, least_together, most_together);
    const std::size_t parts = (centres.size() + together - 1) / together;
    parallel_for(parts, [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end; ++part) {
            const std::size_t first = part * together;
            const std::size_t last = std::min(first + together, centres.size());
            const std::vector<CellsAtPose> poses =
                cells_at_poses(map, centres, first, last);
            for (std::size_t pose = first; pose < last; ++pose)
                visit(pose, poses[pose - first].found());
        }
    });
}

VisibilityMap facet_share(const VisibilityMap& map, std::size_t first, std::size_t step)
{
    require(step > 0, "facet_share: need a step above 0");
    std::size_t facets = 0;
    for (std::size_t word = first; word < map.words(); word += step)
        facets += std::min<std::size_t>(64, map.facets() - 64 * word);
    VisibilityMap share{facets, map.cells()};
    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        const std::span<const std::uint64_t> column = map.column(cell);
        const std::span<std::uint64_t> kept = share.column(cell);
        for (std::size_t i = 0; i < kept.size(); ++i)
            kept[i] = column[first + i * step];
    }
    return share;
}

std::vector<std::uint64_t> nearest_cell_rows(
    const VisibilityMap& map, std::span<const Vec3> centres,
    const std::function<void(std::size_t done)>& progress)
{
    const std::size_t words = row_words(centres);
    std::vector<std::uint64_t> rows(centres.size() * words);
    DirectionCount finished{progress};
    for_each_nearest_cells(map, centres, [&](std::size_t pose, const auto& cells) {
        for (const std::uint32_t cell : cells)
            rows[pose * words + cell / 64] |= std::uint64_t{1} << cell % 64;
        finished.one_more();
    });
    return rows;
}

void for_each_row_of_cells(std::span<const std::uint64_t> rows,
                           std::span<const Vec3> centres, const NearestCellsVisit& visit)
{
    const std::size_t words = row_words(centres);
    require(rows.size() == centres.size() * words,
            "for_each_row_of_cells: need a row for each cell");
    parallel_for(centres.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t pose = begin; pose < end; ++pose) {
            const std::span<const std::uint64_t> row = rows.subspan(pose * words, words);
            std::vector<std::uint32_t> cells = cells_by_nearness(centres, centres[pose]);
            std::erase_if(cells, [row](std::uint32_t cell) {
                return (row[cell / 64] >> cell % 64 & 1) == 0;
            });
            visit(pose, std::move(cells));
        }
    });
}

}  // namespace endmill
