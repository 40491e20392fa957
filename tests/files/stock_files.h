// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "endmill/files/vtk.h"
#include "random.h"

// A stock, and access to the numbers in its files.
namespace endmill::test {

inline HeightStock rough_stock()
{
    HeightStock stock = block_stock({{-1.1, 0.3, -2.7}, {2.35, 4.8, 1}}, 0.3);
    Random random{1};
    for (int row = 0; row < stock.grid().rows; ++row)
        for (int column = 0; column < stock.grid().columns; ++column)
            stock.set_height(column, row, random.uniform(-3, 9));
    return stock;
}

// Position in the file of the array with this offset, after its size.
inline std::size_t array_at(const std::string& file, std::size_t offset)
{
    const std::string opening = "<AppendedData encoding=\"raw\">\n_";
    return file.find(opening) + opening.size() + offset + sizeof(std::uint64_t);
}

inline double number_at(const std::string& file, std::size_t at)
{
    double value = 0;
    std::memcpy(&value, file.data() + at, sizeof value);
    return value;
}

inline std::string with_number_at(std::string file, std::size_t at, double value)
{
    std::memcpy(file.data() + at, &value, sizeof value);
    return file;
}

}  // namespace endmill::test
