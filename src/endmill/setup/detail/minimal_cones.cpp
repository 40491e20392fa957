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

/// Words of a column that are combined before the words behind them.
constexpr std::size_t words_at_once = 16;

/// Number of passes over some cells. Each takes every sixteenth cell, so that its cells lie
/// far apart and meet most cones; often the words are empty before the last pass.
constexpr std::size_t passes = 16;

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
      minimal_{least_cones(all_)},
      columns_{all_.map(minimal_)}
{
    all_missed_.resize(columns_.words());
    for (std::size_t cone = 0; cone < size(); ++cone)
        all_missed_[cone / 64] |= std::uint64_t{1} << cone % 64;
    for (std::size_t cell = 0; cell < columns_.cells(); ++cell)
        if (!is_empty(columns_.column(cell)))
            cells_.push_back(cell);
    nearby_ = nearby_cells(grid, cells_);
}

ConeSet MinimalCones::selected(std::span<const std::size_t> numbers) const
{
    std::vector<std::size_t> chosen;
    chosen.reserve(numbers.size());
    for (const std::size_t number : numbers)
        chosen.push_back(minimal_[number]);
    return {all_, chosen, cells_};
}

void MinimalCones::clear_met(std::span<std::uint64_t> cones,
                             std::span<const std::uint32_t> cells) const
{
    for (std::size_t first = 0; first < cones.size(); first += words_at_once) {
        const auto part =
            cones.subspan(first, std::min(words_at_once, cones.size() - first));
        for (std::size_t pass = 0; pass < passes; ++pass) {
            if (is_empty(part))
                break;
            for (std::size_t at = pass; at < cells.size(); at += passes) {
                const std::uint64_t* const column =
                    columns_.column(cells_[cells[at]]).data() + first;
                for (std::size_t k = 0; k < part.size(); ++k)
                    part[k] &= ~column[k];
            }
        }
    }
}

std::vector<std::size_t> MinimalCones::missed(
    std::span<const std::uint32_t> reached) const
{
    std::vector<std::uint64_t> missed = all_missed_;
    clear_met(missed, reached);
    if (is_empty(missed))
        return {};
    std::vector<std::uint32_t> around;
    std::vector<char> is_around(cells_.size(), 0);
    for (const std::uint32_t at : reached)
        for (const std::uint32_t next : nearby_[at])
            if (is_around[next] == 0) {
                is_around[next] = 1;
                around.push_back(next);
            }
    std::vector<std::uint64_t> distant = missed;
    clear_met(distant, around);
    return numbers_of(is_empty(distant) ? missed : distant);
}

}  // namespace endmill
