// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/minimal_cones.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "endmill/setup/detail/least_cones.h"

namespace endmill {
namespace {

/// Cells nearby are closer than this number of cell sizes.
constexpr double steps_of_a_cell = 1.5;

bool is_empty(std::span<const std::uint64_t> column)
{
    return std::ranges::all_of(column, [](std::uint64_t word) { return word == 0; });
}

/// The numbers of the bits that are set, ascending.
std::vector<std::size_t> numbers_of(std::span<const std::uint64_t> column)
{
    std::vector<std::size_t> numbers;
    for (std::size_t word = 0; word < column.size(); ++word)
        for (std::uint64_t rest = column[word]; rest != 0; rest &= rest - 1)
            numbers.push_back(64 * word + std::size_t(std::countr_zero(rest)));
    return numbers;
}

std::vector<std::vector<std::uint32_t>> nearby_cells(const SphereGrid& grid,
                                                     std::span<const std::size_t> cells)
{
    const double cell = std::sqrt(4 * std::numbers::pi / double(grid.centres.size()));
    const double most = steps_of_a_cell * cell;
    std::vector<std::vector<std::uint32_t>> nearby(cells.size());
    for (std::size_t a = 0; a < cells.size(); ++a)
        for (std::size_t b = 0; b < cells.size(); ++b)
            if ((grid.centres[cells[a]] - grid.centres[cells[b]]).squaredNorm() <
                most * most)
                nearby[a].push_back(std::uint32_t(b));
    return nearby;
}

}  // namespace

MinimalCones::MinimalCones(const SphereGrid& grid, const VisibilityMap& map)
    : all_{map},
      least_{least_cones(all_)},
      columns_{all_.map(least_)}
{
    everything_.resize(columns_.words());
    for (std::size_t cone = 0; cone < size(); ++cone)
        everything_[cone / 64] |= std::uint64_t{1} << cone % 64;
    for (std::size_t cell = 0; cell < columns_.cells(); ++cell)
        if (!is_empty(columns_.column(cell)))
            cells_.push_back(cell);
    nearby_ = nearby_cells(grid, cells_);
}

ConeSet MinimalCones::some(std::span<const std::size_t> numbers) const
{
    std::vector<std::size_t> chosen;
    chosen.reserve(numbers.size());
    for (const std::size_t number : numbers)
        chosen.push_back(least_[number]);
    return {all_, chosen, cells_};
}

std::vector<std::size_t> MinimalCones::missed(
    std::span<const std::uint32_t> reached) const
{
    std::vector<std::uint64_t> open = everything_;
    std::vector<char> is_reached(cells_.size(), 0);
    auto reach = [&](std::uint32_t at) {
        if (is_reached[at] != 0)
            return;
        is_reached[at] = 1;
        const auto column = columns_.column(cells_[at]);
        for (std::size_t k = 0; k < open.size(); ++k)
            open[k] &= ~column[k];
    };
    for (const std::uint32_t at : reached)
        reach(at);
    const std::vector<std::uint64_t> missed = open;
    if (is_empty(missed))
        return {};
    for (const std::uint32_t at : reached)
        for (const std::uint32_t next : nearby_[at])
            reach(next);
    return numbers_of(is_empty(open) ? missed : open);
}

}  // namespace endmill
