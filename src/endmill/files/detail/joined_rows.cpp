// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/joined_rows.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "endmill/core/parallel.h"

// Rows are formatted in runs of fixed length, or a run is one text of the caller. The runs of
// a batch are formatted in parallel and passed on in order meanwhile; a batch bounds the
// memory for text that exists twice.

namespace endmill {
namespace {

constexpr std::size_t rows_per_chunk = 512;
constexpr std::size_t chunks_per_batch = 64;  // bounds the text that exists twice
constexpr std::size_t rows_per_batch = rows_per_chunk * chunks_per_batch;

}  // namespace

std::string joined_rows(
    std::string header, std::size_t rows,
    const std::function<std::string(std::size_t first, std::size_t count)>& rows_of)
{
    std::string text = std::move(header);
    std::size_t passed = 0;  // pieces
    pass_rows(rows, rows_of, [&](std::string_view piece) {
        text += piece;
        // Later rows have about the same length; an eighth more is reserved.
        if (++passed == chunks_per_batch)
            text.reserve(text.size() / rows_per_batch * rows / 8 * 9);
    });
    return text;
}

void pass_rows(
    std::size_t rows,
    const std::function<std::string(std::size_t first, std::size_t count)>& rows_of,
    const std::function<void(std::string_view piece)>& sink)
{
    pass_texts((rows + rows_per_chunk - 1) / rows_per_chunk,
               [&](std::size_t i) {
                   const std::size_t first = i * rows_per_chunk;
                   return rows_of(first, std::min(rows_per_chunk, rows - first));
               },
               sink);
}

void pass_texts(std::size_t count,
                const std::function<std::string(std::size_t i)>& text_of,
                const std::function<void(std::string_view text)>& sink)
{
    std::vector<std::string> texts(std::min(count, chunks_per_batch));
    for (std::size_t first = 0; first < count; first += chunks_per_batch)
        parallel_in_order(
            std::min(chunks_per_batch, count - first),
            [&](std::size_t i) { texts[i] = text_of(first + i); },
            [&](std::size_t i) { sink(std::exchange(texts[i], {})); });
}

}  // namespace endmill
