// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/result_csv.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/deviation/detail/deviation_cells.h"
#include "endmill/files/csv.h"

// The histogram adds the areas of the cells. Floating-point sums depend on the order of
// the terms, so the cells are divided into blocks of fixed size; each block has a
// histogram of its own, and the histograms are added in the order of the blocks. The
// result is the same with any number of threads.

namespace endmill {
namespace {

// 200 bins from -2 tolerances to 2 scallop limits: each has a hundredth of the sum of
// both.
constexpr std::size_t bins = 200;

// Cells of a block. A block is large compared with the histogram that it needs.
constexpr std::size_t cells_a_block = 65536;

// Area of the part for each bin of the deviation.
struct Histogram {
    std::array<double, bins + 1> edges;
    std::array<double, bins> areas{};
    double least = std::numeric_limits<double>::infinity();
    double greatest = -std::numeric_limits<double>::infinity();

    // The edges divide the range from -2 tolerances to 2 scallop limits into equal parts.
    explicit Histogram(const DeviationLimits& limits)
    {
        for (std::size_t k = 0; k <= bins; ++k) {
            const double share = static_cast<double>(k) / bins;
            edges[k] = 2 * (share * limits.scallop - (1 - share) * limits.tolerance);
        }
    }

    // The bin of a value. A value on an edge belongs to the upper bin.
    std::size_t bin_of(double left) const
    {
        // Bins are equally wide except for rounding, so the estimate is corrected by the
        // edges. Values outside belong to the first or last bin.
        const double share = (left - edges.front()) / (edges.back() - edges.front());
        auto bin = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * (bins - 1));
        while (bin > 0 && left < edges[bin])
            --bin;
        while (bin < bins - 1 && left >= edges[bin + 1])
            ++bin;
        return bin;
    }

    // Adds a cell.
    void add(double left, double area)
    {
        areas[bin_of(left)] += area;
        least = std::min(least, left);
        greatest = std::max(greatest, left);
    }

    // Adds the cells of another histogram with the same edges.
    void add(const Histogram& other)
    {
        for (std::size_t k = 0; k < bins; ++k)
            areas[k] += other.areas[k];
        least = std::min(least, other.least);
        greatest = std::max(greatest, other.greatest);
    }
};

// The histogram of all cells. Blocks have a fixed number of cells and are added in order,
// so the sums do not depend on the number of threads.
Histogram histogram_of(const Deviation& deviation, const DeviationLimits& limits)
{
    const std::size_t cells = deviation.left.size();
    std::vector<Histogram> blocks((cells + cells_a_block - 1) / cells_a_block,
                                  Histogram{limits});
    parallel_for(blocks.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block) {
            const std::size_t last = std::min(cells, (block + 1) * cells_a_block);
            for (std::size_t i = block * cells_a_block; i < last; ++i)
                if (deviation.area[i] > 0)
                    blocks[block].add(deviation.left[i], deviation.area[i]);
        }
    });
    Histogram whole{limits};
    for (const Histogram& block : blocks)
        whole.add(block);
    return whole;
}

}  // namespace

std::string deviation_histogram_csv(const Deviation& deviation,
                                    const DeviationLimits& limits)
{
    require(std::isfinite(limits.tolerance) && limits.tolerance > 0 &&
                std::isfinite(limits.scallop) && limits.scallop > 0,
            "deviation_histogram_csv: need limits that are finite and positive");
    require_whole(deviation);
    const Histogram histogram = histogram_of(deviation, limits);

    CsvTable table{{"from_mm", "to_mm", "area_mm2"}};
    if (!(histogram.least <= histogram.greatest))
        return table.text();
    const std::size_t first = histogram.bin_of(histogram.least);
    const std::size_t last = histogram.bin_of(histogram.greatest);
    for (std::size_t k = first; k <= last; ++k)
        table.add_row({k == first ? histogram.least : histogram.edges[k],
                       k == last ? histogram.greatest : histogram.edges[k + 1],
                       histogram.areas[k]});
    return table.text();
}

}  // namespace endmill
