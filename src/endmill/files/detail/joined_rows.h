// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace endmill {

/// The text of a table with many rows, made by several threads.
/// \param header  text before the rows.
/// \param rows    number of rows.
/// \param rows_of text of `count` consecutive rows from `first` on; called by any thread.
/// \return the header and all rows in order. The rows are divided into runs of at most
///         2048; the division does not depend on the number of threads.
std::string joined_rows(
    std::string header, std::size_t rows,
    const std::function<std::string(std::size_t first, std::size_t count)>& rows_of);

}  // namespace endmill
