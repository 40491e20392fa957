// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/accessibility/visibility_map.h"

#include <new>
#include <stdexcept>

#include "endmill/core/error.h"

namespace endmill {

VisibilityMap::VisibilityMap(std::size_t facets, std::size_t cells)
    : facets_{facets},
      cells_{cells},
      words_{(facets + 63) / 64}
{
    try {
        bits_.resize(words_ * cells_);
    } catch (const std::bad_alloc&) {
        throw LimitError{"visibility map: no memory for its bits"};
    } catch (const std::length_error&) {
        throw LimitError{"visibility map: no memory for its bits"};
    }
}

}  // namespace endmill
