// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/named_cells.h"

#include <algorithm>

#include "endmill/core/error.h"

namespace endmill {

CsvCell word(bool holds)
{
    return holds ? "yes" : "no";
}

void add_named(CsvTable& table, const std::string& row, const NamedCells& cells)
{
    const auto columns = table.columns();
    std::vector<CsvCell> line(columns.size());
    line.front() = row;
    for (const auto& [name, cell] : cells) {
        const auto found = std::ranges::find(columns, name);
        require(found != columns.end(), "add_named: no such column");
        line[static_cast<std::size_t>(found - columns.begin())] = cell;
    }
    table.add_row(line);
}

NamedCells joined(NamedCells one, const NamedCells& other)
{
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

}  // namespace endmill
