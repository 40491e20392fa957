// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/visibility.h"

#include <new>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// 2^45 bytes, more memory than there is: refused before anybody is asked for it.
constexpr std::size_t most_words = std::size_t{1} << 42;

}  // namespace

VisibilityMap::VisibilityMap(std::size_t facets, std::size_t cells)
    : facets_{facets},
      cells_{cells},
      words_{facets / 64 + (facets % 64 != 0 ? 1 : 0)}
{
    const LimitError no_memory{"visibility map: no memory for its bits"};
    if (words_ > 0 && cells_ > most_words / words_)
        throw LimitError{no_memory};
    try {
        bits_.resize(words_ * cells_);
    } catch (const std::bad_alloc&) {
        throw LimitError{no_memory};
    }
}

}  // namespace endmill
