// SPDX-License-Identifier: GPL-3.0-or-later
// Rank 0 sends each other rank the cells, then its share of the facets. The answer is a row of
// bits for each tool axis. Rank 0 combines the rows and sorts the cells of each.

#include "cli/setup_nearest_cells.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/column_messages.h"
#include "cli/program_ranks.h"

namespace endmill {
namespace {

// Every rank sorts all cells at each tool axis, and rank 0 does so twice. Each time takes as
// long as the work for 14 000 facets. With fewer facets on a rank division saves little.
constexpr std::size_t least_facets_of_a_rank = 24'576;

// The number of ranks that take a share; the last ones may have none.
std::size_t shares_of(const VisibilityMap& map)
{
    return std::min(static_cast<std::size_t>(program_ranks().count()),
                    map.facets() / least_facets_of_a_rank);
}

template <typename Value>
std::string_view bytes_of(std::span<const Value> values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

template <typename Value>
std::vector<Value> values_in(std::string_view bytes)
{
    std::vector<Value> values(bytes.size() / sizeof(Value));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(Value));
    return values;
}

void send_share(int rank, const VisibilityMap& share, std::span<const Vec3> centres)
{
    std::vector<double> coordinates;
    coordinates.reserve(3 * centres.size());
    for (const Vec3& centre : centres)
        coordinates.insert(coordinates.end(), {centre.x(), centre.y(), centre.z()});
    program_ranks().send(rank, std::to_string(share.facets()));
    program_ranks().send(rank, bytes_of<double>(coordinates));
    send_columns(rank, share);
}

// Adds the bits that another rank found.
void receive_rows(int rank, std::span<std::uint64_t> rows)
{
    const auto received =
        values_in<std::uint64_t>(program_ranks().receive_from(rank).content);
    std::ranges::transform(rows, received, rows.begin(), std::bit_or<>{});
}

}  // namespace

void divided_nearest_cells(const VisibilityMap& map, std::span<const Vec3> centres,
                           const NearestCellsVisit& visit, ProgressLine& progress)
{
    const std::size_t shares = shares_of(map);
    if (shares < 2) {
        for_each_nearest_cells(map, centres, visit);
        return;
    }
    progress.begin("finding the nearest cells on all ranks");
    for (std::size_t k = 1; k < shares; ++k)
        send_share(static_cast<int>(k), facet_share(map, k, shares), centres);
    std::vector<std::uint64_t> rows =
        nearest_cell_rows(facet_share(map, 0, shares), centres, [&](std::size_t done) {
            progress.show(static_cast<double>(done) /
                          static_cast<double>(centres.size()));
            check_ranks();
        });
    for (std::size_t k = 1; k < shares; ++k)
        receive_rows(static_cast<int>(k), rows);
    progress.begin("searching for a setup");
    for_each_row_of_cells(rows, centres, visit);
}

void serve_nearest_cells()
{
    Ranks& ranks = program_ranks();
    for (;;) {
        const std::size_t facets = std::stoull(ranks.receive_from(0).content);
        const auto coordinates = values_in<double>(ranks.receive_from(0).content);
        std::vector<Vec3> centres;
        for (std::size_t i = 0; i < coordinates.size(); i += 3)
            centres.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
        VisibilityMap share{facets, centres.size()};
        receive_columns(0, share);
        const std::vector<std::uint64_t> rows =
            nearest_cell_rows(share, centres, [](std::size_t) { check_ranks(); });
        ranks.send(0, bytes_of<std::uint64_t>(rows));
    }
}

}  // namespace endmill
