// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/finer_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "endmill/stock/detail/removable_path.h"
#include "endmill/stock/height_stock.h"
#include "endmill/verification/detail/part_collisions.h"

namespace endmill {
namespace {

// Cells per cell along a side. It is odd, so that the finer cells include the old
// centres.
constexpr int subdivision = 3;
constexpr int most_subdivisions = 2;
// Limit of the finer cells; a path of 100 000 moves cuts this many in a second or two.
constexpr double most_cells = 1e7;

// The columns and rows from first to last - 1 of a grid.
struct CellRange {
    int first_column;
    int last_column;
    int first_row;
    int last_row;

    bool is_empty() const { return first_column >= last_column || first_row >= last_row; }
};

// A growing rectangle, mm.
struct Extent {
    double low_x = std::numeric_limits<double>::infinity();
    double low_y = std::numeric_limits<double>::infinity();
    double high_x = -std::numeric_limits<double>::infinity();
    double high_y = -std::numeric_limits<double>::infinity();

    void add(const Vec3& place, double reach)
    {
        low_x = std::min(low_x, place.x() - reach);
        low_y = std::min(low_y, place.y() - reach);
        high_x = std::max(high_x, place.x() + reach);
        high_y = std::max(high_y, place.y() + reach);
    }
};

// Whether the move goes straight up. Its volume was swept when the cutter arrived below.
bool rises_where_it_was(const Vec3& from, const Vec3& to)
{
    return to.x() == from.x() && to.y() == from.y() && to.z() >= from.z();
}

// Returns the cells that a rectangle touches.
CellRange cells_under(const Extent& extent, const StockGrid& grid)
{
    const auto cell = [&](double at, double low, int count) {
        return static_cast<int>(
            std::clamp(std::floor((at - low) / grid.pitch), -1.0, double(count)));
    };
    return {std::max(0, cell(extent.low_x, grid.low_x, grid.columns)),
            std::min(grid.columns, cell(extent.high_x, grid.low_x, grid.columns) + 1),
            std::max(0, cell(extent.low_y, grid.low_y, grid.rows)),
            std::min(grid.rows, cell(extent.high_y, grid.low_y, grid.rows) + 1)};
}

// Adds the places where a move of the run may have a forbidden contact below `top`.
void add_doubtful(const ToolRun& task, double top, Extent& extent)
{
    double widest = 0;
    double lowest_end = std::numeric_limits<double>::infinity();
    for (const ToolCylinder& cylinder : task.body)
        if (reaches_out(cylinder, task.cutter)) {
            widest = std::max(widest, cylinder.diameter / 2);
            lowest_end = std::min(lowest_end, cylinder.from);
        }
    const auto& points = task.path.points;
    for (std::size_t k = 1; k < points.size(); ++k) {
        const Vec3& from = points[k - 1].location.tip;
        const Vec3& to = points[k].location.tip;
        const double low = std::min(from.z(), to.z());
        const bool has_swept = k > 1 || cuts_at_start(task.path);
        const bool may_cut = points[k].move == Move::Rapid && low < top &&
                             !(has_swept && rises_where_it_was(from, to));
        const bool may_hit = low + lowest_end < top;
        for (const Vec3& end : {from, to}) {
            if (may_cut)
                extent.add(end, task.cutter.radius());
            if (may_hit)
                extent.add(end, widest);
        }
    }
}

// The runs of all tools.
std::vector<ToolRun> runs_of(const FinerContacts& task)
{
    std::vector<ToolRun> runs{{task.path, task.cutter, task.body}};
    for (const ToolRun& later : task.later)
        runs.push_back(later);
    return runs;
}

// Returns the cells where a move may have a forbidden contact below `top`; nothing if no
// move may.
std::optional<CellRange> doubtful_cells(const FinerContacts& task, const StockGrid& grid,
                                        double top)
{
    Extent extent;
    for (const ToolRun& run : runs_of(task))
        add_doubtful(run, top, extent);
    if (!(extent.low_x <= extent.high_x))
        return std::nullopt;
    const CellRange range = cells_under(extent, grid);
    return range.is_empty() ? std::nullopt : std::optional{range};
}

// Returns the grid of a range of cells, `times` times finer.
StockGrid finer(const StockGrid& grid, const CellRange& range, int times)
{
    return {grid.low_x + range.first_column * grid.pitch,
            grid.low_y + range.first_row * grid.pitch,
            grid.pitch / times,
            (range.last_column - range.first_column) * times,
            (range.last_row - range.first_row) * times,
            grid.bottom_z};
}

// Returns how many times finer the cells may be.
int subdivisions(const StockGrid& grid, double most_bytes)
{
    const Block box{{0, 0, 0}, {grid.columns * grid.pitch, grid.rows * grid.pitch, 0}};
    int times = 1;
    for (int k = 0; k < most_subdivisions; ++k) {
        const double next = double(times) * subdivision;
        if (next * next * grid.columns * grid.rows <= most_cells &&
            required_bytes(box, grid.pitch / next) <= most_bytes)
            times *= subdivision;
    }
    return times;
}

}  // namespace

StockContacts contacts_of(const Removal& removal, const StockGrid& grid, double top,
                          const FinerContacts& task)
{
    const bool is_doubtful = doubtful_cells(task, grid, top).has_value();
    return {removal.rapid_cuts, removal.collisions,
            is_doubtful ? std::numbers::sqrt2 * grid.pitch : 0};
}

StockContacts finer_contacts(const Removal& coarse, const Block& block,
                             const StockGrid& grid, const FinerContacts& task)
{
    StockContacts contacts = contacts_of(coarse, grid, block.high.z(), task);
    const auto range = doubtful_cells(task, grid, block.high.z());
    const bool is_settled = coarse.rapid_cuts.count > 0 || coarse.collisions.count > 0;
    if (!range || is_settled)
        return contacts;
    const int times = subdivisions(finer(grid, *range, 1), task.most_bytes);
    if (times == 1)
        return contacts;
    HeightStock stock{finer(grid, *range, times), block.high.z()};
    const Removal fine = remove_along(stock, runs_of(task));
    return {fine.rapid_cuts, fine.collisions, contacts.width_mm / times};
}

}  // namespace endmill
