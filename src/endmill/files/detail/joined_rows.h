// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace endmill {

/// A text of very many rows: `header`, then what `rows_of(first, count)` gives for runs
/// of rows that follow each other and are at most 2048 long. The runs are the same
/// whatever the number of threads that make them.
std::string joined_rows(
    std::string header, std::size_t rows,
    const std::function<std::string(std::size_t first, std::size_t count)>& rows_of);

}  // namespace endmill
