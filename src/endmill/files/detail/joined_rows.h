// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace endmill {

/// The text of a table with many rows, made by several threads.
/// \param header  text before the rows.
/// \param rows    number of rows.
/// \param rows_of text of `count` consecutive rows from `first` on; called by any thread.
/// \return the header and all rows in order. The rows are divided into runs of at most
///         512; the division does not depend on the number of threads.
std::string joined_rows(
    std::string header, std::size_t rows,
    const std::function<std::string(std::size_t first, std::size_t count)>& rows_of);

/// The same without a header, for a table that need not fit into memory as text.
/// \param rows    number of rows.
/// \param rows_of text of `count` consecutive rows from `first` on; called by any thread.
/// \param sink    receives the rows in order, piece by piece, one call at a time; called by
///                any thread.
void pass_rows(
    std::size_t rows,
    const std::function<std::string(std::size_t first, std::size_t count)>& rows_of,
    const std::function<void(std::string_view piece)>& sink);

/// Passes texts on in order, which several threads make. About 64 exist at a time.
/// \param count   number of texts.
/// \param text_of text `i`; called by any thread.
/// \param sink    receives the texts in order, one call at a time; called by any thread.
void pass_texts(std::size_t count,
                const std::function<std::string(std::size_t i)>& text_of,
                const std::function<void(std::string_view text)>& sink);

}  // namespace endmill
